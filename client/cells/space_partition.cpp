#include "client/cells/space_partition.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

#include "common/base/small_count.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/expression.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

namespace {

/// So many may come as they are.
constexpr std::size_t kFewPlanes = 12;

/// The share of a GREY node's work that its own planes are.
constexpr double kPeeling = 0.1;

class Partitioner {
 public:
  using Child = SpacePartition::Child;

  Partitioner(const Octree& tree, std::uint32_t level, const ProgressShare& progress,
              std::size_t most)
      : tree_(tree), planes_(tree.plane_set()), level_(level), progress_(progress), most_(most) {}

  SpacePartition run() {
    Polyhedron& cube = scratch();
    make_cell(NodeAddress{}.lower, NodeAddress{}.size(), planes_, cube);
    visit({}, cube, {&result_.root, 0, false}, 1);
    release();
    progress_.tell();
    return std::move(result_);
  }

 private:
  /// Where the number of a part goes: a split's side, or the root.
  struct Place {
    Child* root;
    std::uint32_t split;
    bool is_outside;
  };

  // Polyhedra in use, as a stack whose storage is kept.
  Polyhedron& scratch() {
    if (used_ == storage_.size()) storage_.emplace_back();
    return storage_[used_++];
  }
  void release() { --used_; }

  void put(const Place& place, Child child) {
    if (place.root != nullptr) {
      *place.root = child;
    } else if (place.is_outside) {
      result_.splits[place.split].outside = child;
    } else {
      result_.splits[place.split].inside = child;
    }
  }
  void put_empty(const Place& place, const Polyhedron& cell) {
    const std::uint32_t number = small_count(result_.cells.size(), "empty cells", most_ - 1);
    put(place, SpacePartition::empty_cell(number));
    Polyhedron& stored = result_.cells.emplace_back(cell);
    stored.vertices.shrink_to_fit();
    stored.corners.shrink_to_fit();
    stored.faces.shrink_to_fit();
  }
  void put_material(const Place& place, const Polyhedron& piece) {
    put(place, SpacePartition::kMaterial);
    result_.material_volume += volume(piece);
  }
  std::uint32_t put_split(const Place& place, PlaneRef plane) {
    constexpr std::size_t kMost = std::numeric_limits<Child>::max();
    const std::uint32_t number = small_count(result_.splits.size(), "splits of space", kMost);
    put(place, static_cast<Child>(number));
    result_.splits.push_back({plane, SpacePartition::kMaterial, SpacePartition::kMaterial});
    return number;
  }

  /// `region` is the node's cube within its ancestors' half-spaces; the caller is done with it. A
  /// share of `work` is done then.
  void visit(const NodeAddress& node, Polyhedron& region, Place place, double work) {
    const Level& level = tree_.levels[node.level];
    const auto planes = level.planes_of(node.index);
    switch (level.kinds[node.index]) {
      case NodeKind::White:
        put_empty(place, region);
        break;
      case NodeKind::Black:
        put_material(place, region);
        break;
      case NodeKind::Convex:
        if (peel(region, planes, place, work)) put_material(place, region);
        return;
      case NodeKind::Concave:
        union_of(static_cast<std::uint32_t>(planes.size()), union_);
        divide(region, planes, union_, place);
        break;
      case NodeKind::Vertex:
        divide(region, planes, level.expression_of(node.index), place);
        break;
      case NodeKind::Grey:
        if (!peel(region, planes, place, kPeeling * work)) {
          progress_.add((1 - kPeeling) * work);
        } else if (node.level == level_) {
          put_material(place, region);
          progress_.add((1 - kPeeling) * work);
        } else {
          visit_octants(node, region, 0, 0, place, (1 - kPeeling) * work);
        }
        return;
    }
    progress_.add(work);
  }

  static std::uint64_t shuffled(std::uint64_t number) {
    number = (number + 1) * 0x9E3779B97F4A7C15u;
    number = (number ^ (number >> 30)) * 0xBF58476D1CE4E5B9u;
    return number ^ (number >> 27);
  }

  /// What is outside the planes becomes cells, one plane after the other; false if nothing else
  /// is left. `place` is that of the rest then. A share of `work` is done then.
  ///
  /// In the order of numbers that look random: the first few planes cut most off, and what others
  /// cut off is near the solid. Planes in the order of a sphere's bands would make a fan of slices
  /// that all reach far out, and a hundred times as many avenues.
  bool peel(Polyhedron& region, std::span<const std::uint32_t> own, Place& place, double work) {
    std::vector<std::uint32_t> planes(own.begin(), own.end());
    if (planes.size() > kFewPlanes) {
      std::sort(planes.begin(), planes.end(), [](std::uint32_t p, std::uint32_t q) {
        return std::pair(shuffled(p), p) < std::pair(shuffled(q), q);
      });
    }
    Polyhedron& inside = scratch();
    bool is_left = true;
    if (planes.empty()) progress_.add(work);
    for (const std::uint32_t index : planes) {
      progress_.add(work * per_item(planes.size()));
      const PlaneRef plane = PlaneRef::of_table(index);
      const auto parts = clipper_.split(region, plane, planes_, inside, outside_);
      if (!parts.outside) continue;
      if (!parts.inside) {
        put_empty(place, region);
        is_left = false;
        break;
      }
      const std::uint32_t split = put_split(place, plane);
      put_empty({nullptr, split, true}, outside_);
      place = {nullptr, split, false};
      std::swap(region, inside);
    }
    release();
    return is_left;
  }

  /// The part of a GREY node's region in those of its octants that agree with `octant` on the first
  /// `axes` axes.
  void visit_octants(const NodeAddress& node, Polyhedron& region, std::uint32_t axes,
                     std::uint32_t octant, const Place& place, double work) {
    if (axes == 3) {
      const std::uint32_t first_child = tree_.levels[node.level].first_child[node.index];
      visit(node.child(first_child, octant), region, place, work);
      return;
    }
    const PlaneRef middle =
        PlaneRef::of_wall(static_cast<int>(axes), node.lower[axes] + node.size() / 2);
    Polyhedron& lower = scratch();
    Polyhedron& upper = scratch();
    const auto parts = clipper_.split(region, middle, planes_, lower, upper);
    const std::uint32_t upper_octant = octant | 1u << axes;
    if (parts.inside && parts.outside) {
      const std::uint32_t split = put_split(place, middle);
      visit_octants(node, lower, axes + 1, octant, {nullptr, split, false}, work / 2);
      visit_octants(node, upper, axes + 1, upper_octant, {nullptr, split, true}, work / 2);
    } else if (parts.inside) {
      visit_octants(node, lower, axes + 1, octant, place, work);
    } else {
      visit_octants(node, upper, axes + 1, upper_octant, place, work);
    }
    release();
    release();
  }

  /// A stack of its own instead of recursion: there are as many splits within each other as the
  /// node has planes.
  void divide(const Polyhedron& region, std::span<const std::uint32_t> planes,
              std::span<const std::uint32_t> expression, const Place& place) {
    find_ends(expression, ends_);
    open_.clear();
    open_.push_back({0, place, region});
    while (!open_.empty()) {
      const std::uint32_t at = open_.back().token;
      const Place to = open_.back().place;
      std::swap(cell_, open_.back().cell);
      open_.pop_back();
      const std::uint32_t token = expression[at];
      if (token == kInToken) {
        put_material(to, cell_);
        continue;
      }
      if (token == kOutToken) {
        put_empty(to, cell_);
        continue;
      }
      const PlaneRef plane = PlaneRef::of_table(planes[token - kFirstPlaneToken]);
      const auto parts = clipper_.split(cell_, plane, planes_, inside_, outside_);
      Place in = to;
      Place out = to;
      if (parts.inside && parts.outside) {
        const std::uint32_t split = put_split(to, plane);
        in = {nullptr, split, false};
        out = {nullptr, split, true};
      }
      if (parts.outside) open_.push_back({ends_[at + 1], out, outside_});
      if (parts.inside) open_.push_back({at + 1, in, inside_});
    }
  }

  struct Open {
    std::uint32_t token;
    Place place;
    Polyhedron cell;
  };

  const Octree& tree_;
  const PlaneSet planes_;
  const std::uint32_t level_;
  ProgressCounter progress_;
  const std::size_t most_;
  SpacePartition result_;
  PolyhedronClipper clipper_;
  std::deque<Polyhedron> storage_;  // a deque: references stay valid while it grows
  std::size_t used_ = 0;
  Polyhedron cell_, inside_, outside_;
  std::vector<Open> open_;
  std::vector<std::uint32_t> union_, ends_;
};

}  // namespace

SpacePartition partition_space(const Octree& tree, std::uint32_t level,
                               const ProgressShare& progress, std::size_t most) {
  level = static_cast<std::uint32_t>(std::min<std::size_t>(level, tree.levels.size() - 1));
  return Partitioner(tree, level, progress, most).run();
}

}  // namespace spoctree
