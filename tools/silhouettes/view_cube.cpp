#include "tools/silhouettes/view_cube.hpp"

#include <array>
#include <cmath>

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "common/report/json_text.hpp"

namespace spoctree {

Universe cube_around(glm::dvec3 centre, double side) {
  if (!(side >= 0x1p-900 && side <= 0x1p900))
    throw BadInput("a cube's side is between 2^-900 and 2^900, not " + to_text(side));
  Universe universe;
  universe.center = centre;
  universe.half_side = std::frexp(side / 2, &universe.scale_exponent);  // in [0.5, 1)
  if (universe.half_side == 0.5) {
    universe.half_side = 1;
    --universe.scale_exponent;
  }
  constexpr double kUnit = 1 << kHalfSideBits;
  universe.half_side = std::max(std::round(universe.half_side * kUnit), kUnit / 2 + 1) / kUnit;
  if (!is_valid(universe)) throw BadInput("not a cube that a model can be in");
  return universe;
}

Universe parse_cube(std::string_view text, std::string_view name) {
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  while (true) {
    const std::size_t begin = text.find_first_not_of(", \t\r\n");
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(", \t\r\n"));
    const ParsedReal number = parse_real(word);
    if (number.fault != nullptr || count == numbers.size()) {
      throw BadInput(std::string(name) + ": a cube is X Y Z SIDE, four numbers: '" +
                     std::string(word.substr(0, 40)) + "' " +
                     (number.fault != nullptr ? number.fault : "is one too many"));
    }
    numbers[count++] = number.value;
    text.remove_prefix(word.size());
  }
  if (count < numbers.size())
    throw BadInput(std::string(name) + ": a cube is X Y Z SIDE, four numbers, not " +
                   std::to_string(count));
  try {
    return cube_around({numbers[0], numbers[1], numbers[2]}, numbers[3]);
  } catch (const BadInput& error) {
    throw BadInput(std::string(name) + ": " + error.what());
  }
}

std::string cube_text(const Universe& universe) {
  return to_text(universe.center.x) + " " + to_text(universe.center.y) + " " +
         to_text(universe.center.z) + " " + to_text(universe.side()) + "\n";
}

}  // namespace spoctree
