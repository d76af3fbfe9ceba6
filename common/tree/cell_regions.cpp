#include "common/tree/cell_regions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace spoctree {

namespace {

/// Bound of all rounding in the tests of a cube against a plane and of boxes (their corners err by
/// 2^-45 at most), a few times over.
constexpr double kRounding = 0x1p-43;

/// More clips of a cube take longer than three of the parent's region.
constexpr std::size_t kFewPlanes = 6;

/// From so many planes on, all cut at once: one after the other, they take ten times as long.
constexpr std::size_t kManyPlanes = 1024;

}  // namespace

CellRegions::Frame CellRegions::open(const Polyhedron* region) {
  const Frame frame = bounds_.size();
  if (region == nullptr) return frame;
  for (const Polyhedron::Face& face : region->faces) {
    if (face.plane.is_wall()) continue;
    const Plane plane = planes_[face.plane];
    const Vec3 n = plane.normal;
    Vec3 lower(2.0);
    Vec3 upper(-2.0);
    for (const Polyhedron::Corner& corner : region->loop(face)) {
      const Vec3 position = region->vertices[corner.vertex].position;
      lower = glm::min(lower, position);
      upper = glm::max(upper, position);
    }
    bounds_.push_back(
        {plane, std::abs(n.x) + std::abs(n.y) + std::abs(n.z), lower, upper, face.plane.index()});
  }
  return frame;
}

bool CellRegions::select(Frame frame, const NodeAddress& cell, std::vector<std::uint32_t>& planes,
                         std::size_t& near) const {
  planes.clear();
  near = 0;
  if (frame == bounds_.size()) return true;
  const double half = planes_.half_side() * 0x1p-30 * cell.size();
  Vec3 centre;
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = wall_coordinate(planes_.half_side(), cell.lower[axis]) + half;
  }
  const double margin = half + kRounding;
  for (std::size_t i = frame; i < bounds_.size(); ++i) {
    const Bound& bound = bounds_[i];
    const double value = glm::dot(bound.plane.normal, centre) - bound.plane.offset;
    const double reach = bound.reach * half + kRounding;
    if (value > reach) return false;
    if (value <= -reach) continue;
    planes.push_back(bound.index);
    const Vec3 off = glm::max(bound.lower - centre, centre - bound.upper);
    if (off.x > margin || off.y > margin || off.z > margin) continue;
    std::swap(planes[near++], planes.back());
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
  if (planes.size() >= kManyPlanes) return many_clipper_.clip(region, planes, planes_);
  return std::all_of(planes.begin(), planes.end(), [&](std::uint32_t plane) {
    return clipper_.clip(region, PlaneRef::of_table(plane), planes_) != ClipResult::Empty;
  });
}

}  // namespace spoctree
