#include "client/lines/crease.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// The two sides of a line in the picture, looking along it; a set of them.
using LineSides = std::uint8_t;
constexpr LineSides kNeitherSide = 0;
constexpr LineSides kLeftSide = 1;
constexpr LineSides kRightSide = 2;

/// A face plane as `may_be_seen` needs it.
struct Wing {
  Vec3 normal{0.0};
  int facing = 0;
  bool runs_forward = false;
};

/// Two faces: whether each faces the viewer says it all; angles are not needed.
LineSides open_sides_of_two(const Wing& p, const Wing& q, Vec3 direction, Vec3 left) {
  const Vec3 along = p.runs_forward ? direction : -direction;
  const bool is_convex = glm::dot(glm::cross(p.normal, q.normal), along) >= 0;
  const auto opens = [&](const Wing& wing, Vec3 side) {
    return wing.facing > 0 || (wing.facing == 0 && glm::dot(wing.normal, side) > 0);
  };
  LineSides open = kNeitherSide;
  for (const LineSides side : {kLeftSide, kRightSide}) {
    const Vec3 toward = side == kLeftSide ? left : -left;
    // Material is where both planes have it behind them, or where at least one has.
    const bool is_open =
        is_convex ? opens(p, toward) || opens(q, toward) : opens(p, toward) && opens(q, toward);
    if (is_open) open |= side;
  }
  return open;
}

/// The general case: goes around the crease from the line of sight to the next face on either side.
LineSides open_sides_of_many(std::span<const Wing> wings, Vec3 direction, Vec3 toward_viewer) {
  // Angles are counted in the plane across the crease, from the line of sight towards the right.
  const Vec3 right = glm::cross(direction, toward_viewer);
  const Vec3 ahead = glm::cross(right, direction);
  constexpr double kFullTurn = 2 * std::numbers::pi;
  double nearest_left = kFullTurn;
  double nearest_right = kFullTurn;
  LineSides open = kNeitherSide;
  for (const Wing& wing : wings) {
    const Vec3 into_face = glm::cross(wing.normal, wing.runs_forward ? direction : -direction);
    double angle = std::atan2(glm::dot(into_face, right), glm::dot(into_face, ahead));
    if (wing.facing == 0 && glm::dot(into_face, ahead) > 0) angle = 0;
    if (angle < 0) angle += kFullTurn;
    // The face turned up when going right has its outer side towards smaller angles, or not.
    const Vec3 onward = glm::cross(direction, into_face);
    const bool material_beyond = glm::dot(wing.normal, onward) < 0;
    // A face exactly in the line of sight is the last one met from either side.
    const double going_right = angle == 0 ? kFullTurn : angle;
    const double going_left = kFullTurn - angle;
    if (going_right <= nearest_right) {
      nearest_right = going_right;
      open = static_cast<LineSides>((open & kLeftSide) | (material_beyond ? kRightSide : 0));
    }
    if (going_left <= nearest_left) {
      nearest_left = going_left;
      open = static_cast<LineSides>((open & kRightSide) | (material_beyond ? 0 : kLeftSide));
    }
  }
  return open;
}

}  // namespace

bool may_be_seen(const Crease& crease, const Creases& creases, const PlaneSet& planes,
                 const Camera& camera) {
  constexpr std::size_t kMostWings = 16;
  Wing wings[kMostWings];
  std::size_t count = 0;
  for (const CreaseSide& side : creases.sides_of(crease)) {
    if (count == kMostWings) return true;  // more faces than any boundary has: rather drawn
    const Plane plane = planes[side.plane];
    wings[count++] = {plane.normal, camera.facing(plane), side.runs_forward};
  }
  if (count == 2) {
    // Where no face is seen edge-on, angles are not needed.
    if (wings[0].facing > 0 && wings[1].facing > 0) return true;
    if (wings[0].facing < 0 && wings[1].facing < 0) return false;
  }
  const Vec3 direction = glm::normalize(crease.b - crease.a);
  const Vec3 toward_viewer = camera.toward_viewer_from(0.5 * (crease.a + crease.b));
  if (count == 2) {
    const Vec3 left = glm::cross(toward_viewer, direction);
    return open_sides_of_two(wings[0], wings[1], direction, left) != kNeitherSide;
  }
  return open_sides_of_many({wings, count}, direction, toward_viewer) != kNeitherSide;
}

bool is_silhouette(const Crease& crease, const Creases& creases, const PlaneSet& planes,
                   const Camera& camera) {
  bool any_towards = false;
  bool any_not = false;
  for (const CreaseSide& side : creases.sides_of(crease)) {
    const bool towards = camera.facing(planes[side.plane]) > 0;
    any_towards |= towards;
    any_not |= !towards;
  }
  return any_towards && any_not;
}

bool is_flat(const Crease& crease, const Creases& creases, const PlaneSet& planes) {
  const auto sides = creases.sides_of(crease);
  const Vec3 first = planes[sides.front().plane].normal;
  return std::all_of(sides.begin() + 1, sides.end(), [&](const CreaseSide& side) {
    const Vec3 normal = planes[side.plane].normal;
    const Vec3 across = glm::cross(first, normal);
    return glm::dot(first, normal) > 0 && glm::dot(across, across) < kFlatCrease * kFlatCrease;
  });
}

double crease_angle_deg(const Crease& crease, const Creases& creases, const PlaneSet& planes) {
  const auto sides = creases.sides_of(crease);
  double largest = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec3 p = planes[sides[i].plane].normal;
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const Vec3 q = planes[sides[j].plane].normal;
      largest = std::max(largest, std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q)));
    }
  }
  return largest * 180 / std::numbers::pi;
}

}  // namespace spoctree
