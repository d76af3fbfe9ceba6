#include "server/solid/write_off.hpp"

#include <charconv>

namespace spoctree {

namespace {

template <class Number>
void append(std::string& text, Number value, char end) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  text += end;
}

}  // namespace

std::string to_off(const Solid& solid) {
  std::string text = "OFF\n";
  append(text, solid.vertices.size(), ' ');
  append(text, solid.triangles.size(), ' ');
  append(text, 3 * solid.triangles.size() / 2, '\n');
  for (const Vec3 vertex : solid.vertices) {
    const Vec3 point = solid.universe.to_model(vertex) + 0.0;  // no "-0"
    append(text, point.x, ' ');
    append(text, point.y, ' ');
    append(text, point.z, '\n');
  }
  for (const SolidTriangle& triangle : solid.triangles) {
    text += "3 ";
    append(text, triangle.vertex[0], ' ');
    append(text, triangle.vertex[1], ' ');
    append(text, triangle.vertex[2], '\n');
  }
  return text;
}

}  // namespace spoctree
