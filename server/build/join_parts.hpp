// Parts of a tree -> the tree, breadth-first.
#pragma once

#include <memory>
#include <vector>

#include "server/build/build_octree.hpp"
#include "server/build/subtree_builder.hpp"

namespace spoctree {

/// A node of the tree with all that is below it: its own level and the next few as parts, and what
/// is below those in branches.
struct Branch {
  std::vector<LevelPart> parts;
  /// For each node below the last part, in order; none if all of that part's nodes are leaves.
  std::vector<std::unique_ptr<Branch>> branches;
};

/// The tree's nodes in their order, with the solid's planes. Frees the parts as it goes: little
/// more memory than the tree or its parts alone.
BuiltOctree join_parts(Branch& root);

}  // namespace spoctree
