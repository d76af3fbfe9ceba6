// Creases that their own material does not hide -> the parts of them that nothing else hides.
#pragma once

#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/line_scene.hpp"

namespace spoctree {

/// Walks the tree from front to back. The tree, its leaves' expressions and the planes that bound
/// their pieces are one binary space partition; each part of a crease is looked at when the walk
/// comes to the first of its cells that the part touches, against the outlines of the pieces that
/// came before, and of nothing else. No depth is compared. Where a part lies in a plane of the
/// partition (or nearer to it than kCreaseTolerance), that is the cell on the viewer's side: so
/// what comes before never touches the part, and outlines may cover their borders, too. What is
/// left out for lying exactly behind a border lies, in the picture, on a nearer line.
///
/// `is_wanted` says of each crease whether it counts. Within `frame`; the parts may overlap. Time
/// about linear in the nodes, pieces and creases that are not behind what covers the picture.
/// Throws BadInput as CoveredPicture::cover does, or what `progress` throws.
std::vector<CreasePart> find_seen_parts(const LineScene& scene, const std::vector<bool>& is_wanted,
                                        const Camera& camera, const Rectangle& frame,
                                        const ProgressShare& progress = {});

}  // namespace spoctree
