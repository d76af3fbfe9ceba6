// Four numbers -> the universe cube that silhouettes are of.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// The cube with this centre and side; the side is rounded to a relative 2^-20. Throws BadInput if
/// it is not between 2^-900 and 2^900, or a number is not finite.
Universe cube_around(glm::dvec3 centre, double side);

/// The cube that "X,Y,Z,SIDE" names (blanks do for commas). Throws BadInput beginning with `name`.
Universe parse_cube(std::string_view text, std::string_view name);

/// The same as text, with a line's end: what render leaves in a folder as cube.txt.
std::string cube_text(const Universe& universe);
inline constexpr const char* kCubeFile = "cube.txt";

/// Coordinates in which the cube is [-1, 1]^3.
inline glm::dvec3 in_cube(const Universe& universe, const glm::dvec3& model_point) {
  return (model_point - universe.center) / (universe.side() / 2);
}

}  // namespace spoctree
