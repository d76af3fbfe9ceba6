#include "client/cells/empty_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "client/cells/merge_cells.hpp"
#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

/// The shares of the steps.
constexpr double kPartitioning = 0.3;
constexpr double kMerging = 0.5;
constexpr double kOpening = 0.2;

/// Of a point within the universe cube.
int side_of(Vec3 point, const Plane& plane, double reach) {
  if (reach > 0 && std::abs(glm::dot(plane.normal, point) - plane.offset) <= reach) return 0;
  return side_of_any_point(plane, point);
}

}  // namespace

EmptySpace::EmptySpace(const Octree& tree, const EmptySpaceOptions& options,
                       const ProgressShare& progress)
    : tree_(tree),
      planes_(tree.plane_set()),
      partition_(partition_space(tree, options.level, progress.part(kPartitioning))) {
  if (options.merges_cells) {
    MergedCells merged = merge_cells(std::move(partition_.cells), planes_, progress.part(kMerging));
    cells_ = std::move(merged.cells);
    cell_of_ = std::move(merged.cell_of);
  } else {
    cells_ = std::move(partition_.cells);
    cell_of_.resize(cells_.size());
    std::iota(cell_of_.begin(), cell_of_.end(), 0);
    progress.add(kMerging);
  }
  partition_.cells = {};
  openings_ = find_openings(cells_, planes_, progress.part(kOpening));
}

std::vector<std::uint32_t> EmptySpace::find_cells(const Viewpoint& eye, double reach) const {
  if (eye.w == 0) return {kOuterSpace};
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(eye.xyz[axis]) > planes_.half_side() + reach) return {kOuterSpace};
  }
  std::vector<std::uint32_t> found;
  std::vector<SpacePartition::Child> open{partition_.root};
  while (!open.empty()) {
    const SpacePartition::Child at = open.back();
    open.pop_back();
    if (at == SpacePartition::kMaterial) continue;
    if (SpacePartition::is_empty_cell(at)) {
      found.push_back(cell_of_[SpacePartition::cell_of(at)]);
      continue;
    }
    const SpacePartition::Split& split = partition_.splits[static_cast<std::size_t>(at)];
    const int side = side_of(eye.xyz, planes_[split.plane], reach);
    if (side <= 0) open.push_back(split.inside);
    if (side >= 0) open.push_back(split.outside);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool EmptySpace::contains(std::uint32_t cell, Vec3 point, bool strictly) const {
  const Polyhedron& polyhedron = cells_[cell];
  return std::all_of(polyhedron.faces.begin(), polyhedron.faces.end(),
                     [&](const Polyhedron::Face& face) {
                       const int side = side_of_any_point(planes_[face.plane], point);
                       return strictly ? side < 0 : side <= 0;
                     });
}

std::vector<std::uint32_t> EmptySpace::find_cells(Vec3 eye, std::uint32_t last,
                                                  Vec3 last_eye) const {
  std::uint32_t cell = last;
  // As a straight way meets a convex cell once, there are no more steps than cells.
  for (std::size_t steps = 0; cell != kOuterSpace && steps <= cells_.size(); ++steps) {
    if (contains(cell, eye, true)) return {cell};
    // Through the first plane of the cell that the way crosses.
    const Vec3 way = eye - last_eye;
    double first = 2;
    PlaneRef border;
    for (const Polyhedron::Face& face : cells_[cell].faces) {
      const Plane plane = planes_[face.plane];
      const double speed = glm::dot(plane.normal, way);
      if (!(speed > 0)) continue;
      const double time = (plane.offset - glm::dot(plane.normal, last_eye)) / speed;
      if (time >= first) continue;
      first = time;
      border = face.plane;
    }
    if (!(first <= 1)) break;
    const Vec3 crossing = last_eye + first * way;
    std::uint32_t next = kOuterSpace;
    for (const std::uint32_t number : openings_.of(cell)) {
      const Opening& opening = openings_.openings[number];
      if (opening.plane.carrier() != border.carrier()) continue;
      // In doubles: a crossing beside the opening's border ends the walk, or leads to a cell from
      // which it ends.
      const auto corners = openings_.corners_of(opening);
      const Vec3 normal = planes_[opening.plane].normal;
      bool is_in = true;
      for (std::size_t k = 0; k < corners.size() && is_in; ++k) {
        const Vec3 a = corners[k];
        const Vec3 b = corners[k + 1 == corners.size() ? 0 : k + 1];
        is_in = glm::dot(glm::cross(normal, b - a), crossing - a) >= 0;
      }
      if (!is_in) continue;
      next = opening.cells[opening.cells[0] == cell ? 1 : 0];
      break;
    }
    cell = next;
  }
  return find_cells(Viewpoint{eye, 1});
}

}  // namespace spoctree
