#include "server/build/error_bound.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "common/geometry/half_space_clipper.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/expression.hpp"
#include "server/build/certify.hpp"
#include "server/build/convex_distance.hpp"

namespace spoctree {

namespace {

/// Distances are computed to better than this; it is added to every bound (universe units).
constexpr double kDistanceRounding = 1e-12;

/// Nodes and boxes opened for one level at most.
constexpr std::size_t kMostSteps = 20000;

/// A leaf of more planes is not divided into its pieces of material and what is between them, of
/// which there may be as many: it is searched as it is.
constexpr std::size_t kMostPlanesDivided = 256;

/// Doubles tell a point's side of a plane to better than this.
constexpr double kSideRounding = 1e-14;

/// False only if no point of the box is in the part. Says whether its centre is.
bool may_meet(const Polyhedron& part, const PlaneSet& planes, Vec3 centre, Vec3 half,
              bool& centre_is_inside) {
  centre_is_inside = true;
  for (const Polyhedron::Face& face : part.faces) {
    const Plane plane = planes[face.plane];
    const double value = glm::dot(plane.normal, centre) - plane.offset;
    if (value - glm::dot(glm::abs(plane.normal), half) > kSideRounding) return false;
    if (value > 0) centre_is_inside = false;
  }
  return true;
}

bool comes_before(const PolyhedronVertex& a, const PolyhedronVertex& b) {
  const auto key = [](const PolyhedronVertex& v) {
    return std::tie(v.position.x, v.position.y, v.position.z, v.planes[0], v.planes[1],
                    v.planes[2]);
  };
  return key(a) < key(b);
}

/// The corners of a region, without its faces, that are not corners of the piece cut from it.
Polyhedron corners_cut_off(const Polyhedron& region, const Polyhedron& piece) {
  PlainVector<PolyhedronVertex> left = piece.vertices;
  std::sort(left.begin(), left.end(), comes_before);
  Polyhedron cut_off;
  for (const PolyhedronVertex& vertex : region.vertices) {
    if (std::binary_search(left.begin(), left.end(), vertex, comes_before)) continue;
    cut_off.vertices.push_back(vertex);
  }
  return cut_off;
}

/// A best-first search for the point of T_k that is farthest from the solid.
class ExcessSearch {
 public:
  ExcessSearch(const BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
               double attained)
      : built_(built),
        solid_(solid),
        queries_(queries),
        planes_(built.tree.plane_set()),
        attained_(attained) {}

  /// A GREY node of T_k, with its region.
  void add_node(const NodeAddress& grey_node, const Polyhedron& region, double bound);
  /// Nothing in the nodes added is farther from the solid.
  double run();

 private:
  using SharedPolyhedron = std::shared_ptr<const Polyhedron>;
  using Planes = std::vector<std::uint32_t>;
  /// A GREY node and what T_k has of its cube, or a box that matters as far as it is in a part of
  /// the excess.
  struct Item {
    double bound = 0;
    SharedPolyhedron region;
    bool is_node = false;
    NodeAddress node;
    Planes cuts;  ///< of the node and those above it, up to level k: T_k does not know of them
    Vec3 centre{0.0};
    Vec3 half{0.0};
    bool has_material = false;  ///< in the region, whose excess is what is not inside the solid
    bool operator<(const Item& other) const { return bound < other.bound; }
  };

  bool is_in_question(double bound) const { return bound > kErrorBoundRatio * attained_; }
  void open_node(const Item& item);
  void open_child(const NodeAddress& child, const Item& parent, Polyhedron region);
  void open_leaf(const NodeAddress& leaf, const Planes& cuts, double bound, Polyhedron region);
  void add_parts(const std::vector<Polyhedron>& parts, const std::vector<Polyhedron>& pieces,
                 double bound);
  void add_part(const Polyhedron& part, double bound);
  void add_undivided(const NodeAddress& leaf, const Planes& cuts, double bound,
                     const Polyhedron& region);
  static double set_box(Item& item, const Polyhedron& part);
  double bound_of_box(const Item& box, double radius, bool centre_is_in_region);
  void open_box(const Item& item);

  const BuiltOctree& built_;
  const Solid& solid_;
  const SolidQueries& queries_;
  const PlaneSet planes_;
  PolyhedronClipper clipper_;
  HalfSpaceClipper many_clipper_;
  std::priority_queue<Item> open_;
  double attained_;
};

void ExcessSearch::add_node(const NodeAddress& grey_node, const Polyhedron& region, double bound) {
  Item item;
  item.bound = bound;
  item.region = std::make_shared<const Polyhedron>(region);
  item.is_node = true;
  item.node = grey_node;
  open_.push(std::move(item));
}

double ExcessSearch::run() {
  for (std::size_t steps = 0; steps < kMostSteps && !open_.empty(); ++steps) {
    const Item item = open_.top();
    if (!is_in_question(item.bound)) break;
    open_.pop();
    if (item.is_node) {
      open_node(item);
    } else {
      open_box(item);
    }
  }
  return std::max(kErrorBoundRatio * attained_, open_.empty() ? 0.0 : open_.top().bound) +
         kDistanceRounding;
}

void ExcessSearch::open_node(const Item& item) {
  const NodeAddress& node = item.node;
  const std::uint32_t first_child = built_.tree.levels[node.level].first_child[node.index];
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const NodeAddress child = node.child(first_child, octant);
    const NodeKind kind = built_.tree.levels[child.level].kinds[child.index];
    if (kind == NodeKind::Black && item.cuts.empty()) continue;
    Polyhedron region = *item.region;
    bool has_interior = true;
    for (int axis = 0; axis < 3 && has_interior; ++axis) {
      const PlaneRef middle = PlaneRef::of_wall(axis, node.lower[axis] + node.size() / 2);
      const bool is_upper = ((octant >> axis) & 1) != 0;
      has_interior =
          clipper_.clip(region, is_upper ? middle.flipped() : middle, planes_) != ClipResult::Empty;
    }
    if (has_interior) open_child(child, item, std::move(region));
  }
}

void ExcessSearch::open_child(const NodeAddress& child, const Item& parent, Polyhedron region) {
  const Level& level = built_.tree.levels[child.level];
  if (level.kinds[child.index] != NodeKind::Grey) {
    open_leaf(child, parent.cuts, parent.bound, std::move(region));
    return;
  }
  Item item;
  item.bound = std::min(parent.bound, reach_of(built_, solid_, child, region).bound);
  if (!is_in_question(item.bound)) return;
  item.region = std::make_shared<const Polyhedron>(std::move(region));
  item.is_node = true;
  item.node = child;
  item.cuts = parent.cuts;
  const auto planes = level.planes_of(child.index);
  item.cuts.insert(item.cuts.end(), planes.begin(), planes.end());
  open_.push(std::move(item));
}

/// Divides what T_k has of a leaf's cube into pieces of material and parts of the excess.
void ExcessSearch::open_leaf(const NodeAddress& leaf, const Planes& cuts, double bound,
                             Polyhedron region) {
  const Level& level = built_.tree.levels[leaf.level];
  const NodeKind kind = level.kinds[leaf.index];
  if (kind == NodeKind::White) {
    add_part(region, bound);
    return;
  }
  const auto planes = level.planes_of(leaf.index);
  if (cuts.size() + planes.size() > kMostPlanesDivided) {
    add_undivided(leaf, cuts, bound, region);
    return;
  }
  std::vector<Polyhedron> parts, pieces;
  Polyhedron inside, outside;
  // What is left of the region within the half-space.
  const auto cut = [&](std::uint32_t plane) {
    const auto found = clipper_.split(region, PlaneRef::of_table(plane), planes_, inside, outside);
    if (found.outside) parts.push_back(outside);
    std::swap(region, inside);
    return found.inside;
  };
  bool has_rest = std::all_of(cuts.begin(), cuts.end(), cut);
  if (kind == NodeKind::Convex) {
    has_rest = has_rest && std::all_of(planes.begin(), planes.end(), cut);
  }
  if (!has_rest) {
    add_parts(parts, pieces, bound);
    return;
  }
  if (kind == NodeKind::Black || kind == NodeKind::Convex) {
    pieces.push_back(std::move(region));
    add_parts(parts, pieces, bound);
    return;
  }
  std::vector<std::uint32_t> tokens;
  if (kind == NodeKind::Concave) {
    tokens = union_of(static_cast<std::uint32_t>(planes.size()));
  } else {
    const auto expression = level.expression_of(leaf.index);
    tokens.assign(expression.begin(), expression.end());
  }
  // There are as many splits within each other as the node has planes: no recursion.
  std::vector<std::pair<Polyhedron, const std::uint32_t*>> open{{std::move(region), tokens.data()}};
  while (!open.empty()) {
    auto [cell, token] = std::move(open.back());
    open.pop_back();
    if (*token < kFirstPlaneToken) {
      (*token == kInToken ? pieces : parts).push_back(std::move(cell));
      continue;
    }
    const PlaneRef plane = PlaneRef::of_table(planes[*token - kFirstPlaneToken]);
    const auto found = clipper_.split(cell, plane, planes_, inside, outside);
    if (found.inside) open.emplace_back(inside, token + 1);
    if (found.outside) open.emplace_back(outside, skip_expression(token + 1));
  }
  add_parts(parts, pieces, bound);
}

/// Parts beside pieces of material, which they may cover as thin sheets.
void ExcessSearch::add_parts(const std::vector<Polyhedron>& parts,
                             const std::vector<Polyhedron>& pieces, double bound) {
  for (const Polyhedron& part : parts) {
    double least = bound;
    for (const Polyhedron& piece : pieces) {
      if (!is_in_question(least)) break;
      least = std::min(least, largest_distance(part, piece, planes_));
    }
    if (is_in_question(least)) add_part(part, least);
  }
}

/// The smallest box around a polyhedron, and how far its corners are from the centre at most.
double ExcessSearch::set_box(Item& item, const Polyhedron& part) {
  Vec3 lower = part.vertices.front().position;
  Vec3 upper = lower;
  for (const PolyhedronVertex& vertex : part.vertices) {
    lower = glm::min(lower, vertex.position);
    upper = glm::max(upper, vertex.position);
  }
  item.centre = 0.5 * (lower + upper);
  item.half = 0.5 * (upper - lower);
  double radius = 0;
  for (const PolyhedronVertex& vertex : part.vertices) {
    radius = std::max(radius, glm::distance(item.centre, vertex.position) + vertex.error);
  }
  return radius;
}

void ExcessSearch::add_part(const Polyhedron& part, double bound) {
  Item item;
  const double radius = set_box(item, part);
  item.bound = std::min(bound, queries_.distance(item.centre) + radius);
  if (!is_in_question(item.bound)) return;
  for (const PolyhedronVertex& vertex : part.vertices) {
    attained_ = std::max(attained_, queries_.distance(vertex.position) - vertex.error);
  }
  if (!is_in_question(item.bound)) return;
  item.region = std::make_shared<const Polyhedron>(part);
  open_.push(std::move(item));
}

/// A leaf with its material in it. Where that is convex, nothing is farther from it than a corner.
void ExcessSearch::add_undivided(const NodeAddress& leaf, const Planes& cuts, double bound,
                                 const Polyhedron& region) {
  for (const PolyhedronVertex& vertex : region.vertices) {
    const double distance = queries_.distance(vertex.position) - vertex.error;
    if (distance <= attained_) continue;
    if (queries_.side_of(vertex.position) != SolidQueries::Side::In) attained_ = distance;
  }
  const Level& level = built_.tree.levels[leaf.level];
  if (level.kinds[leaf.index] == NodeKind::Convex) {
    Planes planes = cuts;
    const auto own = level.planes_of(leaf.index);
    planes.insert(planes.end(), own.begin(), own.end());
    Polyhedron piece = region;
    if (many_clipper_.clip(piece, planes, planes_)) {
      bound = std::min(bound, largest_distance(corners_cut_off(region, piece), piece, planes_));
    }
  }
  Item item;
  item.has_material = true;
  const double radius = set_box(item, region);
  item.bound = std::min(bound, bound_of_box(item, radius, false));
  if (!is_in_question(item.bound)) return;
  item.region = std::make_shared<const Polyhedron>(region);
  open_.push(std::move(item));
}

/// Nothing in the excess within `radius` of the centre is farther from the solid. Notes how far the
/// centre is, if it belongs to the excess.
double ExcessSearch::bound_of_box(const Item& box, double radius, bool centre_is_in_region) {
  const double distance = queries_.distance(box.centre);
  // From material, the way to what is beyond it leads through the boundary.
  if (box.has_material && queries_.side_of(box.centre) == SolidQueries::Side::In) {
    return std::max(0.0, radius - distance);
  }
  if (centre_is_in_region) attained_ = std::max(attained_, distance);
  return distance + radius;
}

void ExcessSearch::open_box(const Item& item) {
  for (unsigned octant = 0; octant < 8; ++octant) {
    Item part = item;
    part.half = 0.5 * item.half;
    for (int axis = 0; axis < 3; ++axis) {
      part.centre[axis] += ((octant >> axis) & 1) ? part.half[axis] : -part.half[axis];
    }
    bool centre_is_inside = false;
    if (!may_meet(*item.region, planes_, part.centre, part.half, centre_is_inside)) continue;
    part.bound = std::min(item.bound, bound_of_box(part, glm::length(part.half), centre_is_inside));
    if (is_in_question(part.bound)) open_.push(std::move(part));
  }
}

}  // namespace

double error_bound(const GreyRegions& regions, const BuiltOctree& built, const Solid& solid,
                   const SolidQueries& queries) {
  ExcessSearch search(built, solid, queries, regions.attained);
  for (const GreyRegions::Candidate& candidate : regions.candidates) {
    if (candidate.bound > kErrorBoundRatio * regions.attained) {
      search.add_node(candidate.node, candidate.region, candidate.bound);
    }
  }
  return search.run();
}

}  // namespace spoctree
