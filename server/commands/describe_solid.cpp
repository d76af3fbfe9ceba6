#include "server/commands/describe_solid.hpp"

#include <algorithm>
#include <cmath>

#include "common/report/json_text.hpp"

namespace spoctree {

namespace {

bool are_equal(glm::dvec3 units) { return units.y == units.x && units.z == units.x; }

// One number where all axes have the same.
std::string units_text(glm::dvec3 units) {
  std::string text = to_short_text(units.x);
  if (are_equal(units)) return text;
  return text + "," + to_short_text(units.y) + "," + to_short_text(units.z);
}

// "0.01", or "0.01 along x, 0.001 along z".
std::string units_in_words(glm::dvec3 units) {
  if (are_equal(units)) return to_short_text(units.x);
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (units[axis] == 0) continue;
    if (!text.empty()) text += ", ";
    text += to_short_text(units[axis]) + " along " + "xyz"[axis];
  }
  return text;
}

// Of the limits, the one that makes the unit.
std::string digits_text(const FlatToleranceTaken& taken) {
  const glm::dvec3 units = taken.rounding;
  const double unit = std::max({units.x, units.y, units.z});
  int exponent = 0;
  if (std::frexp(unit, &exponent) == 0.5 && taken.precision.binary_digits == 24) {
    return "the file has numbers of 24 bits";
  }
  if (taken.precision.decimal_digits > 0) {
    return "the file has " + std::to_string(taken.precision.decimal_digits) + " significant digits";
  }
  return "the file has multiples of " + to_short_text(taken.precision.unit);
}

double rounded_fraction(const FlatToleranceTaken& taken) {
  return taken.fraction * taken.rounded_spread / taken.spread;
}

}  // namespace

std::string describe_flat_tolerance(const FlatToleranceTaken& taken) {
  if (!taken.is_by_rounding()) {
    return to_short_text(taken.spread) + " (" + to_short_text(taken.fraction) + " of the diagonal" +
           (taken.was_given ? ", as given)" : ")");
  }
  return to_short_text(taken.rounded_spread) + " (" + to_short_text(rounded_fraction(taken)) +
         " of the diagonal: " + digits_text(taken) + ", coordinates may be rounded to " +
         units_in_words(taken.rounding) + ")";
}

std::string flat_tolerance_options(const FlatToleranceTaken& taken) {
  if (!taken.is_by_rounding()) return "flat-tolerance=" + to_text(taken.fraction);
  return "flat-tolerance=" + to_short_text(rounded_fraction(taken)) +
         " rounding=" + units_text(taken.rounding);
}

std::string describe_solid(const std::string& name, const SolidReport& report,
                           std::size_t plane_count, double volume) {
  std::string text = name + ": " + std::to_string(report.input_faces) + " faces, " +
                     std::to_string(plane_count) + " planes, volume " + to_short_text(volume) +
                     "\n";
  if (report.was_turned) text += "turned: all faces pointed inwards\n";
  if (report.triangulated_faces > 0) {
    text += "triangulated: " + std::to_string(report.triangulated_faces) +
            " faces with more than three corners, " + std::to_string(report.uneven_faces) +
            " of them not flat, by at most " + to_short_text(100 * report.largest_unevenness) +
            " % of the diagonal\n";
  }
  if (report.planes_before_merging != plane_count || report.largest_move > 0) {
    text += "merged: " + std::to_string(report.planes_before_merging) + " planes into " +
            std::to_string(plane_count) + ", no corner moved farther than " +
            to_short_text(report.largest_move) + "\n";
  }
  text += "flat tolerance: " + describe_flat_tolerance(report.flat_tolerance) + "\n";
  return text;
}

}  // namespace spoctree
