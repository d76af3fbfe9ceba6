// Drawn pictures -> what a user should be told of those that may not be what was meant.
#pragma once

#include <string>
#include <vector>

#include "client/commands/draw_formats.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// A sentence for each picture without a visible line that says why: an eye inside the solid, or in
/// a cell that is full only until later levels, sees nothing; and for each eye exactly on the
/// surface. `leaves_creases_out`: some may be missing that --crease-angle 0 draws. Each sentence
/// once. REQUIRES: `tree` has the level that was drawn.
std::vector<std::string> warnings_of(const LevelPictures& level, const Octree& tree,
                                     bool leaves_creases_out);

}  // namespace spoctree
