#include "server/build/expression.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "common/geometry/predicates.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

namespace {

constexpr std::int32_t kNone = -1;

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
  std::vector<Corner> corners;
};

class ExpressionBuilder {
 public:
  ExpressionBuilder(const Solid& solid, const Incidence& incidence)
      : solid_(solid), incidence_(incidence), doubt_(CornerSides(solid, incidence).doubt()) {}

  Expression build(const FragmentList& boundary, std::span<const Fragment> remaining) {
    std::vector<Polygon> polygons;
    for (const Fragment& fragment : remaining) {
      polygons.push_back(polygon_of(fragment, boundary.corners_of(fragment)));
    }
    split(std::move(polygons));
    return std::move(result_);
  }

 private:
  Polygon polygon_of(const Fragment& fragment, std::span<const FragmentCorner> corners) {
    const SolidTriangle& triangle = solid_.triangles[fragment.triangle];
    Polygon polygon;
    polygon.plane = solid_.facet_plane[triangle.facet];
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
      polygon.corners.push_back(corner);
    }
    return polygon;
  }

  std::int32_t wall(int axis, double coordinate) {
    Plane plane;
    plane.normal[axis] = 1.0;
    plane.offset = coordinate;
    return cutter(plane, kNone);
  }

  std::int32_t cutter(const Plane& plane, std::int32_t solid_plane) {
    for (std::size_t i = 0; i < cutters_.size(); ++i) {
      if (cutters_[i].solid_plane == solid_plane && cutters_[i].plane == plane) {
        return static_cast<std::int32_t>(i);
      }
    }
    cutters_.push_back({plane, solid_plane});
    return static_cast<std::int32_t>(cutters_.size()) - 1;
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
    for (const Corner& corner : polygon.corners) {
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

  Polygon half(const Polygon& polygon, const std::vector<int>& side, int keep,
               std::int32_t cut) const {
    Polygon part;
    part.plane = polygon.plane;
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = i + 1 == count ? 0 : i + 1;
      const int here = side[i] * keep;
      const int there = side[j] * keep;
      if (here >= 0) {
        part.corners.push_back(polygon.corners[i]);
        if (here == 0 && there < 0) part.corners.back().edge_cutter = cut;
      }
      if (here * there < 0) {
        Corner added = cross(polygon.corners[i], polygon.plane, cut);
        added.edge_cutter = cut;
        if (here < 0) {
          added.edge_cutter = polygon.corners[i].edge_cutter;
          added.edge_a = polygon.corners[i].edge_a;
          added.edge_b = polygon.corners[i].edge_b;
        }
        part.corners.push_back(added);
      }
    }
    return part;
  }

  /// The plane that cuts the fewest polygons; among those the one that balances best.
  std::uint32_t choose_plane(const std::vector<Polygon>& polygons) const {
    // Trying every plane is quadratic: a sample does for the rare big cells.
    constexpr std::size_t kCandidates = 24;
    std::vector<std::uint32_t> planes;
    for (const Polygon& polygon : polygons) {
      if (std::find(planes.begin(), planes.end(), polygon.plane) == planes.end()) {
        planes.push_back(polygon.plane);
        if (planes.size() == kCandidates) break;
      }
    }
    std::size_t best_score = static_cast<std::size_t>(-1);
    std::uint32_t best = planes.front();
    for (const std::uint32_t plane : planes) {
      std::size_t cuts = 0;
      std::size_t inside = 0;
      std::size_t outside = 0;
      for (const Polygon& polygon : polygons) {
        if (polygon.plane == plane) continue;
        const Reach reach = reach_of(polygon, plane);
        cuts += reach.inside && reach.outside;
        inside += reach.inside;
        outside += reach.outside;
      }
      const std::size_t score = 8 * cuts + std::max(inside, outside);
      if (score < best_score) {
        best_score = score;
        best = plane;
      }
    }
    return best;
  }

  std::uint32_t token_of(std::uint32_t plane) {
    const auto at = std::find(result_.planes.begin(), result_.planes.end(), plane);
    const auto index = static_cast<std::uint32_t>(at - result_.planes.begin());
    if (at == result_.planes.end()) result_.planes.push_back(plane);
    return kFirstPlaneToken + index;
  }

  /// Every region without boundary inside is homogeneous. Inside the plane just used, next to a
  /// piece of boundary on it, lies material; outside, none.
  void split(std::vector<Polygon> polygons) {
    const std::uint32_t plane = choose_plane(polygons);
    const std::int32_t cut = cutter(solid_.planes[plane], static_cast<std::int32_t>(plane));
    std::vector<Polygon> inside;
    std::vector<Polygon> outside;
    std::vector<int> sides;
    for (Polygon& polygon : polygons) {
      if (polygon.plane == plane) continue;
      const Reach reach = reach_of(polygon, plane);
      if (reach.inside && reach.outside) {
        sides.clear();
        for (const Corner& corner : polygon.corners) {
          sides.push_back(side(corner, polygon.plane, plane));
        }
        inside.push_back(half(polygon, sides, -1, cut));
        outside.push_back(half(polygon, sides, +1, cut));
      } else if (reach.inside) {
        inside.push_back(std::move(polygon));
      } else if (reach.outside) {
        outside.push_back(std::move(polygon));
      }  // else it lies on the plane: nothing is left to tell apart
    }
    polygons.clear();
    result_.tokens.push_back(token_of(plane));
    if (inside.empty()) {
      result_.tokens.push_back(kInToken);
    } else {
      split(std::move(inside));
    }
    if (outside.empty()) {
      result_.tokens.push_back(kOutToken);
    } else {
      split(std::move(outside));
    }
  }

  const Solid& solid_;
  const Incidence& incidence_;
  const double doubt_;
  std::vector<Cutter> cutters_;
  Expression result_;
};

}  // namespace

Expression build_expression(const FragmentList& boundary, std::span<const Fragment> remaining,
                            const Solid& solid, const Incidence& incidence) {
  return ExpressionBuilder(solid, incidence).build(boundary, remaining);
}

}  // namespace spoctree
