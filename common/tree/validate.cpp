#include "common/tree/validate.hpp"

#include <algorithm>
#include <cmath>

namespace spoctree {

namespace {

/// Collects lines up to a limit.
class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}
  void add(std::string line) {
    if (!full()) lines_.push_back(std::move(line));
  }
  bool full() const { return lines_.size() >= limit_; }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::size_t limit_;
  std::vector<std::string> lines_;
};

std::string at(std::size_t level, std::size_t node) {
  return "level " + std::to_string(level) + " node " + std::to_string(node) + ": ";
}

bool columns_match(const Level& level) {
  const auto offsets_match = [&](const std::vector<std::uint32_t>& begin, std::size_t total) {
    return begin.size() == level.kinds.size() + 1 && begin.front() == 0 && begin.back() == total &&
           std::is_sorted(begin.begin(), begin.end());
  };
  return level.first_child.size() == level.kinds.size() &&
         offsets_match(level.reference_begin, level.references.size()) &&
         offsets_match(level.token_begin, level.tokens.size());
}

/// The planes of a node's ancestors, kept as a mark per plane while the tree is walked.
class AncestorCheck {
 public:
  AncestorCheck(const Octree& tree, Findings& findings)
      : tree_(tree), findings_(findings), marked_(tree.planes.size(), false) {}

  void visit(std::size_t depth, std::uint32_t node) {
    if (findings_.full()) return;
    const Level& level = tree_.levels[depth];
    const auto planes = level.planes_of(node);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (marked_[planes[i]]) {
        findings_.add(at(depth, node) + "plane " + std::to_string(planes[i]) +
                      " is repeated from the node or an ancestor");
        for (std::size_t k = 0; k < i; ++k) marked_[planes[k]] = false;
        return;
      }
      marked_[planes[i]] = true;
    }
    if (level.kinds[node] == NodeKind::Grey && depth + 1 < tree_.levels.size()) {
      for (std::uint32_t octant = 0; octant < 8; ++octant) {
        visit(depth + 1, level.first_child[node] + octant);
      }
    }
    for (const std::uint32_t plane : planes) marked_[plane] = false;
  }

 private:
  const Octree& tree_;
  Findings& findings_;
  std::vector<bool> marked_;
};

}  // namespace

bool is_valid(const LevelStatement& statement) {
  const auto is_size = [](double value) { return std::isfinite(value) && value >= 0; };
  const auto is_range = [&](double inner, double outer) {
    return is_size(inner) && is_size(outer) && inner <= outer;
  };
  return is_size(statement.error_bound) &&
         is_range(statement.inner_volume, statement.outer_volume) &&
         is_range(statement.inner_area, statement.outer_area);
}

const char* plane_count_error(NodeKind kind, std::size_t count) {
  switch (kind) {
    case NodeKind::White:
    case NodeKind::Black:
      return count == 0 ? nullptr : "a homogeneous node has planes";
    case NodeKind::Grey:
      return nullptr;
    case NodeKind::Convex:
      return count >= 1 ? nullptr : "a convex node without planes";
    case NodeKind::Concave:
      return count >= 2 ? nullptr : "a concave node with fewer than 2 planes";
    case NodeKind::Vertex:
      return count >= 1 ? nullptr : "a vertex node without planes";
  }
  return "an unknown kind";
}

bool is_well_formed(std::span<const std::uint32_t> tokens, std::uint32_t plane_count) {
  // Each split asks for one expression more than it satisfies.
  std::size_t wanted = 1;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (wanted == 0) return false;
    if (tokens[i] < kFirstPlaneToken) {
      --wanted;
    } else if (tokens[i] - kFirstPlaneToken < plane_count) {
      ++wanted;
    } else {
      return false;
    }
  }
  return wanted == 0;
}

std::vector<std::string> validate(const Octree& tree, std::size_t limit) {
  Findings findings(limit);
  if (!is_valid(tree.universe)) findings.add("the universe cube is not valid");
  for (std::size_t i = 0; i < tree.planes.size(); ++i) {
    if (!is_valid(tree.planes[i])) {
      findings.add("plane " + std::to_string(i) + " is not a unit normal and offset on the grid");
    }
  }
  // What walks the tree recursively, the check of ancestors too, relies on links and depth.
  bool linked = true;
  if (tree.levels.size() > static_cast<std::size_t>(kMaxDepth) + 1) {
    findings.add("more than " + std::to_string(kMaxDepth + 1) + " levels");
    linked = false;
  }
  std::uint64_t expected_size = 1;
  std::uint32_t seen = 0;
  for (std::size_t depth = 0; depth < tree.levels.size(); ++depth) {
    const Level& level = tree.levels[depth];
    if (level.kinds.size() != expected_size) {
      findings.add("level " + std::to_string(depth) + ": " + std::to_string(level.kinds.size()) +
                   " nodes where " + std::to_string(expected_size) + " belong");
      linked = false;
    } else if (level.kinds.empty()) {
      findings.add("level " + std::to_string(depth) + ": no nodes");
    }
    if (!is_valid(level.statement)) {
      findings.add("level " + std::to_string(depth) + ": an error bound, volumes or areas that are none");
    }
    if (!columns_match(level)) {
      findings.add("level " + std::to_string(depth) + ": columns of different lengths");
      return findings.take();
    }
    std::uint32_t greys = 0;
    for (std::uint32_t node = 0; node < level.size(); ++node) {
      const NodeKind kind = level.kinds[node];
      const auto planes = level.planes_of(node);
      const auto expression = level.expression_of(node);
      if (const char* wrong = plane_count_error(kind, planes.size())) {
        findings.add(at(depth, node) + wrong);
      }
      for (const std::uint32_t plane : planes) {
        if (plane >= tree.planes.size() || plane > seen) {
          findings.add(at(depth, node) + "plane " + std::to_string(plane) +
                       " is not the next new plane or one seen before");
          linked = false;
        } else if (plane == seen) {
          ++seen;
        }
      }
      if (kind == NodeKind::Vertex
              ? !is_well_formed(expression, static_cast<std::uint32_t>(planes.size()))
              : !expression.empty()) {
        findings.add(at(depth, node) + "a malformed expression");
      }
      if (kind == NodeKind::Grey && level.first_child[node] != 8 * greys++) {
        findings.add(at(depth, node) + "a wrong link to its children");
        linked = false;
      }
    }
    if (greys != level.grey_count) {
      findings.add("level " + std::to_string(depth) + ": a wrong count of GREY nodes");
    }
    expected_size = std::uint64_t{8} * greys;
  }
  if (seen != tree.planes.size()) {
    findings.add(std::to_string(tree.planes.size() - seen) + " planes that no node refers to");
  }
  if (linked && !tree.levels.empty()) AncestorCheck(tree, findings).visit(0, 0);
  return findings.take();
}

}  // namespace spoctree
