#include "common/program/remaining_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace spoctree {

namespace {
/// With less than this done, what is left would be a guess.
constexpr double kTellingFraction = 0.02;
/// Nobody waits for longer; and it keeps numbers short.
constexpr double kLongest_s = 99 * 3600.0;
}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<int>(std::lround(std::min(seconds, kLongest_s)));
  char text[32];
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%d s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%d:%02d min", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%d:%02d h", whole / 3600, whole / 60 % 60);
  }
  return text;
}

std::string describe_progress(double fraction, double elapsed_s) {
  const double done = std::clamp(fraction, 0.0, 1.0);
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3d %%", static_cast<int>(100 * done));
  std::string text = std::string(percent) + ", " + duration_text(elapsed_s);
  if (done >= kTellingFraction) {
    text += ", " + duration_text(elapsed_s / done - elapsed_s) + " left";
  }
  return text;
}

}  // namespace spoctree
