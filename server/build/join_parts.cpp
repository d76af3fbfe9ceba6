#include "server/build/join_parts.hpp"

#include <utility>

namespace spoctree {

namespace {

/// The parts of every level, in breadth-first order.
std::vector<std::vector<LevelPart*>> parts_by_level(Branch& root) {
  struct Open {
    Branch* branch;
    std::size_t next_part;
  };
  std::vector<std::vector<LevelPart*>> levels;
  for (std::vector<Open> open = {{&root, 0}}; !open.empty();) {
    std::vector<LevelPart*>& level = levels.emplace_back();
    std::vector<Open> next;
    for (const auto& [branch, part] : open) {
      level.push_back(&branch->parts[part]);
      if (part + 1 < branch->parts.size()) {
        next.push_back({branch, part + 1});
      } else {
        for (const auto& below : branch->branches) next.push_back({below.get(), 0});
      }
    }
    open = std::move(next);
  }
  return levels;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Offsets as in Level, of which the first is 0: those of `from` go on where `to` ends.
void append_offsets(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from) {
  const std::uint32_t base = to.back();
  for (std::size_t i = 1; i < from.size(); ++i) to.push_back(base + from[i]);
}

LevelPart join_level(const std::vector<LevelPart*>& parts) {
  LevelPart whole;
  Level& level = whole.nodes;
  std::size_t nodes = 0;
  std::size_t references = 0;
  std::size_t tokens = 0;
  std::size_t greys = 0;
  for (const LevelPart* part : parts) {
    nodes += part->nodes.size();
    references += part->nodes.references.size();
    tokens += part->nodes.tokens.size();
    greys += part->nodes.grey_count;
  }
  level.kinds.reserve(nodes);
  level.first_child.reserve(nodes);
  level.reference_begin.reserve(nodes + 1);
  level.references.reserve(references);
  level.token_begin.reserve(nodes + 1);
  level.tokens.reserve(tokens);
  whole.witnesses.reserve(greys);
  for (LevelPart* pointer : parts) {
    const LevelPart part = std::exchange(*pointer, {});
    for (const PartialCell& cell : part.partial_cells) {
      whole.partial_cells.push_back({level.size() + cell.node, cell.witness});
    }
    append(level.kinds, part.nodes.kinds);
    for (std::uint32_t node = 0; node < part.nodes.size(); ++node) {
      const bool is_grey = part.nodes.kinds[node] == NodeKind::Grey;
      level.first_child.push_back(is_grey ? 8 * level.grey_count + part.nodes.first_child[node]
                                          : 0);
    }
    level.grey_count += part.nodes.grey_count;
    append_offsets(level.reference_begin, part.nodes.reference_begin);
    append(level.references, part.nodes.references);
    append_offsets(level.token_begin, part.nodes.token_begin);
    append(level.tokens, part.nodes.tokens);
    append(whole.witnesses, part.witnesses);
    whole.leaf_volume.add(part.leaf_volume);
    whole.leaf_area.add(part.leaf_area);
    whole.depth_limited_nodes += part.depth_limited_nodes;
  }
  return whole;
}

}  // namespace

BuiltOctree join_parts(Branch& root) {
  BuiltOctree built;
  for (const auto& parts : parts_by_level(root)) {
    LevelPart whole = join_level(parts);
    built.tree.levels.push_back(std::move(whole.nodes));
    built.witnesses.push_back(std::move(whole.witnesses));
    built.partial_cells.push_back(std::move(whole.partial_cells));
    built.leaf_volumes.push_back(whole.leaf_volume.value());
    built.leaf_areas.push_back(whole.leaf_area.value());
    built.depth_limited_nodes += whole.depth_limited_nodes;
  }
  return built;
}

}  // namespace spoctree
