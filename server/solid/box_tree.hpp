// Boxes into a binary tree that finds those that overlap each other, stand above a point, or are
// near one. Everything geometric about triangles goes through it: self-intersections, inside or
// outside, distance.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// A closed box.
struct Box {
  Vec3 lower{0.0};
  Vec3 upper{0.0};

  bool overlaps(const Box& other) const {
    return lower.x <= other.upper.x && other.lower.x <= upper.x && lower.y <= other.upper.y &&
           other.lower.y <= upper.y && lower.z <= other.upper.z && other.lower.z <= upper.z;
  }
  /// Whether the ray from `p` along +z meets the box.
  bool is_met_above(Vec3 p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y && upper.z >= p.z;
  }
  double squared_distance(Vec3 p) const {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = std::max({lower[i] - p[i], p[i] - upper[i], 0.0});
      sum += d * d;
    }
    return sum;
  }
};

/// Two nodes of a BoxTree whose boxes are to be compared; twice the same: those within one node.
using NodePair = std::array<std::uint32_t, 2>;

/// A tree of halves: each node's boxes are split at the median of their centres along the longest
/// side, down to leaves of a few. The same boxes give the same tree and the same order of visits.
class BoxTree {
 public:
  /// O(n log n). Box i is known as i from here on. REQUIRES: less than 2^31 boxes, no NaN.
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(i, j) once for every pair of boxes that overlap.
  template <class Visit>
  void visit_overlapping_pairs(Visit visit) const {
    if (!nodes_.empty()) visit_pairs({0, 0}, {}, visit);
  }

  /// The same in parts, for loops that run in parallel: all pairs of boxes are in one of these
  /// pairs of nodes, of which none has more than `most` boxes, or they do not overlap. Always the
  /// same.
  std::vector<NodePair> split_pairs(std::uint32_t most) const;

  /// For each node, the label that all its boxes have, or kMixed. REQUIRES: a label for each box.
  std::vector<std::uint32_t> common_labels(std::span<const std::uint32_t> label_of_box) const;
  static constexpr std::uint32_t kMixed = std::numeric_limits<std::uint32_t>::max();

  /// Calls visit(i, j) once for every pair of boxes of these nodes that overlap, but not for boxes
  /// with equal labels other than kMixed; `node_labels` is empty (no labels) or from common_labels.
  template <class Visit>
  void visit_overlapping_pairs(NodePair pair, std::span<const std::uint32_t> node_labels,
                               Visit visit) const {
    visit_pairs(pair, node_labels, visit);
  }

  /// Calls visit(i) for every box that overlaps `box`.
  template <class Visit>
  void visit_overlapping(const Box& box, Visit visit) const {
    if (!nodes_.empty()) visit_overlapping_in(0, box, visit);
  }

  /// Calls visit(i) for every box for which may_meet(box), which is then true of the boxes around it
  /// as well. Ends when visit returns false, and returns false then.
  template <class MayMeet, class Visit>
  bool visit_if(MayMeet may_meet, Visit visit) const {
    return nodes_.empty() || visit_if_in(0, may_meet, visit);
  }

  /// Calls visit(i) for every box that the ray from `p` along +z meets.
  template <class Visit>
  void visit_boxes_above(Vec3 p, Visit visit) const {
    if (!nodes_.empty()) visit_above(0, p, visit);
  }

  /// The smallest of squared_distance(i), where that is at least the squared distance of box i from
  /// `p`; infinity if there are no boxes.
  template <class SquaredDistance>
  double smallest_squared_distance(Vec3 p, SquaredDistance squared_distance) const {
    double smallest = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) search_nearest(0, p, squared_distance, smallest);
    return smallest;
  }

 private:
  // Preorder: the first child of an inner node follows it. Its boxes are leaves_[begin, end).
  struct Node {
    Box box;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t second_child = 0;  // 0: a leaf
  };
  struct Leaf {
    Box box;
    std::uint32_t index = 0;
  };

  void build(std::uint32_t node_index, std::uint32_t begin, std::uint32_t end);

  // The pairs of children that make up a pair of nodes, not both leaves; calls visit_pair({a, b}).
  template <class VisitPair>
  void visit_halves(NodePair pair, VisitPair visit_pair) const {
    const auto [a, b] = pair;
    if (a == b) {
      visit_pair(NodePair{a + 1, a + 1});
      visit_pair(NodePair{nodes_[a].second_child, nodes_[a].second_child});
      visit_pair(NodePair{a + 1, nodes_[a].second_child});
    } else if (size_of(a) >= size_of(b)) {
      visit_pair(NodePair{a + 1, b});
      visit_pair(NodePair{nodes_[a].second_child, b});
    } else {
      visit_pair(NodePair{a, b + 1});
      visit_pair(NodePair{a, nodes_[b].second_child});
    }
  }
  std::uint32_t size_of(std::uint32_t node) const { return nodes_[node].end - nodes_[node].begin; }
  bool can_be_split(NodePair pair) const {
    return nodes_[pair[0]].second_child != 0 || nodes_[pair[1]].second_child != 0;
  }

  template <class Visit>
  void visit_pairs(NodePair pair, std::span<const std::uint32_t> labels, Visit& visit) const {
    const Node& a = nodes_[pair[0]];
    const Node& b = nodes_[pair[1]];
    if (!a.box.overlaps(b.box)) return;
    if (!labels.empty() && labels[pair[0]] != kMixed && labels[pair[0]] == labels[pair[1]]) return;
    if (can_be_split(pair)) {
      visit_halves(pair, [&](NodePair halves) { visit_pairs(halves, labels, visit); });
    } else if (pair[0] == pair[1]) {
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        for (std::uint32_t j = i + 1; j < a.end; ++j) visit_if_overlapping(i, j, visit);
      }
    } else {
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        if (!leaves_[i].box.overlaps(b.box)) continue;
        for (std::uint32_t j = b.begin; j < b.end; ++j) visit_if_overlapping(i, j, visit);
      }
    }
  }

  template <class Visit>
  void visit_if_overlapping(std::uint32_t i, std::uint32_t j, Visit& visit) const {
    if (leaves_[i].box.overlaps(leaves_[j].box)) visit(leaves_[i].index, leaves_[j].index);
  }

  template <class Visit>
  void visit_overlapping_in(std::uint32_t node_index, const Box& box, Visit& visit) const {
    const Node& node = nodes_[node_index];
    if (!node.box.overlaps(box)) return;
    if (node.second_child != 0) {
      visit_overlapping_in(node_index + 1, box, visit);
      visit_overlapping_in(node.second_child, box, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (leaves_[i].box.overlaps(box)) visit(leaves_[i].index);
    }
  }

  template <class MayMeet, class Visit>
  bool visit_if_in(std::uint32_t node_index, MayMeet& may_meet, Visit& visit) const {
    const Node& node = nodes_[node_index];
    if (!may_meet(node.box)) return true;
    if (node.second_child != 0) {
      return visit_if_in(node_index + 1, may_meet, visit) &&
             visit_if_in(node.second_child, may_meet, visit);
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (may_meet(leaves_[i].box) && !visit(leaves_[i].index)) return false;
    }
    return true;
  }

  template <class Visit>
  void visit_above(std::uint32_t node_index, Vec3 p, Visit& visit) const {
    const Node& node = nodes_[node_index];
    if (!node.box.is_met_above(p)) return;
    if (node.second_child != 0) {
      visit_above(node_index + 1, p, visit);
      visit_above(node.second_child, p, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (leaves_[i].box.is_met_above(p)) visit(leaves_[i].index);
    }
  }

  template <class SquaredDistance>
  void search_nearest(std::uint32_t node_index, Vec3 p, SquaredDistance& squared_distance,
                      double& smallest) const {
    const Node& node = nodes_[node_index];
    if (node.second_child == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (leaves_[i].box.squared_distance(p) >= smallest) continue;
        smallest = std::min(smallest, squared_distance(leaves_[i].index));
      }
      return;
    }
    std::uint32_t near = node_index + 1;
    std::uint32_t far = node.second_child;
    double near_distance = nodes_[near].box.squared_distance(p);
    double far_distance = nodes_[far].box.squared_distance(p);
    if (far_distance < near_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (near_distance < smallest) search_nearest(near, p, squared_distance, smallest);
    if (far_distance < smallest) search_nearest(far, p, squared_distance, smallest);
  }

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

/// The box of a triangle.
Box box_around(Vec3 a, Vec3 b, Vec3 c);

}  // namespace spoctree
