// A classical tree as the cells were decided -> with siblings of one colour merged.
#pragma once

#include "server/build/build_octree.hpp"

namespace spoctree {

/// merge_siblings (common/tree), with what the builder knows of the nodes: a GREY node that becomes
/// a leaf is a partial cell. Throws BadInput if all of the tree becomes WHITE. O(nodes).
void merge_siblings(BuiltOctree& built);

}  // namespace spoctree
