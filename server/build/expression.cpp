#include "server/build/expression.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "common/geometry/predicates.hpp"
#include "common/tree/octree.hpp"
#include "server/build/reach_boxes.hpp"

namespace spoctree {

namespace {

constexpr std::int32_t kNone = -1;

/// So many polygons are worth looking for all planes that have the others on one side.
constexpr std::size_t kManyPolygons = 96;
/// Not deeper than this: an expression may have 4096 splits within each other.
constexpr std::size_t kMostPeeledDepth = 2048;

/// A plane that bounds polygons: a plane of the solid, or a wall of the cell.
struct Cutter {
  Plane plane;
  std::int32_t solid_plane = kNone;
};

/// A corner of a polygon on some plane of the solid: a vertex of the solid (first == kNone), the
/// point where the edge from a to b meets cutter `first` (second == kNone), or the point where the
/// polygon's plane meets two cutters.
struct Corner {
  Vec3 position{0.0};
  double error = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::int32_t first = kNone;
  std::int32_t second = kNone;
  /// What the edge that leaves this corner lies on: a cutter, or (kNone) the solid's edge.
  std::int32_t edge_cutter = kNone;
  std::uint32_t edge_a = 0;
  std::uint32_t edge_b = 0;
};

struct Polygon {
  std::uint32_t plane = 0;  ///< of the solid
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
};

}  // namespace

struct ExpressionBuilder::Work {
 public:
  Work(const Solid& solid, const Incidence& incidence)
      : solid_(solid), incidence_(incidence), doubt_(CornerSides(solid, incidence).doubt()) {}

  const Expression& build(const FragmentList& boundary, std::span<const Fragment> remaining) {
    cutters_.clear();
    polygons_.clear();
    corners_.clear();
    result_.planes.clear();
    result_.tokens.clear();
    index_of_plane_.clear();
    cutter_of_plane_.clear();
    for (const Fragment& fragment : remaining) {
      add_polygon(fragment, boundary.corners_of(fragment));
    }
    split(0, 0);
    return result_;
  }

 private:
  std::span<const Corner> corners_of(const Polygon& polygon) const {
    return {corners_.data() + polygon.first_corner, polygon.corner_count};
  }

  Polygon& begin_polygon(std::uint32_t plane) {
    polygons_.push_back({plane, static_cast<std::uint32_t>(corners_.size()), 0});
    return polygons_.back();
  }

  void end_polygon(Polygon& polygon) {
    polygon.corner_count = static_cast<std::uint32_t>(corners_.size()) - polygon.first_corner;
  }

  void add_polygon(const Fragment& fragment, std::span<const FragmentCorner> corners) {
    const SolidTriangle& triangle = solid_.triangles[fragment.triangle];
    Polygon& polygon = begin_polygon(solid_.facet_plane[triangle.facet]);
    for (const FragmentCorner& source : corners) {
      Corner corner;
      corner.position = source.position;
      corner.error = source.error;
      corner.a = source.a;
      corner.b = source.b;
      if (source.origin != FragmentCorner::Origin::Vertex) {
        corner.first = wall(source.axis, source.position[source.axis]);
      }
      if (source.origin == FragmentCorner::Origin::Face) {
        corner.second = wall(source.second_axis, source.position[source.second_axis]);
      }
      if (source.edge < 3) {
        corner.edge_a = triangle.vertex[source.edge];
        corner.edge_b = triangle.vertex[(source.edge + 1) % 3];
      } else {
        corner.edge_cutter = wall(source.edge - 3, source.position[source.edge - 3]);
      }
      corners_.push_back(corner);
    }
    end_polygon(polygon);
  }

  std::int32_t wall(int axis, double coordinate) {
    Plane plane;
    plane.normal[axis] = 1.0;
    plane.offset = coordinate;
    // All walls come first, and there are six.
    for (std::size_t i = 0; i < cutters_.size(); ++i) {
      if (cutters_[i].plane == plane) return static_cast<std::int32_t>(i);
    }
    cutters_.push_back({plane, kNone});
    return static_cast<std::int32_t>(cutters_.size()) - 1;
  }

  std::int32_t cutter(std::uint32_t solid_plane) {
    const auto number = static_cast<std::int32_t>(solid_plane);
    const auto [entry, is_new] =
        cutter_of_plane_.try_emplace(number, static_cast<std::int32_t>(cutters_.size()));
    if (is_new) cutters_.push_back({solid_.planes[solid_plane], number});
    return entry->second;
  }

  bool is_on(std::uint32_t vertex, std::uint32_t plane) const {
    return incidence_.is_on(vertex, plane);
  }

  int side(const Corner& corner, std::uint32_t polygon_plane, std::uint32_t plane) const {
    const Plane& p = solid_.planes[plane];
    const double value = glm::dot(p.normal, corner.position) - p.offset;
    if (std::abs(value) > doubt_ + 2 * corner.error) return value > 0 ? 1 : -1;
    if (corner.first == kNone) {
      if (is_on(corner.a, plane)) return 0;
      return side_of_point(p, solid_.vertices[corner.a]);
    }
    const auto is_plane = [&](std::int32_t index) {
      return cutters_[static_cast<std::size_t>(index)].solid_plane ==
             static_cast<std::int32_t>(plane);
    };
    const auto& first = cutters_[static_cast<std::size_t>(corner.first)];
    if (is_plane(corner.first)) return 0;
    if (corner.second == kNone) {
      if (is_on(corner.a, plane) && is_on(corner.b, plane)) return 0;
      return side_of_crossing(solid_.vertices[corner.a], solid_.vertices[corner.b], first.plane, p);
    }
    if (is_plane(corner.second) || polygon_plane == plane) return 0;
    return side_of_intersection(solid_.planes[polygon_plane], first.plane,
                                cutters_[static_cast<std::size_t>(corner.second)].plane, p);
  }

  /// On which sides of a plane a polygon certainly has a part.
  struct Reach {
    bool inside = false;
    bool outside = false;
  };

  /// The polygon's corners come from the solid's vertices, the planes are those vertices' planes
  /// rounded to the grid: closer to each other than `doubt_`, the two may disagree, and a part of
  /// the polygon that nowhere leaves this band is no evidence of material beyond it. (To believe
  /// such a part is not harmless: all of a region would be labelled by it.)
  Reach reach_of(const Polygon& polygon, std::uint32_t plane) const {
    const Plane& p = solid_.planes[plane];
    Reach reach;
    for (const Corner& corner : corners_of(polygon)) {
      const double value = glm::dot(p.normal, corner.position) - p.offset;
      const double certain = doubt_ + 2 * corner.error;
      reach.inside |= value < -certain;
      reach.outside |= value > certain;
    }
    return reach;
  }

  /// The corner in which the edge that leaves `from` meets plane `cut`.
  Corner cross(const Corner& from, std::uint32_t polygon_plane, std::int32_t cut) const {
    const Plane& cut_plane = cutters_[static_cast<std::size_t>(cut)].plane;
    Corner corner;
    corner.first = cut;
    ApproximatePoint point;
    if (from.edge_cutter == kNone) {
      corner.a = std::min(from.edge_a, from.edge_b);
      corner.b = std::max(from.edge_a, from.edge_b);
      point = crossing_point(solid_.vertices[corner.a], solid_.vertices[corner.b], cut_plane);
    } else {
      corner.second = from.edge_cutter;
      point = intersection_point(solid_.planes[polygon_plane], cut_plane,
                                 cutters_[static_cast<std::size_t>(from.edge_cutter)].plane);
    }
    corner.position = point.position;
    corner.error = point.error;
    return corner;
  }

  /// Appends the half of a polygon on the side of `keep` (-1 or +1) of plane `cut`.
  void add_half(const Polygon polygon, int keep, std::int32_t cut) {
    Polygon& part = begin_polygon(polygon.plane);
    for (std::uint32_t i = 0; i < polygon.corner_count; ++i) {
      const std::uint32_t j = i + 1 == polygon.corner_count ? 0 : i + 1;
      const Corner corner = corners_[polygon.first_corner + i];
      const int here = sides_[i] * keep;
      const int there = sides_[j] * keep;
      if (here >= 0) {
        corners_.push_back(corner);
        if (here == 0 && there < 0) corners_.back().edge_cutter = cut;
      }
      if (here * there < 0) {
        Corner added = cross(corner, polygon.plane, cut);
        added.edge_cutter = cut;
        if (here < 0) {
          added.edge_cutter = corner.edge_cutter;
          added.edge_a = corner.edge_a;
          added.edge_b = corner.edge_b;
        }
        corners_.push_back(added);
      }
    }
    end_polygon(part);
  }

  struct Choice {
    std::uint32_t plane = 0;
    std::size_t score = static_cast<std::size_t>(-1);  ///< what is left to be split, about
  };
  /// The plane that cuts the fewest polygons; among those the one that balances best. A polygon of
  /// another plane that lies on it, as where two parts end at one plane from both sides, would be
  /// known by the name of the plane chosen, and in the next cell by its own: a seam for those who
  /// rebuild. Other planes first, which may tell the two apart.
  Choice choose_plane(std::span<const Polygon> polygons) {
    // Trying every plane is quadratic: a sample does for the rare big cells.
    constexpr std::size_t kCandidates = 24;
    constexpr std::size_t kRenaming = 1024;
    const std::size_t stride = polygons.size() < kManyPolygons ? 1 : polygons.size() / kCandidates;
    candidates_.clear();
    for (std::size_t i = 0; i < polygons.size(); i += stride) {
      const std::uint32_t plane = polygons[i].plane;
      if (std::find(candidates_.begin(), candidates_.end(), plane) == candidates_.end()) {
        candidates_.push_back(plane);
        if (candidates_.size() == kCandidates) break;
      }
    }
    Choice best;
    best.plane = candidates_.front();
    if (candidates_.size() == 1) return best;
    for (const std::uint32_t plane : candidates_) {
      std::size_t cuts = 0;
      std::size_t inside = 0;
      std::size_t outside = 0;
      std::size_t renamed = 0;
      for (const Polygon& polygon : polygons) {
        if (polygon.plane == plane) continue;
        const Reach reach = reach_of(polygon, plane);
        cuts += reach.inside && reach.outside;
        inside += reach.inside;
        outside += reach.outside;
        renamed += !reach.inside && !reach.outside;
      }
      const std::size_t score = 8 * cuts + std::max(inside, outside) + kRenaming * renamed;
      if (score < best.score) best = {plane, score};
    }
    return best;
  }

  std::uint32_t token_of(std::uint32_t plane) {
    const auto [entry, is_new] =
        index_of_plane_.try_emplace(plane, static_cast<std::uint32_t>(result_.planes.size()));
    if (is_new) result_.planes.push_back(plane);
    return kFirstPlaneToken + entry->second;
  }

  /// Takes off the polygons from `begin` on whose planes have all the others on one side, `most`
  /// planes at most, and appends their tokens, those that are to follow after what is left to
  /// `closing`. Those planes stay such planes whatever else is taken off, so all are found at once:
  /// one by one they would take as many splits. Returns how many. O(n log n).
  std::size_t peel(std::size_t begin, std::size_t most, std::vector<std::uint32_t>& closing) {
    const std::size_t end = polygons_.size();
    reach_boxes_.clear();
    for (std::size_t i = begin; i < end; ++i) {
      for (const Corner& corner : corners_of(polygons_[i])) {
        reach_boxes_.add(corner.position, corner.error);
      }
    }
    reach_boxes_.prepare();
    std::unordered_map<std::uint32_t, bool> is_peeled;  // planes
    std::size_t count = 0;
    is_gone_.assign(end - begin, 0);
    // Nothing is left to tell apart by what lies on the plane. That is found beside it.
    const auto drop = [&](std::size_t i, std::uint32_t plane) {
      if (is_gone_[i - begin] != 0) return true;
      const Reach reach = reach_of(polygons_[i], plane);
      if (reach.inside || reach.outside) return false;
      is_gone_[i - begin] = 1;
      return true;
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (is_gone_[i - begin] != 0 || count == most) continue;
      const std::uint32_t plane = polygons_[i].plane;
      const auto [entry, is_new] = is_peeled.try_emplace(plane, false);
      if (!is_new) continue;
      const Plane& p = solid_.planes[plane];
      const bool has_outside = reach_boxes_.any_beyond(p.normal, p.offset, doubt_);
      if (has_outside && reach_boxes_.any_beyond(-p.normal, -p.offset, doubt_)) continue;
      entry->second = true;
      ++count;
      result_.tokens.push_back(token_of(plane));
      // The last one's other side is without boundary, too, if nothing is left.
      if (has_outside) result_.tokens.push_back(kInToken);
      if (!has_outside) closing.push_back(kOutToken);
      last_peeled_has_outside_ = has_outside;
      for (std::size_t j = i; j < end && drop(j, plane);) ++j;
      for (std::size_t j = i; j > begin && drop(j - 1, plane);) --j;
    }
    std::size_t kept = begin;
    for (std::size_t i = begin; i < end; ++i) {
      const auto entry = is_peeled.find(polygons_[i].plane);
      if (is_gone_[i - begin] != 0 || (entry != is_peeled.end() && entry->second)) continue;
      polygons_[kept++] = polygons_[i];
    }
    polygons_.resize(kept);
    return count;
  }

  /// Splits by the polygons from `begin` on, and takes them off. Every region without boundary
  /// inside is homogeneous. Inside the plane just used, next to a piece of boundary on it, lies
  /// material; outside, none (but see labels_of).
  ///
  /// Most planes of a vertex with many faces have nearly all others on one side: where no better
  /// one is found, those that have all are taken off first.
  void split(std::size_t begin, std::size_t depth) {
    std::vector<std::uint32_t> closing;
    Choice chosen = choose_plane(std::span(polygons_).subspan(begin));
    for (std::size_t count = polygons_.size() - begin;
         count >= kManyPolygons && chosen.score > count - count / 8 && depth < kMostPeeledDepth;
         count = polygons_.size() - begin) {
      const std::size_t peeled = peel(begin, kMostPeeledDepth - depth, closing);
      depth += peeled;
      if (peeled == 0 || polygons_.size() == begin) break;
      chosen = choose_plane(std::span(polygons_).subspan(begin));
    }
    if (polygons_.size() > begin) {
      split_by(chosen.plane, begin, depth);
    } else {
      result_.tokens.push_back(last_peeled_has_outside_ ? kOutToken : kInToken);
    }
    result_.tokens.insert(result_.tokens.end(), closing.begin(), closing.end());
  }

  double area_of(const Polygon& polygon) const {
    const auto corners = corners_of(polygon);
    Vec3 sum{0.0};
    for (std::size_t i = 2; i < corners.size(); ++i) {
      sum += glm::cross(corners[i - 1].position - corners[0].position,
                        corners[i].position - corners[0].position);
    }
    return 0.5 * glm::length(sum);
  }

  /// What the polygons from `begin` on that lie on a plane say of its two sides: In or Out, for a
  /// side that has no other boundary, and so is all the one or all the other. Where a wall faces
  /// each way, closer together than rounding, there is material on both sides. Slivers of either
  /// may be there by rounding.
  std::array<std::uint32_t, 2> labels_of(std::uint32_t plane, std::size_t begin, std::size_t end) {
    double along = 0;
    double against = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Polygon& polygon = polygons_[i];
      if (polygon.plane != plane) {
        const Reach reach = reach_of(polygon, plane);
        if (reach.inside || reach.outside) continue;
      }
      const bool is_along =
          glm::dot(solid_.planes[polygon.plane].normal, solid_.planes[plane].normal) > 0;
      (is_along ? along : against) += area_of(polygon);
    }
    return {2 * along >= against ? kInToken : kOutToken,
            against > 0 && 2 * against >= along ? kInToken : kOutToken};
  }

  void split_by(std::uint32_t plane, std::size_t begin, std::size_t depth) {
    const std::size_t end = polygons_.size();
    const std::size_t first_corner = corners_.size();
    const std::int32_t cut = cutter(plane);
    result_.tokens.push_back(token_of(plane));
    bool has_others_on_it = false;
    const auto label = [&](int keep) {
      if (!has_others_on_it) return keep < 0 ? kInToken : kOutToken;
      return labels_of(plane, begin, end)[keep < 0 ? 0 : 1];
    };
    for (const int keep : {-1, +1}) {
      for (std::size_t i = begin; i < end; ++i) {
        const Polygon polygon = polygons_[i];
        if (polygon.plane == plane) continue;
        // Where it reaches neither side, it lies on the plane: nothing is left to tell apart.
        const Reach reach = reach_of(polygon, plane);
        if (reach.inside && reach.outside) {
          sides_.clear();
          for (const Corner& corner : corners_of(polygon)) {
            sides_.push_back(side(corner, polygon.plane, plane));
          }
          add_half(polygon, keep, cut);
        } else if (keep < 0 ? reach.inside : reach.outside) {
          polygons_.push_back(polygon);
        }
        has_others_on_it |= !reach.inside && !reach.outside;
      }
      if (polygons_.size() > end) {
        split(end, depth + 1);
      } else {
        result_.tokens.push_back(label(keep));
      }
      corners_.resize(first_corner);
    }
    polygons_.resize(begin);
  }

  const Solid& solid_;
  const Incidence& incidence_;
  const double doubt_;
  std::vector<Cutter> cutters_;
  // The polygons of all splits that are under way, the last one's at the end, and their corners.
  std::vector<Polygon> polygons_;
  std::vector<Corner> corners_;
  // Of the split at hand.
  std::vector<int> sides_;
  std::vector<std::uint32_t> candidates_;
  ReachBoxes reach_boxes_;
  bool last_peeled_has_outside_ = false;
  std::vector<std::uint8_t> is_gone_;                                // polygons
  std::unordered_map<std::uint32_t, std::uint32_t> index_of_plane_;  // in the result
  std::unordered_map<std::int32_t, std::int32_t> cutter_of_plane_;   // of the solid
  Expression result_;
};

ExpressionBuilder::ExpressionBuilder(const Solid& solid, const Incidence& incidence)
    : work_(std::make_unique<Work>(solid, incidence)) {}
ExpressionBuilder::~ExpressionBuilder() = default;
ExpressionBuilder::ExpressionBuilder(ExpressionBuilder&&) noexcept = default;

const Expression& ExpressionBuilder::build(const FragmentList& boundary,
                                           std::span<const Fragment> remaining) {
  return work_->build(boundary, remaining);
}

}  // namespace spoctree
