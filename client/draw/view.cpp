#include "client/draw/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "client/draw/solid_points.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

namespace {

using Stereo = ViewOptions::Stereo;

struct NamedDirection {
  const char* name;
  Vec3 toward_viewer;
  Vec3 up;
};

// Top and bottom keep +X to the right, as front does: they can be put above and below it.
constexpr Vec3 kUpwards{0, 0, 1};
const NamedDirection kDirections[] = {
    {"front", {0, -1, 0}, kUpwards}, {"back", {0, 1, 0}, kUpwards},
    {"left", {-1, 0, 0}, kUpwards},  {"right", {1, 0, 0}, kUpwards},
    {"top", {0, 0, 1}, {0, 1, 0}},   {"bottom", {0, 0, -1}, {0, -1, 0}},
    {"iso", {1, -1, 1}, kUpwards}};

/// Farther away, a perspective is a parallel projection with rounding errors.
constexpr double kLargestDistance = 1e6;
constexpr double kLeastDistance = 1e-6;

const NamedDirection& direction_of(const std::string& name) {
  for (const NamedDirection& direction : kDirections) {
    if (name == direction.name) return direction;
  }
  std::string names;
  for (const std::string& known : view_names()) names += (names.empty() ? "" : ", ") + known;
  throw UsageError("--view: there is no view '" + name + "', only " + names);
}

/// Around a point of the picture.
struct Extent {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Rectangle box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};

  void add(Vec2 point) {
    box.lower = glm::min(box.lower, point);
    box.upper = glm::max(box.upper, point);
  }
};

bool is_in_wide_cone(const Camera& camera, Vec3 point) {
  constexpr double kLargestSlope = std::numbers::sqrt3;  // 60 degrees
  const double depth = camera.depth(point);
  if (!(depth > camera.least_depth())) return false;
  const Vec2 at = camera.project(point);
  return std::max(std::abs(at.x), std::abs(at.y)) <= kLargestSlope * camera.focal_length();
}

/// What all the cameras together need to show, around their pictures of `target`.
Rectangle common_frame(const std::vector<Camera>& cameras, Vec3 target,
                       const std::vector<Vec3>& points, const std::optional<double>& fov_deg) {
  const auto square = [&](double angle_deg) {
    const double half = cameras[0].focal_length() * std::tan(angle_deg * std::numbers::pi / 360);
    return Rectangle{{-half, -half}, {half, half}};
  };
  if (fov_deg) return square(*fov_deg);
  Extent extent;
  for (const Camera& camera : cameras) {
    const Vec2 middle = camera.project(target);
    for (const Vec3 point : points) {
      if (camera.is_perspective() && !is_in_wide_cone(camera, point)) return square(90);
      extent.add(camera.project(point) - middle);
    }
  }
  return extent.box;
}

/// Both eyes beside the one of `camera`, left first.
std::vector<Camera> eyes_of(const Camera& camera, Vec3 target, double separation) {
  std::vector<Camera> eyes;
  for (const double side : {-0.5, 0.5}) {
    const Vec3 aside = camera.right() * (side * separation);
    if (camera.is_perspective()) {
      const Vec3 shift = aside * camera.focal_length();
      eyes.push_back(Camera::perspective(camera.eye() + shift, target + shift, camera.up()));
    } else {
      eyes.emplace_back(camera.toward_viewer() + aside, camera.up());
    }
  }
  return eyes;
}

View view_of(const Camera& camera, Vec3 target, const Rectangle& frame, std::string name) {
  const Vec2 middle = camera.project(target);
  return {std::move(name), camera, {middle + frame.lower, middle + frame.upper}, Ink::Black, false};
}

Camera perspective_of(const ViewOptions& options, const Universe& universe, Vec3 target) {
  const Vec3 eye = universe.to_universe(*options.eye);
  const double distance = glm::distance(eye, target);
  if (!(distance <= kLargestDistance))
    throw UsageError("--eye: too far from its target for a perspective; use --from");
  if (!(distance >= kLeastDistance)) throw UsageError("--eye: too near its target");
  return Camera::perspective(eye, target, options.up.value_or(kUpwards));
}

void check_vector(const std::optional<Vec3>& vector, const char* option) {
  if (!vector) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite((*vector)[axis]))
      throw UsageError(std::string(option) + ": the numbers must be finite");
  }
}

}  // namespace

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedDirection& direction : kDirections) all.emplace_back(direction.name);
    return all;
  }();
  return names;
}

void check(const ViewOptions& options) {
  check_vector(options.from, "--from");
  check_vector(options.eye, "--eye");
  check_vector(options.target, "--target");
  check_vector(options.up, "--up");
  if (!options.named.empty() && (options.from || options.eye || options.up))
    throw UsageError("--view says where the viewer is: leave out --from, --eye and --up");
  if (options.from && options.eye)
    throw UsageError("--from is for parallel, --eye for perspective projections: give one of them");
  if (options.target && !options.eye) throw UsageError("--target goes with --eye");
  if (options.fov_deg && !options.eye) throw UsageError("--fov goes with --eye");
  if (options.fov_deg && !(*options.fov_deg >= kLeastFovDeg && *options.fov_deg <= kLargestFovDeg))
    throw UsageError("--fov must be between 0.01 and 170 degrees");
  if (options.named.size() > 1 && options.stereo != Stereo::None)
    throw UsageError("--stereo takes one view");
  if (!(options.eye_separation > 0 && options.eye_separation <= kLargestEyeSeparation))
    throw UsageError("--eye-separation must be greater than 0 and at most 1");
  for (const std::string& name : options.named) {
    direction_of(name);
    if (std::count(options.named.begin(), options.named.end(), name) > 1)
      throw UsageError("--view: '" + name + "' is there twice");
  }
  if (options.projection && !is_arranged_by_projection(options.named))
    throw UsageError("--projection is for a sheet: --view with two or more sides of the model");
  if (options.from) Camera(*options.from, options.up.value_or(kUpwards));
}

std::vector<View> make_views(const ViewOptions& options, const Octree& tree) {
  check(options);
  const std::vector<Vec3> points = coarsest_points(tree);
  Vec3 target = middle_of(points);
  std::vector<View> views;
  for (const std::string& name : options.named) {
    if (options.named.size() == 1) break;
    const NamedDirection& direction = direction_of(name);
    const Camera camera(direction.toward_viewer, direction.up);
    views.push_back(view_of(camera, target, common_frame({camera}, target, points, {}), name));
  }
  if (!views.empty()) {
    const auto cells =
        arrange_views(options.named, options.projection.value_or(Projection::FirstAngle));
    for (std::size_t k = 0; k < views.size(); ++k) views[k].cell = cells[k];
    return views;
  }

  Camera camera;
  if (!options.named.empty()) {
    const NamedDirection& direction = direction_of(options.named[0]);
    camera = Camera(direction.toward_viewer, direction.up);
  } else if (options.eye) {
    if (options.target) target = tree.universe.to_universe(*options.target);
    camera = perspective_of(options, tree.universe, target);
  } else if (options.from || options.up) {
    camera = Camera(options.from.value_or(camera.toward_viewer()), options.up.value_or(kUpwards));
  }
  std::vector<Camera> cameras = {camera};
  if (options.stereo != Stereo::None) cameras = eyes_of(camera, target, options.eye_separation);
  const Rectangle frame = common_frame(cameras, target, points, options.fov_deg);
  for (const Camera& each : cameras) views.push_back(view_of(each, target, frame, ""));
  if (options.stereo == Stereo::Anaglyph) {
    views[0].ink = Ink::LeftEye;
    views[1].ink = Ink::RightEye;
    views[1].is_over_last = true;
  }
  return views;
}

}  // namespace spoctree
