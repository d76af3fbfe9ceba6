// What the user wants to see -> cameras, each with the part of its picture that is shown.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/draw/arrange_views.hpp"
#include "client/draw/pen.hpp"
#include "client/lines/camera.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

struct ViewOptions {
  /// Names of view_names(): seen from there, +Z upwards, as a draughtsman names them.
  std::vector<std::string> named;
  /// How several named views are arranged; left out: first angle.
  std::optional<Projection> projection;
  std::optional<Vec3> from;    ///< parallel: towards the viewer
  std::optional<Vec3> eye;     ///< perspective; model coordinates
  std::optional<Vec3> target;  ///< left out: the middle of the model; model coordinates
  std::optional<Vec3> up;      ///< left out: +Z
  /// Perspective: the frame is a square as wide as this. Left out: it is the solid's extent, or a
  /// square of 90 degrees where the solid reaches beyond 60 degrees off the axis.
  std::optional<double> fov_deg;
  enum class Stereo { None, Beside, Anaglyph } stereo = Stereo::None;
  /// Distance of the eyes, as a fraction of that to the target. Their axes are parallel; in
  /// parallel projections the two directions of view differ by as much.
  double eye_separation = 1.0 / 30;
};

inline constexpr double kLeastFovDeg = 0.01;
inline constexpr double kLargestFovDeg = 170;
inline constexpr double kLargestEyeSeparation = 1;

/// One picture of a sheet.
struct View {
  std::string name;  ///< empty: it needs no caption
  Camera camera;
  Rectangle frame;            ///< the part of the picture that is shown
  Ink ink = Ink::Black;       ///< of all its lines
  bool is_over_last = false;  ///< drawn over the picture before, not beside it
  /// Where it belongs on a sheet; left out: after the one before.
  std::optional<SheetCell> cell = std::nullopt;
};

/// front, back, left, right, top, bottom, iso.
const std::vector<std::string>& view_names();

/// Throws UsageError for options that contradict each other, numbers out of range and unknown
/// names.
void check(const ViewOptions& options);

/// The views of one sheet, at least one. The frames hold for every level of the tree, so that
/// drawings of its levels can be laid on each other; those of a stereo pair show the target in the
/// same place. Throws UsageError as `check` does, and if an eye is where no picture can be had.
/// REQUIRES: a valid tree with at least one level.
std::vector<View> make_views(const ViewOptions& options, const Octree& tree);

}  // namespace spoctree
