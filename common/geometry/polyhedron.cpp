#include "common/geometry/polyhedron.hpp"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"

namespace spoctree {

void Polyhedron::clear() {
  vertices.clear();
  corners.clear();
  faces.clear();
}

Polyhedron make_cell(const std::uint32_t (&lower)[3], std::uint32_t size, const PlaneSet& planes) {
  Polyhedron cell;
  const auto wall = [&](int axis, bool upper) {
    return upper ? PlaneRef::of_wall(axis, lower[axis] + size)
                 : PlaneRef::of_wall(axis, lower[axis]).flipped();
  };
  for (int corner = 0; corner < 8; ++corner) {
    PolyhedronVertex vertex;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = ((corner >> axis) & 1) != 0;
      vertex.planes[axis] = wall(axis, upper);
      vertex.position[axis] = wall_coordinate(planes.half_side(), lower[axis] + (upper ? size : 0));
    }
    cell.vertices.push_back(vertex);
  }
  for (int axis = 0; axis < 3; ++axis) {
    // With (u, v) the next axes in cyclic order, +axis is seen counter-clockwise as 00 10 11 01.
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      const auto first = static_cast<std::uint32_t>(cell.corners.size());
      const std::uint32_t base = upper ? 1u << axis : 0u;
      const std::uint32_t ring[4] = {base, base | 1u << u, base | 1u << u | 1u << v,
                                     base | 1u << v};
      // The edge from ring[k] to ring[k + 1] lies on these walls.
      const PlaneRef across[4] = {wall(v, false), wall(u, true), wall(v, true), wall(u, false)};
      for (int k = 0; k < 4; ++k) {
        if (upper) {
          cell.corners.push_back({ring[k], across[k]});
        } else {
          const int r = 3 - k;  // reversed: from ring[r] to ring[r - 1]
          cell.corners.push_back({ring[r], across[(r + 3) % 4]});
        }
      }
      cell.faces.push_back({wall(axis, upper), first, 4});
    }
  }
  return cell;
}

namespace {

/// side_of_vertex for a plane that is at hand.
int side_of(const PolyhedronVertex& vertex, PlaneRef carrier, const Plane& plane,
            const PlaneSet& planes) {
  const double value = glm::dot(plane.normal, vertex.position) - plane.offset;
  // The rounding of this expression, plus the vertex's own error seen along a unit normal.
  if (std::abs(value) > 0x1p-47 + 2 * vertex.error) return value > 0 ? 1 : -1;
  for (const PlaneRef own : vertex.planes) {
    if (own.carrier() == carrier) return 0;
  }
  return side_of_intersection(planes[vertex.planes[0]], planes[vertex.planes[1]],
                              planes[vertex.planes[2]], plane);
}

}  // namespace

int side_of_vertex(const PolyhedronVertex& vertex, PlaneRef plane, const PlaneSet& planes) {
  return side_of(vertex, plane.carrier(), planes[plane], planes);
}

ClipResult PolyhedronClipper::clip(Polyhedron& polyhedron, PlaneRef plane, const PlaneSet& planes) {
  const Plane coefficients = planes[plane];
  const Parts parts = find_sides(polyhedron, plane, coefficients, planes);
  if (!parts.inside) return ClipResult::Empty;
  if (!parts.outside) return ClipResult::Unchanged;
  crossings_.clear();
  make_part(polyhedron, -1, plane, coefficients, planes, result_);
  std::swap(polyhedron, result_);
  return ClipResult::Cut;
}

PolyhedronClipper::Parts PolyhedronClipper::split(const Polyhedron& whole, PlaneRef plane,
                                                  const PlaneSet& planes, Polyhedron& inside,
                                                  Polyhedron& outside) {
  const Plane coefficients = planes[plane];
  const Parts parts = find_sides(whole, plane, coefficients, planes);
  if (!parts.outside) {
    inside = whole;
  } else if (!parts.inside) {
    outside = whole;
  } else {
    crossings_.clear();
    make_part(whole, -1, plane, coefficients, planes, inside);
    make_part(whole, 1, plane.flipped(), coefficients, planes, outside);
  }
  return parts;
}

PolyhedronClipper::Parts PolyhedronClipper::find_sides(const Polyhedron& polyhedron, PlaneRef plane,
                                                       const Plane& coefficients,
                                                       const PlaneSet& planes) {
  Parts parts;
  side_.resize(polyhedron.vertices.size());
  for (std::size_t i = 0; i < side_.size(); ++i) {
    side_[i] = static_cast<signed char>(
        side_of(polyhedron.vertices[i], plane.carrier(), coefficients, planes));
    parts.inside |= side_[i] < 0;
    parts.outside |= side_[i] > 0;
  }
  return parts;
}

/// The two faces of an edge see it in opposite directions, and so do the two parts: they share the
/// new vertex.
std::uint32_t PolyhedronClipper::cross(std::uint32_t u, std::uint32_t v, PlaneRef face,
                                       PlaneRef across, PlaneRef plane, const Plane& coefficients,
                                       const PlaneSet& planes, Polyhedron& part) {
  const std::uint32_t from = std::min(u, v);
  const std::uint32_t to = std::max(u, v);
  auto found = std::find_if(crossings_.begin(), crossings_.end(), [&](const Crossing& crossing) {
    return crossing.from == from && crossing.to == to;
  });
  if (found == crossings_.end()) {
    const ApproximatePoint point = intersection_point(planes[face], planes[across], coefficients);
    crossings_.push_back({from, to, {point.position, point.error, {face, across, plane}}, kNone});
    found = crossings_.end() - 1;
  }
  if (found->vertex == kNone) {
    found->vertex = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back(found->point);
    part.vertices.back().planes[2] = plane;
  }
  return found->vertex;
}

/// `part` becomes what lies on `kept_side`; `plane` is oriented away from it.
void PolyhedronClipper::make_part(const Polyhedron& polyhedron, int kept_side, PlaneRef plane,
                                  const Plane& coefficients, const PlaneSet& planes,
                                  Polyhedron& part) {
  part.clear();
  rim_.clear();
  for (Crossing& crossing : crossings_) crossing.vertex = kNone;
  renumbered_.assign(polyhedron.vertices.size(), kNone);
  // Below zero what is kept, above zero what is not.
  const int turn = -kept_side;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const auto loop = polyhedron.loop(face);
    if (std::none_of(loop.begin(), loop.end(),
                     [&](const auto& corner) { return side_[corner.vertex] == kept_side; })) {
      continue;
    }
    const auto first = static_cast<std::uint32_t>(part.corners.size());
    int there = side_[loop[0].vertex] * turn;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto& corner = loop[k];
      const std::uint32_t next = loop[k + 1 == loop.size() ? 0 : k + 1].vertex;
      const int here = there;
      there = side_[next] * turn;
      if (here <= 0) {
        std::uint32_t& number = renumbered_[corner.vertex];
        if (number == kNone) {
          number = static_cast<std::uint32_t>(part.vertices.size());
          part.vertices.push_back(polyhedron.vertices[corner.vertex]);
        }
        // An edge that leaves the inner side, or touches the plane with both ends, continues (or
        // lies) on the rim; otherwise it stays the edge it was.
        const bool on_rim = here == 0 && there >= 0;
        part.corners.push_back({number, on_rim ? plane : corner.across});
      }
      if (here * there < 0) {
        const std::uint32_t vertex = cross(corner.vertex, next, face.plane, corner.across, plane,
                                           coefficients, planes, part);
        part.corners.push_back({vertex, here < 0 ? plane : corner.across});
      }
    }
    const auto count = static_cast<std::uint32_t>(part.corners.size()) - first;
    part.faces.push_back({face.plane, first, count});
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto& corner = part.corners[first + k];
      if (corner.across != plane) continue;
      const auto& next = part.corners[first + (k + 1 == count ? 0 : k + 1)];
      rim_.push_back({next.vertex, corner.vertex, face.plane});
    }
  }
  close_rim(plane, part);
}

/// The new face: the rim, seen from outside.
void PolyhedronClipper::close_rim(PlaneRef plane, Polyhedron& part) {
  const auto first = static_cast<std::uint32_t>(part.corners.size());
  std::uint32_t at = rim_.front().from;
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const auto edge =
        std::find_if(rim_.begin(), rim_.end(), [&](const Rim& rim) { return rim.from == at; });
    assert(edge != rim_.end());
    part.corners.push_back({at, edge->inside});
    at = edge->to;
  }
  assert(at == rim_.front().from);
  part.faces.push_back({plane, first, static_cast<std::uint32_t>(rim_.size())});
}

double volume(const Polyhedron& polyhedron) {
  if (polyhedron.vertices.empty()) return 0;
  const Vec3 origin = polyhedron.vertices.front().position;
  double six_volumes = 0;
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const auto loop = polyhedron.loop(face);
    const Vec3 a = polyhedron.vertices[loop[0].vertex].position - origin;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const Vec3 b = polyhedron.vertices[loop[k].vertex].position - origin;
      const Vec3 c = polyhedron.vertices[loop[k + 1].vertex].position - origin;
      six_volumes += glm::dot(a, glm::cross(b, c));
    }
  }
  return six_volumes / 6;
}

}  // namespace spoctree
