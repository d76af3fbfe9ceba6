#include "common/tree/cell_regions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

/// Bound of all rounding in the test of a cube against a plane, a few times over.
constexpr double kRounding = 0x1p-46;

/// So many clips of a cube take about as long as three clips of the parent's region.
constexpr std::size_t kFewPlanes = 4;

}  // namespace

CellRegions::Frame CellRegions::open(const Polyhedron* region) {
  const Frame frame = bounds_.size();
  if (region == nullptr) return frame;
  for (const Polyhedron::Face& face : region->faces) {
    if (face.plane.is_wall()) continue;
    const Plane plane = planes_[face.plane];
    const Vec3 n = plane.normal;
    bounds_.push_back({plane, std::abs(n.x) + std::abs(n.y) + std::abs(n.z), face.plane.index()});
  }
  return frame;
}

bool CellRegions::select(Frame frame, const NodeAddress& cell,
                         std::vector<std::uint32_t>& planes) const {
  planes.clear();
  if (frame == bounds_.size()) return true;
  const double half = planes_.half_side() * 0x1p-30 * cell.size();
  Vec3 centre;
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = wall_coordinate(planes_.half_side(), cell.lower[axis]) + half;
  }
  for (std::size_t i = frame; i < bounds_.size(); ++i) {
    const Bound& bound = bounds_[i];
    const double value = glm::dot(bound.plane.normal, centre) - bound.plane.offset;
    const double reach = bound.reach * half + kRounding;
    if (value > reach) return false;
    if (value > -reach) planes.push_back(bound.index);
  }
  return true;
}

bool CellRegions::make(const NodeAddress& cell, std::span<const std::uint32_t> planes,
                       const Polyhedron* parent_region, Polyhedron& region) {
  if (planes.size() <= kFewPlanes || parent_region == nullptr) {
    make_cell(cell.lower, cell.size(), planes_, region);
    return clip(region, planes);
  }
  region = *parent_region;
  for (int axis = 0; axis < 3; ++axis) {
    // The parent's middle walls are those that are odd in units of the cell's side.
    const std::uint32_t lower = cell.lower[axis];
    const bool is_upper = (lower & cell.size()) != 0;
    const PlaneRef middle = is_upper ? PlaneRef::of_wall(axis, lower).flipped()
                                     : PlaneRef::of_wall(axis, lower + cell.size());
    if (clipper_.clip(region, middle, planes_) == ClipResult::Empty) return false;
  }
  return true;
}

bool CellRegions::clip(Polyhedron& region, std::span<const std::uint32_t> planes) {
  return std::all_of(planes.begin(), planes.end(), [&](std::uint32_t plane) {
    return clipper_.clip(region, PlaneRef::of_table(plane), planes_) != ClipResult::Empty;
  });
}

}  // namespace spoctree
