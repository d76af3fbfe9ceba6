// What a line is -> what it is drawn with: class, ink, width, dashes. The same for every format.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "client/lines/visible_line.hpp"

namespace spoctree {

/// Colours of lines. Those of node kinds are the paper's (WSCG 2003, image 1).
enum class Ink : std::uint8_t {
  Black,
  Grey,      ///< planes of GREY nodes, and cell walls
  Green,     ///< planes of CONVEX nodes
  Blue,      ///< planes of CONCAVE nodes
  Yellow,    ///< planes of upper levels, shown in CONCAVE nodes
  Red,       ///< planes of upper levels, shown in CONVEX nodes and in BLACK ones, which have no own
  Purple,    ///< VERTEX nodes; the paper has none in its image
  LeftEye,   ///< cyan: black behind a red glass
  RightEye,  ///< red: black behind a cyan glass
};
inline constexpr int kInkCount = 9;

/// In drawing order: what comes later lies on top.
enum class PenUse : std::uint8_t { Crease, Silhouette, Lettering };

/// Lines of one pen are drawn alike and make one class, layer or plotter pen.
struct Pen {
  bool hidden = false;
  PenUse use = PenUse::Crease;
  bool is_step = false;
  Ink ink = Ink::Black;

  /// Drawing order: hidden lines first, steps before what is final.
  std::strong_ordering operator<=>(const Pen& other) const;
  bool operator==(const Pen&) const = default;
};

/// "black", ..., "left-eye".
const char* name_of(Ink ink);

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// The ink that --colour-by kind gives to a line.
Ink ink_of_kind(const LineSource& source);

/// Hidden lines are thin and dashed, silhouettes thicker than creases.
double width_mm(const Pen& pen);
inline constexpr double kDashMm = 1.6;
inline constexpr double kDashGapMm = 1.0;

/// Black ink is grey for steps and hidden lines.
Rgb colour_of(const Pen& pen);

/// "silhouette", "crease" or "caption", then "step", "hidden" and the ink's name where they apply:
/// separated by `separator`.
std::string name_of(const Pen& pen, char separator);

/// "#rrggbb".
std::string to_hex(Rgb colour);

}  // namespace spoctree
