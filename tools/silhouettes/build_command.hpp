// The command `build`: masks -> the octree of what they show -> a .spo file.
#pragma once

#include <string>
#include <vector>

#include "server/silhouettes/view_tree.hpp"

namespace spoctree {

struct SilhouetteBuildArguments {
  std::vector<std::string> masks;  ///< folders and files
  std::string output;
  std::string cube;    ///< empty: that of a cube.txt, else side 2 around the origin
  std::string views;   ///< empty: all there are
  std::string order;   ///< empty: faces, edges, corners
  int max_depth = -1;  ///< -1: a cell is a pixel of the face views
  double black_fraction = SilhouetteRules{}.black_fraction;
  double corner_fraction = SilhouetteRules{}.corner_fraction;
  bool grow = false;
  bool stages = false;  ///< also a file after the views of each kind
};

/// Throws UsageError for views that contradict each other, BadInput for masks that are missing or
/// are none and for outputs that cannot be written.
void run_silhouette_build(const SilhouetteBuildArguments& arguments);

}  // namespace spoctree
