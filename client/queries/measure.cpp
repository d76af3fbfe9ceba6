#include "client/queries/measure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "client/queries/shells.hpp"
#include "client/rebuild/surface.hpp"

namespace spoctree {

namespace {

/// Bounds that come from sums of many doubles are moved apart by this fraction.
constexpr double kSumError = 1e-12;

/// No solid of this volume has less surface than a ball.
double area_of_ball(double volume) {
  return std::cbrt(36 * std::numbers::pi * volume * volume) * (1 - 1e-15);
}

std::optional<Box> to_model(const std::optional<Box>& box, const Universe& universe) {
  if (!box) return std::nullopt;
  return Box{universe.to_model(box->lower), universe.to_model(box->upper)};
}

void measure_surface(const Octree& tree, Measures& measures) {
  const Surface surface = rebuild_surface(tree, measures.level);
  const PlaneSet planes = tree.plane_set();
  std::uint32_t components = 0;
  for (const Shell& shell : find_shells(surface, planes, Filling::Material)) {
    components += shell.volume > 0 ? 1 : 0;
  }
  std::uint32_t cavities = 0;
  for (const Shell& shell : find_shells(surface, planes, Filling::Emptiness)) {
    cavities += shell.volume < 0 ? 1 : 0;
  }
  // Of all faces at once: right whatever hangs together.
  const double enclosed = volume(surface);
  const double boundary = area(surface);
  measures.volume = {enclosed, enclosed};
  measures.area = {boundary, boundary};
  measures.components = components;
  measures.cavities = cavities;
  if (surface.vertices.empty()) return;
  Box box{surface.vertices[0], surface.vertices[0]};
  for (const Vec3 vertex : surface.vertices) {
    box.lower = glm::min(box.lower, vertex);
    box.upper = glm::max(box.upper, vertex);
  }
  measures.inner_box = measures.outer_box = box;
}

void bound_measures(const Octree& tree, Measures& measures) {
  const PieceBounds bounds = bound_pieces(tree, measures.level);
  measures.volume = {bounds.inner_volume, bounds.outer_volume};
  measures.inner_box = bounds.inner_box;
  measures.outer_box = bounds.outer_box;
}

}  // namespace

Measures measure(const Octree& tree, std::uint32_t level) {
  Measures measures;
  measures.level = level;
  measures.is_exact = tree.levels[level].grey_count == 0;
  if (measures.is_exact) {
    measure_surface(tree, measures);
  } else {
    bound_measures(tree, measures);
  }
  const Universe& universe = tree.universe;
  const int exponent = universe.scale_exponent;
  measures.volume.lower = std::ldexp(measures.volume.lower, 3 * exponent);
  measures.volume.upper = std::ldexp(measures.volume.upper, 3 * exponent);
  measures.inner_box = to_model(measures.inner_box, universe);
  measures.outer_box = to_model(measures.outer_box, universe);
  if (measures.is_exact) {
    measures.area.lower = std::ldexp(measures.area.lower, 2 * exponent);
    measures.area.upper = measures.area.lower;
  } else {
    const LevelStatement& statement = tree.levels[level].statement;
    measures.area.lower =
        std::max(statement.inner_area * (1 - kSumError), area_of_ball(measures.volume.lower));
    measures.area.upper = statement.outer_area * (1 + kSumError);
  }
  return measures;
}

}  // namespace spoctree
