#include "tools/model/polygon_mesh.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace spoctree::model {

namespace {
// `last` is the character behind the number: a blank, or the end of the line.
template <typename Number>
void append_number(std::string& text, Number value, char last) {
  std::array<char, 32> digits;  // the longest shortest double has 24 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
  text += last;
}
}  // namespace

std::string to_off(const PolygonMesh& mesh) {
  std::size_t corners = 0;
  for (const Loop& face : mesh.faces) corners += face.size();

  std::string text = "OFF\n";
  append_number(text, mesh.points.size(), ' ');
  append_number(text, mesh.faces.size(), ' ');
  append_number(text, corners / 2, '\n');  // every edge is a side of two faces
  for (const glm::dvec3& point : mesh.points) {
    // Adding 0.0 turns the -0.0 of a mirrored point into 0.
    append_number(text, point.x + 0.0, ' ');
    append_number(text, point.y + 0.0, ' ');
    append_number(text, point.z + 0.0, '\n');
  }
  for (const Loop& face : mesh.faces) {
    append_number(text, face.size(), ' ');
    for (std::size_t i = 0; i < face.size(); ++i)
      append_number(text, face[i], i + 1 < face.size() ? ' ' : '\n');
  }
  return text;
}

}  // namespace spoctree::model
