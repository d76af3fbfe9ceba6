#include "server/build/error_bound.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <optional>
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

/// Boxes and parts opened for one level at most. (Nodes are opened once each.)
constexpr std::size_t kMostBoxes = 20000;

/// What may be farther than so many times what is in question by now is opened at once: hardly
/// will anything be found that spares it, and what waits takes memory.
constexpr double kFarBeyond = 8;

/// A leaf of more planes is not divided into its pieces of material and what is between them, of
/// which there may be as many: it is searched as it is.
constexpr std::size_t kMostPlanesDivided = 1024;

/// Of a leaf's pieces of material, so many at most are tried for each part beside them.
constexpr std::size_t kPiecesTried = 16;

/// Of an undivided leaf's corners, about as many are looked at.
constexpr std::size_t kCornersTried = 64;

/// Parts not longer than so many of the finest cells are divided as boxes: walls are between those.
constexpr double kFewUnits = 4;

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

/// A box around some points.
struct Extent {
  Vec3 lower{0.0};
  Vec3 upper{0.0};
  Vec3 mean{0.0};    ///< of the points: in any convex set that has them
  double error = 0;  ///< the largest of theirs

  Vec3 centre() const { return 0.5 * (lower + upper); }
};

Extent extent_of(const Polyhedron& part) {
  Extent extent;
  extent.lower = extent.upper = part.vertices.front().position;
  for (const PolyhedronVertex& vertex : part.vertices) {
    extent.lower = glm::min(extent.lower, vertex.position);
    extent.upper = glm::max(extent.upper, vertex.position);
    extent.mean += vertex.position;
    extent.error = std::max(extent.error, vertex.error);
  }
  extent.mean /= static_cast<double>(part.vertices.size());
  return extent;
}

/// Some of the points in the one box, which they fill from wall to wall, are no nearer to the
/// other.
double overhang(const Extent& of, const Extent& beyond) {
  const Vec3 by = glm::max(beyond.lower - of.lower, of.upper - beyond.upper);
  return std::max({by.x, by.y, by.z, 0.0});
}

bool has_less_volume(const Polyhedron& a, const Polyhedron& b) { return volume(a) < volume(b); }

/// A best-first search for the points of T_k, for one k after the other, that are farthest from the
/// solid.
class ExcessSearch {
 public:
  ExcessSearch(const BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
               std::span<const GreyRegions> regions);

  /// Nothing in the regions of level k, the next one, is farther from the solid.
  double run(std::uint32_t k, const GreyRegions& regions);

 private:
  /// A plane of a GREY node of some level: T_k knows of it from this level on.
  struct Cut {
    std::uint32_t level;
    std::uint32_t plane;
  };
  using Cuts = std::vector<Cut>;
  /// What a plane or a leaf of some level takes away.
  struct Part {
    std::uint32_t level;
    Polyhedron shape;
  };
  /// What T_k has of a node's cube, for one k after the other; or a part of the excess.
  struct Region {
    Polyhedron shape;
    NodeAddress node;
    std::uint32_t level = 0;  ///< k
    Cuts cuts;                ///< of the GREY nodes down to this one, after `level`, in their order
  };
  enum class Kind : std::uint8_t {
    Node,  ///< GREY, with its region
    Leaf,  ///< a box that matters as far as it is in a leaf's region and not in the solid
    Part   ///< a part of the excess, and the box around it; or, if tiny, what of it is in a box
  };
  /// The pieces of material in a leaf.
  struct Pieces {
    std::vector<Polyhedron> shapes;
    std::vector<Extent> extents;
    std::size_t largest = 0;
  };
  struct Item {
    double bound = 0;
    Kind kind = Kind::Part;
    std::uint32_t end_level = 0;  ///< T_k has nothing of this in excess from here on
    std::shared_ptr<Region> region;
    Vec3 centre{0.0};
    Vec3 half{0.0};
    std::shared_ptr<const Pieces> pieces;  ///< beside a part
    bool operator<(const Item& other) const { return bound < other.bound; }
  };

  double threshold(std::uint32_t level) const { return kErrorBoundRatio * attained_[level]; }
  /// For the last level that it is in excess of: that has attained the least.
  bool is_in_question(double bound, std::uint32_t end_level) const {
    return end_level > 0 && bound > threshold(end_level - 1);
  }
  void attain(double distance, std::uint32_t end_level);
  bool take_away(std::uint32_t k, Region& region);
  bool bring_to_level(Item& item, std::uint32_t k);
  void open_node(const Item& item);
  void open_child(const NodeAddress& child, const Item& parent, Polyhedron shape);
  void open_leaf(Region&& of_leaf, double bound);
  void add_parts(std::vector<Part>&& parts, std::vector<Polyhedron>&& shapes, double bound);
  double bound_by_pieces(const Part& part, const Extent& extent, const Pieces& pieces,
                         double bound);
  void add_part(Part&& part, const std::shared_ptr<const Pieces>& pieces, double bound);
  void open_part(const Item& item);
  void add_undivided(Region&& region, double bound);
  double bound_of_undivided(const Region& undivided);
  double bound_of_box(const Item& box, bool centre_is_in_region);
  void open_box(const Item& item);

  const BuiltOctree& built_;
  const Solid& solid_;
  const SolidQueries& queries_;
  const PlaneSet planes_;
  PolyhedronClipper clipper_;
  HalfSpaceClipper many_clipper_;
  std::priority_queue<Item> open_;
  std::vector<double> attained_;               // by each level, no less than by those after it
  std::vector<std::vector<bool>> was_opened_;  // nodes, of each level
  std::vector<std::tuple<double, double, std::size_t>> nearest_pieces_;  // scratch
};

ExcessSearch::ExcessSearch(const BuiltOctree& built, const Solid& solid,
                           const SolidQueries& queries, std::span<const GreyRegions> regions)
    : built_(built),
      solid_(solid),
      queries_(queries),
      planes_(built.tree.plane_set()),
      attained_(regions.size(), 0.0) {
  for (std::uint32_t k = 0; k < regions.size(); ++k) attain(regions[k].attained, k + 1);
  for (const Level& level : built.tree.levels) was_opened_.emplace_back(level.kinds.size(), false);
}

void ExcessSearch::attain(double distance, std::uint32_t end_level) {
  for (std::uint32_t k = end_level; k > 0 && attained_[k - 1] < distance; --k) {
    attained_[k - 1] = distance;
  }
}

double ExcessSearch::run(std::uint32_t k, const GreyRegions& regions) {
  for (const GreyRegions::Candidate& candidate : regions.candidates) {
    // What was opened for a level before is still at hand.
    if (was_opened_[candidate.node.level][candidate.node.index]) continue;
    if (candidate.bound <= threshold(k)) continue;
    Item item;
    item.bound = candidate.bound;
    item.kind = Kind::Node;
    item.end_level = k + 1;
    item.region = std::make_shared<Region>(Region{candidate.region, candidate.node, k, {}});
    open_.push(std::move(item));
  }
  std::size_t boxes = 0;
  while (!open_.empty() && open_.top().bound > threshold(k)) {
    if (open_.top().kind != Kind::Node && boxes == kMostBoxes) break;
    Item item = open_.top();
    open_.pop();
    if (item.end_level <= k) continue;  // a node of this level is a candidate itself
    if (!bring_to_level(item, k)) continue;
    if (item.kind == Kind::Node) {
      open_node(item);
    } else {
      item.kind == Kind::Part ? open_part(item) : open_box(item);
      ++boxes;
    }
  }
  return std::max(threshold(k), open_.empty() ? 0.0 : open_.top().bound) + kDistanceRounding;
}

/// Takes away what T_k does not have of a region. False if nothing was taken.
bool ExcessSearch::take_away(std::uint32_t k, Region& region) {
  region.level = k;
  const auto known = std::find_if(region.cuts.begin(), region.cuts.end(),
                                  [&](const Cut& cut) { return cut.level > k; });
  if (known == region.cuts.begin()) return false;
  const bool has_rest = std::all_of(region.cuts.begin(), known, [&](const Cut& cut) {
    return clipper_.clip(region.shape, PlaneRef::of_table(cut.plane), planes_) != ClipResult::Empty;
  });
  if (!has_rest) region.shape = {};
  region.cuts.erase(region.cuts.begin(), known);
  return true;
}

/// False if that put the item off, or left nothing of it.
bool ExcessSearch::bring_to_level(Item& item, std::uint32_t k) {
  if (item.kind == Kind::Part || item.region->level >= k || !take_away(k, *item.region))
    return true;
  if (item.region->shape.faces.empty()) return false;
  if (item.kind == Kind::Leaf) return true;
  const double bound = reach_of(built_, solid_, item.region->node, item.region->shape).bound;
  if (bound >= item.bound) return true;
  item.bound = bound;
  if (is_in_question(item.bound, item.end_level)) open_.push(std::move(item));
  return false;
}

void ExcessSearch::open_node(const Item& item) {
  const NodeAddress& node = item.region->node;
  was_opened_[node.level][node.index] = true;
  const std::uint32_t first_child = built_.tree.levels[node.level].first_child[node.index];
  const auto is_relevant = [&](std::uint32_t octant) {
    const NodeAddress child = node.child(first_child, octant);
    return built_.tree.levels[child.level].kinds[child.index] != NodeKind::Black ||
           !item.region->cuts.empty();
  };
  // The region halved by the three walls, one after the other.
  std::array<std::optional<Polyhedron>, 8> octants;
  octants[0] = item.region->shape;
  for (std::uint32_t axis = 3; axis-- > 0;) {
    const std::uint32_t step = 1u << axis;
    const PlaneRef middle =
        PlaneRef::of_wall(static_cast<int>(axis), node.lower[axis] + node.size() / 2);
    for (std::uint32_t octant = 0; octant < 8; octant += 2 * step) {
      if (!octants[octant]) continue;
      Polyhedron lower;
      Polyhedron upper;
      const auto found = clipper_.split(*octants[octant], middle, planes_, lower, upper);
      octants[octant].reset();
      if (found.inside) octants[octant] = std::move(lower);
      if (found.outside) octants[octant + step] = std::move(upper);
    }
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    if (!octants[octant] || !is_relevant(octant)) continue;
    open_child(node.child(first_child, octant), item, std::move(*octants[octant]));
  }
}

void ExcessSearch::open_child(const NodeAddress& child, const Item& parent, Polyhedron shape) {
  const Level& level = built_.tree.levels[child.level];
  Region region{std::move(shape), child, parent.region->level, parent.region->cuts};
  if (level.kinds[child.index] != NodeKind::Grey) {
    open_leaf(std::move(region), parent.bound);
    return;
  }
  Item item;
  item.kind = Kind::Node;
  item.end_level = child.level;
  item.bound = std::min(parent.bound, reach_of(built_, solid_, child, region.shape).bound);
  if (!is_in_question(item.bound, item.end_level)) return;
  for (const std::uint32_t plane : level.planes_of(child.index)) {
    region.cuts.push_back({child.level, plane});
  }
  item.region = std::make_shared<Region>(std::move(region));
  if (item.bound > kFarBeyond * threshold(parent.region->level)) {
    open_node(item);  // as deep as the tree, at most
  } else {
    open_.push(std::move(item));
  }
}

/// Divides what T_k has of a leaf's cube into pieces of material and parts of the excess.
void ExcessSearch::open_leaf(Region&& of_leaf, double bound) {
  const NodeAddress leaf = of_leaf.node;
  const Level& level = built_.tree.levels[leaf.level];
  const NodeKind kind = level.kinds[leaf.index];
  const auto planes = level.planes_of(leaf.index);
  if (of_leaf.cuts.size() + planes.size() > kMostPlanesDivided) {
    add_undivided(std::move(of_leaf), bound);
    return;
  }
  Polyhedron& region = of_leaf.shape;
  std::vector<Part> parts;
  std::vector<Polyhedron> pieces;
  Polyhedron inside, outside;
  // What is left of the region within the half-space.
  const auto cut = [&](std::uint32_t plane, std::uint32_t of_level) {
    const auto found = clipper_.split(region, PlaneRef::of_table(plane), planes_, inside, outside);
    if (found.outside) parts.push_back({of_level, outside});
    std::swap(region, inside);
    return found.inside;
  };
  bool has_rest = std::all_of(of_leaf.cuts.begin(), of_leaf.cuts.end(),
                              [&](const Cut& by) { return cut(by.plane, by.level); });
  if (has_rest && kind == NodeKind::White) {
    parts.push_back({leaf.level, std::move(region)});
    has_rest = false;
  }
  if (kind == NodeKind::Convex) {
    has_rest = has_rest && std::all_of(planes.begin(), planes.end(),
                                       [&](std::uint32_t plane) { return cut(plane, leaf.level); });
  }
  if (!has_rest) {
    add_parts(std::move(parts), std::move(pieces), bound);
    return;
  }
  if (kind == NodeKind::Black || kind == NodeKind::Convex) {
    pieces.push_back(std::move(region));
    add_parts(std::move(parts), std::move(pieces), bound);
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
    if (*token == kInToken) {
      pieces.push_back(std::move(cell));
      continue;
    }
    if (*token < kFirstPlaneToken) {
      parts.push_back({leaf.level, std::move(cell)});
      continue;
    }
    const PlaneRef plane = PlaneRef::of_table(planes[*token - kFirstPlaneToken]);
    const auto found = clipper_.split(cell, plane, planes_, inside, outside);
    if (found.inside) open.emplace_back(inside, token + 1);
    if (found.outside) open.emplace_back(outside, skip_expression(token + 1));
  }
  add_parts(std::move(parts), std::move(pieces), bound);
}

/// Parts beside pieces of material, which they may cover as thin sheets.
void ExcessSearch::add_parts(std::vector<Part>&& parts, std::vector<Polyhedron>&& shapes,
                             double bound) {
  if (std::none_of(parts.begin(), parts.end(),
                   [&](const Part& part) { return is_in_question(bound, part.level); })) {
    return;
  }
  const auto pieces = std::make_shared<Pieces>();
  for (const Polyhedron& shape : shapes) pieces->extents.push_back(extent_of(shape));
  pieces->largest = static_cast<std::size_t>(
      std::max_element(shapes.begin(), shapes.end(), has_less_volume) - shapes.begin());
  pieces->shapes = std::move(shapes);
  for (Part& part : parts) add_part(std::move(part), pieces, bound);
}

/// The bound by that piece which gives the best, unless any puts the part out of question. A thin
/// part may be as wide as the largest piece, and lie over many small ones: that is tried first,
/// then those whose boxes the part hardly leaves. Where it leaves a box by more than the bound,
/// none of the others can help.
double ExcessSearch::bound_by_pieces(const Part& part, const Extent& extent, const Pieces& pieces,
                                     double bound) {
  if (pieces.shapes.empty()) return bound;
  const auto try_piece = [&](std::size_t piece) {
    bound = std::min(bound, largest_distance(part.shape, pieces.shapes[piece], planes_, bound));
  };
  try_piece(pieces.largest);
  if (!is_in_question(bound, part.level)) return bound;
  nearest_pieces_.clear();
  for (std::size_t i = 0; i < pieces.shapes.size(); ++i) {
    const Extent& of_piece = pieces.extents[i];
    nearest_pieces_.push_back(
        {overhang(extent, of_piece), glm::distance(extent.mean, of_piece.mean), i});
  }
  const std::size_t tried = std::min(nearest_pieces_.size(), kPiecesTried);
  const auto end = nearest_pieces_.begin() + static_cast<std::ptrdiff_t>(tried);
  std::partial_sort(nearest_pieces_.begin(), end, nearest_pieces_.end());
  for (auto near = nearest_pieces_.begin(); near != end; ++near) {
    const auto& [at_least, to_middle, piece] = *near;
    if (at_least >= bound || !is_in_question(bound, part.level)) break;
    if (piece != pieces.largest) try_piece(piece);
  }
  return bound;
}

void ExcessSearch::add_part(Part&& part, const std::shared_ptr<const Pieces>& pieces,
                            double bound) {
  if (!is_in_question(bound, part.level)) return;
  const Extent extent = extent_of(part.shape);
  Item item;
  item.kind = Kind::Part;
  item.end_level = part.level;
  item.centre = extent.centre();
  item.half = 0.5 * (extent.upper - extent.lower);
  item.bound = bound_by_pieces(part, extent, *pieces, bound);
  if (!is_in_question(item.bound, item.end_level)) return;
  // Nothing in a convex part is farther from a triangle than a corner.
  const auto [distance, nearest] = queries_.nearest(extent.mean);
  attain(distance - extent.error, item.end_level);
  double farthest = 0;
  for (const PolyhedronVertex& vertex : part.shape.vertices) {
    farthest = std::max(farthest, queries_.distance_to(nearest, vertex.position) + vertex.error);
    if (farthest >= item.bound) break;
  }
  item.bound = std::min(item.bound, farthest);
  if (!is_in_question(item.bound, item.end_level)) return;
  for (const PolyhedronVertex& vertex : part.shape.vertices) {
    const double attained = attained_[item.end_level - 1];
    attain(queries_.distance_beyond(attained, vertex.position) - vertex.error, item.end_level);
  }
  if (!is_in_question(item.bound, item.end_level)) return;
  item.region = std::make_shared<Region>();
  item.region->shape = std::move(part.shape);
  item.pieces = pieces;
  open_.push(std::move(item));
}

/// Halves a part across its longest side: its halves stay near the surface, where boxes would not.
void ExcessSearch::open_part(const Item& item) {
  const Vec3 half = item.half;
  const int axis = half.x >= half.y && half.x >= half.z ? 0 : (half.y >= half.z ? 1 : 2);
  const double unit = wall_coordinate(planes_.half_side(), 1) + planes_.half_side();
  if (half[axis] < kFewUnits * unit) {
    open_box(item);
    return;
  }
  const auto middle = static_cast<std::uint32_t>((item.centre[axis] + planes_.half_side()) / unit);
  Polyhedron lower;
  Polyhedron upper;
  const auto found =
      clipper_.split(item.region->shape, PlaneRef::of_wall(axis, middle), planes_, lower, upper);
  if (found.inside) add_part({item.end_level, std::move(lower)}, item.pieces, item.bound);
  if (found.outside) add_part({item.end_level, std::move(upper)}, item.pieces, item.bound);
}

/// A leaf with its material in it.
void ExcessSearch::add_undivided(Region&& region, double bound) {
  Item item;
  item.kind = Kind::Leaf;
  item.end_level = region.node.level;
  const Extent extent = extent_of(region.shape);
  item.centre = extent.centre();
  item.half = 0.5 * (extent.upper - extent.lower);
  item.region = std::make_shared<Region>(std::move(region));
  item.bound = std::min({bound, bound_of_undivided(*item.region), bound_of_box(item, false)});
  if (is_in_question(item.bound, item.end_level)) open_.push(std::move(item));
}

/// Notes how far some of its corners are. Where the material is convex, nothing is farther from it
/// than a corner.
double ExcessSearch::bound_of_undivided(const Region& undivided) {
  const std::size_t stride = undivided.shape.vertices.size() / kCornersTried + 1;
  for (std::size_t i = 0; i < undivided.shape.vertices.size(); i += stride) {
    const PolyhedronVertex& vertex = undivided.shape.vertices[i];
    const double attained = attained_[undivided.level];
    const double distance = queries_.distance_beyond(attained, vertex.position) - vertex.error;
    if (distance <= attained) continue;
    if (queries_.side_of(vertex.position) != SolidQueries::Side::In) {
      attain(distance, undivided.level + 1);
    }
  }
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const Level& level = built_.tree.levels[undivided.node.level];
  if (level.kinds[undivided.node.index] != NodeKind::Convex) return kUnknown;
  std::vector<std::uint32_t> planes;
  for (const Cut& cut : undivided.cuts) planes.push_back(cut.plane);
  const auto own = level.planes_of(undivided.node.index);
  planes.insert(planes.end(), own.begin(), own.end());
  Polyhedron piece = undivided.shape;
  if (!many_clipper_.clip(piece, planes, planes_)) return kUnknown;
  return largest_distance(corners_cut_off(undivided.shape, piece), piece, planes_);
}

/// Nothing in the excess and the box is farther from the solid: not than the farthest corner of the
/// box from the triangle nearest to its centre. Notes how far the centre is, if it belongs to the
/// excess.
double ExcessSearch::bound_of_box(const Item& box, bool centre_is_in_region) {
  // Within this distance of the surface the whole box is out of question.
  const double half_diagonal = glm::length(box.half);
  const double near_enough = threshold(box.end_level - 1) - half_diagonal;
  const auto [distance, triangle] = queries_.nearest(box.centre, near_enough);
  if (distance <= near_enough) return distance + half_diagonal;
  // From material, the way to what is beyond it leads through the boundary.
  if (box.kind == Kind::Leaf && queries_.side_of(box.centre) == SolidQueries::Side::In) {
    return std::max(0.0, half_diagonal - distance);
  }
  if (centre_is_in_region) {
    attain(distance, box.kind == Kind::Leaf ? box.region->level + 1 : box.end_level);
  }
  double farthest = 0;
  for (unsigned octant = 0; octant < 8; ++octant) {
    Vec3 corner = box.centre;
    for (int axis = 0; axis < 3; ++axis) {
      corner[axis] += ((octant >> axis) & 1) ? box.half[axis] : -box.half[axis];
    }
    farthest = std::max(farthest, queries_.distance_to(triangle, corner));
  }
  return farthest;
}

void ExcessSearch::open_box(const Item& item) {
  for (unsigned octant = 0; octant < 8; ++octant) {
    Item part = item;
    part.half = 0.5 * item.half;
    for (int axis = 0; axis < 3; ++axis) {
      part.centre[axis] += ((octant >> axis) & 1) ? part.half[axis] : -part.half[axis];
    }
    bool centre_is_inside = false;
    if (!may_meet(item.region->shape, planes_, part.centre, part.half, centre_is_inside)) continue;
    part.bound = std::min(item.bound, bound_of_box(part, centre_is_inside));
    if (is_in_question(part.bound, part.end_level)) open_.push(std::move(part));
  }
}

}  // namespace

std::vector<double> error_bounds(std::span<const GreyRegions> regions, const BuiltOctree& built,
                                 const Solid& solid, const SolidQueries& queries) {
  ExcessSearch search(built, solid, queries, regions);
  std::vector<double> bounds;
  for (std::uint32_t k = 0; k < regions.size(); ++k) {
    bounds.push_back(built.tree.levels[k].grey_count > 0 ? search.run(k, regions[k]) : 0.0);
  }
  return bounds;
}

}  // namespace spoctree
