#include "tests/support/eyes_within.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

namespace spoctree {

namespace {

/// The cells that ways through openings lead to, `from` with them; not through outer space.
void spread(const EmptySpace& space, std::uint32_t from, std::vector<bool>& reached) {
  std::vector<std::uint32_t> open{from};
  if (from != kOuterSpace) reached[from] = true;
  while (!open.empty()) {
    const std::uint32_t cell = open.back();
    open.pop_back();
    for (const std::uint32_t number : space.openings().of(cell)) {
      const Opening& opening = space.openings().openings[number];
      const std::uint32_t next = opening.cells[opening.cells[0] == cell ? 1 : 0];
      if (next == kOuterSpace || reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
}

}  // namespace

std::vector<bool> cells_open_to_outer_space(const EmptySpace& space) {
  std::vector<bool> reached(space.cells().size(), false);
  spread(space, kOuterSpace, reached);
  return reached;
}

std::vector<EyeWithin> eyes_within(const EmptySpace& space, std::size_t most) {
  const Octree& tree = space.tree();
  const auto root_planes = tree.levels[0].planes_of(0);
  std::vector<double> volumes;
  std::vector<Vec3> middles;
  for (const Polyhedron& cell : space.cells()) {
    volumes.push_back(volume(cell));
    Vec3 sum{0.0};
    for (const PolyhedronVertex& vertex : cell.vertices) sum += vertex.position;
    middles.push_back(sum / static_cast<double>(cell.vertices.size()));
  }
  std::vector<std::uint32_t> order(space.cells().size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t p, std::uint32_t q) { return volumes[p] > volumes[q]; });
  const std::vector<bool> is_open = cells_open_to_outer_space(space);
  std::vector<bool> reached = is_open;
  std::vector<EyeWithin> eyes;
  for (const std::uint32_t cell : order) {
    if (eyes.size() == most || reached[cell]) continue;
    eyes.push_back({middles[cell], true});
    spread(space, cell, reached);
  }
  for (const std::uint32_t cell : order) {
    if (eyes.size() == most) break;
    if (!is_open[cell]) continue;
    if (std::all_of(root_planes.begin(), root_planes.end(), [&](std::uint32_t plane) {
          return glm::dot(tree.planes[plane].normal, middles[cell]) < tree.planes[plane].offset;
        })) {
      eyes.push_back({middles[cell], false});
    }
  }
  return eyes;
}

}  // namespace spoctree
