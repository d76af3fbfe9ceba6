#include "common/tree/octree.hpp"

namespace spoctree {

void Level::append(NodeKind kind, std::span<const std::uint32_t> planes,
                   std::span<const std::uint32_t> expression) {
  kinds.push_back(kind);
  first_child.push_back(kind == NodeKind::Grey ? 8 * grey_count++ : 0);
  references.insert(references.end(), planes.begin(), planes.end());
  reference_begin.push_back(static_cast<std::uint32_t>(references.size()));
  tokens.insert(tokens.end(), expression.begin(), expression.end());
  token_begin.push_back(static_cast<std::uint32_t>(tokens.size()));
}

std::array<std::uint32_t, kNodeKindCount> Level::count_kinds() const {
  std::array<std::uint32_t, kNodeKindCount> counts{};
  for (const NodeKind kind : kinds) ++counts[static_cast<std::size_t>(kind)];
  return counts;
}

}  // namespace spoctree
