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
};

/// Deeper trees are not made: this one has cells as small as the pixels of masks of 1024 x 1024,
/// and of larger masks several pixels fall on a cell (black_fraction).
inline constexpr int kMostSilhouetteDepth = 10;

/// The tree of one view, in `pool`. A mask whose size is no power of two is resampled to one that
/// is not smaller (mask.hpp). O(pixels, and cells in the picture).
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
inline const ColouredNode* colour_of_mixed(double black, double all, const SilhouetteRules& rules) {
  return black > 0 && black >= rules.black_fraction * all ? kBlack : kWhite;
}

}  // namespace spoctree
