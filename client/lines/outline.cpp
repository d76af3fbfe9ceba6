#include "client/lines/outline.hpp"

#include <cmath>

namespace spoctree {

namespace {

/// Corners are off by 2^-45 at most, a hundred times less than this fraction of the tolerance; an
/// edge longer than kShortEdge points where it should up to 1e-7.
constexpr double kStraight = 1.0 / 16;
constexpr double kShortEdge = 1e-6;

bool is_superfluous(Vec2 before, Vec2 corner, Vec2 after, double tolerance) {
  const double length = glm::distance(before, corner);
  if (length <= tolerance) return true;
  if (length > kShortEdge && glm::distance(corner, after) > kShortEdge) return false;
  const Vec2 along = after - before;
  const double span = glm::length(along);
  const Vec2 off = corner - before;
  return std::abs(along.x * off.y - along.y * off.x) <= kStraight * tolerance * span;
}

}  // namespace

void straighten(std::vector<Vec2>& polygon, double tolerance) {
  std::size_t kept = 0;
  for (const Vec2 corner : polygon) {
    while (kept > 1 && is_superfluous(polygon[kept - 2], polygon[kept - 1], corner, tolerance)) {
      --kept;
    }
    polygon[kept++] = corner;
  }
  // Round the end.
  std::size_t first = 0;
  for (bool changed = true; changed && kept - first > 2;) {
    changed = false;
    if (is_superfluous(polygon[kept - 2], polygon[kept - 1], polygon[first], tolerance)) {
      --kept;
      changed = true;
    } else if (is_superfluous(polygon[kept - 1], polygon[first], polygon[first + 1], tolerance)) {
      ++first;
      changed = true;
    }
  }
  polygon.resize(kept);
  polygon.erase(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first));
  if (polygon.size() < 3) polygon.clear();
}

OutlineFinder::OutlineFinder(const PlaneSet& planes, std::size_t table_size, const Camera& camera,
                             double tolerance)
    : camera_(camera), tolerance_(tolerance) {
  facing_table_.reserve(table_size);
  for (std::size_t i = 0; i < table_size; ++i) {
    const Plane plane = planes[PlaneRef::of_table(static_cast<std::uint32_t>(i))];
    facing_table_.push_back(static_cast<signed char>(camera.facing(plane)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Plane plane = planes[PlaneRef::of_wall(axis, 0)];
    facing_walls_[axis] = static_cast<signed char>(camera.facing(plane));
  }
}

void OutlineFinder::find(const Polyhedron& piece, std::vector<Vec2>& outline) {
  outline.clear();
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  next_.assign(piece.vertices.size(), kNone);
  std::uint32_t start = kNone;
  for (const Polyhedron::Face& face : piece.faces) {
    if (facing(face.plane) <= 0) continue;
    const auto loop = piece.loop(face);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (facing(piece.plane_across(loop[k])) > 0) continue;
      start = loop[k].vertex;
      next_[start] = loop[k + 1 == loop.size() ? 0 : k + 1].vertex;
    }
  }
  if (start == kNone) return;
  std::uint32_t at = start;
  do {
    outline.push_back(camera_.project(piece.vertices[at].position));
    at = next_[at];
  } while (at != start && at != kNone && outline.size() <= piece.vertices.size());
  straighten(outline, tolerance_);
}

}  // namespace spoctree
