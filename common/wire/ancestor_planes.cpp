#include "common/wire/ancestor_planes.hpp"

namespace spoctree {

void AncestorPlanes::begin_level(const Octree& tree) {
  if (tree.levels.empty()) return;
  const Level& parents = tree.levels.back();
  auto& greys = greys_.emplace_back();
  for (std::uint32_t node = 0; node < parents.size(); ++node) {
    if (parents.kinds[node] == NodeKind::Grey) greys.push_back(node);
  }
  path_.push_back(kNone);
}

void AncestorPlanes::move_to(const Octree& tree, std::uint32_t node) {
  if (node % 8 != 0) return;  // the same parent as the node before
  // From the parent up to where the new path meets the old one.
  std::size_t top = path_.size();
  for (std::uint32_t entry = node; top > 0; --top) {
    const std::uint32_t ancestor = greys_[top - 1][entry / 8];
    if (path_[top - 1] == ancestor) break;
    if (path_[top - 1] != kNone) {
      for (const std::uint32_t plane : tree.levels[top - 1].planes_of(path_[top - 1])) {
        marked_[plane] = false;
      }
    }
    path_[top - 1] = entry = ancestor;
  }
  for (std::size_t depth = top; depth < path_.size(); ++depth) {
    for (const std::uint32_t plane : tree.levels[depth].planes_of(path_[depth])) {
      mark(plane);
    }
  }
}

bool AncestorPlanes::mark(std::uint32_t plane) {
  if (plane >= marked_.size()) marked_.resize(plane + 1, false);
  if (marked_[plane]) return false;
  marked_[plane] = true;
  return true;
}

}  // namespace spoctree
