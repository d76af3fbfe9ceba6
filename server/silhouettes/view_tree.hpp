// One silhouette -> the octree of the region of space that projects onto it (Ahuja and Veenstra,
// PAMI 1989, sections II-A to II-C).
//
// No cell is projected: which squares or triangles of the picture belong to which octants is a
// table, the same for every level.
#pragma once

#include "server/silhouettes/coloured_node.hpp"
#include "server/silhouettes/mask.hpp"
#include "server/silhouettes/views.hpp"

namespace spoctree {

struct SilhouetteRules {
  /// Cells at this depth are leaves. At most kMostSilhouetteDepth.
  int max_depth = 7;
  /// A cell at the last depth is black if at least this share of its pixels is, and one at all
  /// (section III-F).
  double black_fraction = 0.25;
  /// The same for the hexagons of corner views, whose border never follows that of pixels: the
  /// share of a hexagon's area that has to be black.
  double corner_fraction = 0.25;
};

/// Deeper trees are not made: this one has cells as small as the pixels of masks of 1024 x 1024,
/// and of larger masks several pixels fall on a cell (black_fraction).
inline constexpr int kMostSilhouetteDepth = 10;

/// The depth at which a cell is as large as a pixel: with a mask of N pixels, log2 N rounded up,
/// where N is the larger side of a face view's mask, and the height of others: an edge view may be
/// wider, as the cube's silhouette is, and is compressed to a square; so is a corner view's.
int depth_of_pixels(const View& view, const Mask& mask);

/// The tree of one view, in `pool`. A face or edge view's mask is resampled to the square with a
/// pixel for each cell at depth_of_pixels (mask.hpp). O(pixels, and cells in the picture). Throws
/// BadInput at the pool's limit.
/// REQUIRES: a mask with pixels, no side longer than kMostMaskPixels.
const ColouredNode* build_view_tree(const View& view, const Mask& mask,
                                    const SilhouetteRules& rules, NodePool& pool);

/// The three kinds. `square` has 2^bits by 2^bits pixels, bits >= rules.max_depth.
const ColouredNode* build_face_tree(const View& view, const Mask& square,
                                    const SilhouetteRules& rules, NodePool& pool);
const ColouredNode* build_edge_tree(const View& view, const Mask& square,
                                    const SilhouetteRules& rules, NodePool& pool);
/// The mask of a corner view is looked up at points, whatever its size.
const ColouredNode* build_corner_tree(const View& view, const Mask& mask,
                                      const SilhouetteRules& rules, NodePool& pool);

/// What a cell that cannot be divided becomes: `black` of its `all` pixels (or other parts of equal
/// size) are black.
inline const ColouredNode* colour_of_mixed(double black, double all, double fraction) {
  return black > 0 && black >= fraction * all ? kBlack : kWhite;
}

}  // namespace spoctree
