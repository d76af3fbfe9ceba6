#include "server/commands/describe_solid.hpp"

#include "common/report/json_text.hpp"

namespace spoctree {

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
  return text;
}

}  // namespace spoctree
