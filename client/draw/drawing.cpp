#include "client/draw/drawing.hpp"

#include "common/report/json_text.hpp"

namespace spoctree {

std::string name_of(PlaneRef plane, const Universe& universe) {
  if (!plane.is_wall()) return std::to_string(plane.index());
  const double coordinate = wall_coordinate(universe.half_side, plane.index());
  const double at = universe.center[plane.axis()] + coordinate * universe.scale();
  return std::string{"xyz"[plane.axis()], '='} + to_text(at + 0.0);
}

std::string name_of(const LineSource& source) {
  return std::string(name_of(source.kind)) + (source.is_inherited ? "/inherited" : "");
}

}  // namespace spoctree
