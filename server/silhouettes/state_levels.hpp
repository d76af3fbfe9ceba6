// A tree of cubes -> what is certain about each of its levels.
#pragma once

#include "common/tree/octree.hpp"

namespace spoctree {

/// Fills the statement of every level of a complete tree without planes, whose WHITE and BLACK
/// leaves are all that is known of a solid: the solid of which the statements speak is the last
/// level itself, the union of its BLACK cubes. (Of silhouettes, that is the region which projects
/// into all of them, as far as pixels can tell. Of the object that was seen, masks say nothing
/// certain: it may be smaller in any place, and larger by parts of pixels.)
///
/// Volumes and areas: measure_cubes. A level's error bound: within each GREY cube, every part goes
/// to the nearest part that holds material, and then on as far as needed there. O(nodes).
void state_levels_of_cubes(Octree& tree);

}  // namespace spoctree
