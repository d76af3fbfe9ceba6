// Silhouettes -> the octree of what may be where all of them show the object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/tree/octree.hpp"
#include "server/silhouettes/mask.hpp"
#include "server/silhouettes/view_tree.hpp"

namespace spoctree {

/// The trees of all stages may have so many nodes together, and so many may be worked on at a time.
/// Objects in masks of 1024 x 1024 need a tenth of it at most; noise needs more than there is.
inline constexpr std::int64_t kMostSilhouetteNodes = 40'000'000;
inline constexpr std::int64_t kMostColouredNodes = 16'000'000;

/// What one view shows.
struct Silhouette {
  std::size_t view = 0;  ///< index in all_views()
  Mask mask;
};

struct SilhouetteOptions {
  SilhouetteRules rules;
  /// Silhouettes are grown by one pixel first.
  bool grow = false;
  /// After so many silhouettes a tree is wanted, in increasing order, none beyond their number;
  /// empty: after all of them.
  std::vector<std::size_t> stages;
};

/// The trees of the stages (WHITE, BLACK and GREY nodes only; siblings of one colour merged): one
/// tree per silhouette, intersected a pair at a time in the order given. In parallel; the same
/// trees for any number of threads. The levels' statements are not filled: see state_levels.hpp.
/// O(pixels, and nodes of all trees on the way).
/// Throws BadInput (without a file's name) for trees beyond the limits above.
/// REQUIRES: at least one silhouette, no view twice; masks with pixels, no side longer than
/// kMostMaskPixels; a valid universe; 0 <= max_depth <= kMostSilhouetteDepth.
std::vector<Octree> build_from_silhouettes(const Universe& universe,
                                           std::span<const Silhouette> silhouettes,
                                           const SilhouetteOptions& options);

/// The volumes of the stages' trees as fractions of the universe cube, without the trees.
std::vector<double> volumes_from_silhouettes(std::span<const Silhouette> silhouettes,
                                             const SilhouetteOptions& options);

/// The depth at which a cell is a pixel of the face views, or of all views if there is no face
/// view; at most kMostSilhouetteDepth.
int depth_of_pixels(std::span<const Silhouette> silhouettes);

}  // namespace spoctree
