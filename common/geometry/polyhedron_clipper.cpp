#include "common/geometry/polyhedron_clipper.hpp"

#include <algorithm>
#include <cassert>

#include "common/geometry/edge_crossing.hpp"

namespace spoctree {

int side_of_vertex(const PolyhedronVertex& vertex, PlaneRef plane, const PlaneSet& planes) {
  const Plane coefficients = planes[plane];
  return side_of_vertex(vertex, value_at(vertex, coefficients), plane.carrier(), coefficients,
                        planes);
}

ClipResult PolyhedronClipper::clip(Polyhedron& polyhedron, PlaneRef plane, const PlaneSet& planes) {
  const ClipResult result = cut(polyhedron, plane, planes, result_);
  if (result == ClipResult::Cut) std::swap(polyhedron, result_);
  return result;
}

ClipResult PolyhedronClipper::cut(const Polyhedron& whole, PlaneRef plane, const PlaneSet& planes,
                                  Polyhedron& part) {
  const Plane coefficients = planes[plane];
  const Parts parts = find_sides(whole, plane, coefficients, planes);
  if (!parts.inside) return ClipResult::Empty;
  if (!parts.outside) return ClipResult::Unchanged;
  find_crossings(whole, plane, planes);
  make_part(whole, true, plane, part);
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
    find_crossings(whole, plane, planes);
    make_part(whole, true, plane, inside);
    make_part(whole, false, plane.flipped(), outside);
  }
  return parts;
}

PolyhedronClipper::Parts PolyhedronClipper::find_sides(const Polyhedron& polyhedron, PlaneRef plane,
                                                       const Plane& coefficients,
                                                       const PlaneSet& planes) {
  Parts parts;
  const std::size_t count = polyhedron.vertices.size();
  side_.resize_unset(count);
  value_.resize_unset(count);
  for (std::size_t i = 0; i < count; ++i) {
    const PolyhedronVertex& vertex = polyhedron.vertices[i];
    const double value = value_at(vertex, coefficients);
    const int side = side_of_vertex(vertex, value, plane.carrier(), coefficients, planes);
    value_[i] = value;
    side_[i] = static_cast<signed char>(side);
    parts.inside |= side < 0;
    parts.outside |= side > 0;
  }
  return parts;
}

/// The two faces of an edge see it in opposite directions. A face is convex, so its boundary leaves
/// the inner side once at most: that says which crossing an edge has had from its other face.
void PolyhedronClipper::find_crossings(const Polyhedron& polyhedron, PlaneRef plane,
                                       const PlaneSet& planes) {
  crossings_.clear();
  cuts_.resize_unset(polyhedron.faces.size());
  for (std::uint32_t f = 0; f < polyhedron.faces.size(); ++f) {
    const Polyhedron::Face& face = polyhedron.faces[f];
    const Polyhedron::Corner* const loop = polyhedron.corners.data() + face.first;
    FaceCut& cut = cuts_[f];
    cut.sides = 0;
    int there = side_[loop[0].vertex];
    for (std::uint32_t k = 0; k < face.count; ++k) {
      const int here = there;
      const std::uint32_t next = loop[k + 1 == face.count ? 0 : k + 1].vertex;
      there = side_[next];
      cut.sides |= 1u << static_cast<unsigned>(here + 1);
      if (here * there >= 0) continue;
      const std::uint32_t across = loop[k].across;
      const auto number = [&](std::uint32_t FaceCut::*seen_from_there) {
        if (across < f) return cuts_[across].*seen_from_there;
        // In the order of their numbers, so that the plane may be either way round.
        const auto [u, v] = std::minmax(loop[k].vertex, next);
        crossings_.push_back(edge_crossing({&polyhedron.vertices[u], value_[u]},
                                           {&polyhedron.vertices[v], value_[v]}, face.plane,
                                           polyhedron.faces[across].plane, plane, planes));
        return static_cast<std::uint32_t>(crossings_.size() - 1);
      };
      if (here < 0) {
        cut.leaves = number(&FaceCut::enters);
      } else {
        cut.enters = number(&FaceCut::leaves);
      }
    }
  }
}

/// `part` becomes what lies inside, or outside; `plane` is oriented away from it.
void PolyhedronClipper::make_part(const Polyhedron& polyhedron, bool keeps_inside, PlaneRef plane,
                                  Polyhedron& part) {
  // Below zero what is kept, above zero what is not.
  const int turn = keeps_inside ? 1 : -1;
  const std::uint32_t kept_bit = keeps_inside ? kInside : kOutside;

  const std::size_t vertex_count = polyhedron.vertices.size();
  new_vertex_.resize_unset(vertex_count);
  part.vertices.resize_unset(vertex_count + crossings_.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < vertex_count; ++i) {
    if (side_[i] * turn > 0) continue;
    new_vertex_[i] = kept;
    part.vertices[kept++] = polyhedron.vertices[i];
  }
  const std::uint32_t first_crossing = kept;
  for (const PolyhedronVertex& crossing : crossings_) {
    part.vertices[kept] = crossing;
    part.vertices[kept++].planes[2] = plane;
  }
  part.vertices.resize_unset(kept);
  rim_.resize_unset(kept);

  const auto face_count = static_cast<std::uint32_t>(polyhedron.faces.size());
  new_face_.resize_unset(face_count);
  std::uint32_t new_count = 0;
  for (std::uint32_t f = 0; f < face_count; ++f) {
    new_face_[f] = (cuts_[f].sides & kept_bit) != 0 ? new_count++ : kNone;
  }
  const std::uint32_t cap = new_count;
  part.faces.resize_unset(new_count + 1);
  // A face gets at most one corner more, and no rim is longer than there are faces.
  part.corners.resize_unset(polyhedron.corners.size() + 2 * std::size_t{face_count});
  Polyhedron::Corner* const corners = part.corners.data();
  std::uint32_t end = 0;
  std::uint32_t rim_start = kNone;

  for (std::uint32_t f = 0; f < face_count; ++f) {
    const std::uint32_t number = new_face_[f];
    if (number == kNone) continue;
    const FaceCut& cut = cuts_[f];
    const Polyhedron::Face& face = polyhedron.faces[f];
    const Polyhedron::Corner* const loop = polyhedron.corners.data() + face.first;
    const std::uint32_t first = end;
    if (cut.sides == kept_bit) {
      for (std::uint32_t k = 0; k < face.count; ++k) {
        corners[end++] = {new_vertex_[loop[k].vertex], new_face_[loop[k].across]};
      }
      part.faces[number] = {face.plane, first, end - first};
      continue;
    }
    std::uint32_t rim_corner = kNone;
    int there = side_[loop[0].vertex] * turn;
    for (std::uint32_t k = 0; k < face.count; ++k) {
      const int here = there;
      there = side_[loop[k + 1 == face.count ? 0 : k + 1].vertex] * turn;
      if (here <= 0) {
        // An edge that leaves the inner side, or touches the plane with both ends, continues (or
        // lies) on the rim; otherwise it stays the edge it was.
        const bool on_rim = here == 0 && there >= 0;
        if (on_rim) rim_corner = end;
        corners[end++] = {new_vertex_[loop[k].vertex], on_rim ? cap : new_face_[loop[k].across]};
      }
      if (here * there >= 0) continue;
      // From the outer side everything is seen the other way round.
      const bool leaves = here < 0;
      const std::uint32_t vertex =
          first_crossing + (leaves == keeps_inside ? cut.leaves : cut.enters);
      if (leaves) rim_corner = end;
      corners[end++] = {vertex, leaves ? cap : new_face_[loop[k].across]};
    }
    part.faces[number] = {face.plane, first, end - first};
    if (rim_corner == kNone) continue;
    const std::uint32_t rim_end = rim_corner + 1 == end ? first : rim_corner + 1;
    rim_start = corners[rim_end].vertex;
    rim_[rim_start] = {corners[rim_corner].vertex, number};
  }

  // The new face: the rim, seen from outside.
  assert(rim_start != kNone);
  const std::uint32_t first = end;
  std::uint32_t at = rim_start;
  for (std::uint32_t k = 0; k < cap; ++k) {  // no more edges than faces
    corners[end++] = {at, rim_[at].face};
    at = rim_[at].to;
    if (at == rim_start) break;
  }
  assert(at == rim_start);
  part.faces[cap] = {plane, first, end - first};
  part.corners.resize_unset(end);
}

}  // namespace spoctree
