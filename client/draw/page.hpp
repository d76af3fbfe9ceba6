// The size of a page and the scale of what is on it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree {

struct PaperSize {
  double width_mm = 0;
  double height_mm = 0;
};

struct PageOptions {
  /// Millimetres per model unit, in a perspective at the distance of its target. Left out: as large
  /// as fits.
  std::optional<double> scale;
  /// Left out: the page is as large as the drawing with its margins.
  std::optional<PaperSize> paper;
  /// Lies on its side where the drawing then gets larger (sizes with a name).
  bool may_turn_paper = false;
  /// Of a page without paper and scale: its longer side.
  double longest_mm = 200;
  double margin_mm = 5;
  /// Pictures smaller than this are refused: formats round to a tenth of it or worse. 0 for one
  /// that does not round.
  double least_mm = 0.1;
};

inline constexpr double kLargestPageMm = 1e12;

/// "A0" to "A6", or WIDTHxHEIGHT in millimetres. Throws UsageError.
void parse_paper(std::string_view text, PageOptions& options);

/// A number, or "1:50", "2:1". Throws UsageError unless it is finite and greater than 0.
double parse_scale(std::string_view text);

/// What has to find room: the pictures grow with the scale, the rest does not.
struct PageContent {
  Vec2 pictures{0.0};  ///< picture units
  Vec2 rest_mm{0.0};   ///< captions and gaps
};

struct PageLayout {
  double width_mm = 0;
  double height_mm = 0;
  double mm_per_unit = 0;  ///< picture units
  Vec2 origin_mm{0.0};     ///< upper left corner of the content, which is centred
};

/// `model_scale` is the model units per picture unit. Throws UsageError if there is no room, or
/// nothing of the pictures could be seen.
PageLayout lay_out(const PageContent& content, double model_scale, const PageOptions& options);

}  // namespace spoctree
