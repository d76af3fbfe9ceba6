#include "client/cells/cell_polygon.hpp"

#include <utility>

#include "common/geometry/predicates.hpp"

namespace spoctree {

void copy_face(const Polyhedron& polyhedron, const Polyhedron::Face& face, CellPolygon& polygon) {
  polygon.corners.clear();
  for (const Polyhedron::Corner& corner : polyhedron.loop(face)) {
    polygon.corners.push_back(
        {polyhedron.vertices[corner.vertex], polyhedron.plane_across(corner)});
  }
}

bool CellPolygonClipper::clip(CellPolygon& polygon, PlaneRef plane, PlaneRef cut,
                              const PlaneSet& planes) {
  const std::size_t count = polygon.corners.size();
  side_.resize_unset(count);
  bool any_inside = false;
  bool any_outside = false;
  for (std::size_t k = 0; k < count; ++k) {
    const int side = side_of_vertex(polygon.corners[k].vertex, cut, planes);
    side_[k] = static_cast<signed char>(side);
    any_inside |= side < 0;
    any_outside |= side > 0;
  }
  if (!any_inside) return false;
  if (!any_outside) return true;
  result_.corners.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = k + 1 == count ? 0 : k + 1;
    const CellPolygon::Corner& corner = polygon.corners[k];
    if (side_[k] < 0) {
      result_.corners.push_back(corner);
    } else if (side_[k] == 0) {
      // The boundary goes on along the edge, or along the cut.
      result_.corners.push_back({corner.vertex, side_[next] < 0 ? corner.across : cut});
    }
    if (side_[k] * side_[next] >= 0) continue;
    PolyhedronVertex crossing;
    const ApproximatePoint point =
        intersection_point(planes[plane], planes[corner.across], planes[cut]);
    crossing.position = point.position;
    crossing.error = point.error;
    crossing.planes[0] = plane;
    crossing.planes[1] = corner.across;
    crossing.planes[2] = cut;
    result_.corners.push_back({crossing, side_[k] < 0 ? cut : corner.across});
  }
  std::swap(polygon, result_);
  return true;
}

}  // namespace spoctree
