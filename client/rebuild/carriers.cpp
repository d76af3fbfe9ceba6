#include "client/rebuild/carriers.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>

namespace spoctree {

namespace {

__extension__ using Int128 = __int128;

std::int64_t to_grid_integer(double value) {
  return static_cast<std::int64_t>(std::ldexp(value, kGridBits));
}

/// The largest component of the normal, the first of equals: the same for both orientations.
int main_axis(const Plane& plane) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(plane.normal[i]) > std::abs(plane.normal[axis])) axis = i;
  }
  return axis;
}

/// A function of the geometric plane alone: quotients are correctly rounded, so proportional
/// numbers give the same ones.
std::uint64_t shape_hash(const Plane& plane) {
  const int axis = main_axis(plane);
  const double numerators[3] = {plane.normal[(axis + 1) % 3], plane.normal[(axis + 2) % 3],
                                plane.offset};
  auto hash = static_cast<std::uint64_t>(axis);
  for (const double numerator : numerators) {
    // Adding zero makes -0 and +0 one.
    const double quotient = numerator / plane.normal[axis] + 0.0;
    hash = mix_bits(hash + std::bit_cast<std::uint64_t>(quotient));
  }
  return hash;
}

bool is_same_plane(const Plane& p, const Plane& q) {
  const int axis = main_axis(p);
  const Int128 pm = to_grid_integer(p.normal[axis]);
  const Int128 qm = to_grid_integer(q.normal[axis]);
  for (int i = 0; i < 3; ++i) {
    if (pm * to_grid_integer(q.normal[i]) != qm * to_grid_integer(p.normal[i])) return false;
  }
  return pm * to_grid_integer(q.offset) == qm * to_grid_integer(p.offset);
}

}  // namespace

void Carriers::grow(const Octree& tree, std::uint32_t plane_count) {
  if (plane_count >= kFirstWall) throw std::length_error("rebuild: too many planes");
  tree_ = &tree;
  carriers_.resize(table_count_);
  other_walls_ = {};
  const auto known = static_cast<std::uint32_t>(table_sides_.size());
  if (plane_count <= known) return;
  carriers_.reserve(plane_count);
  by_shape_.reserve(plane_count);
  for (std::uint32_t i = known; i < plane_count; ++i) {
    table_sides_.push_back(add_of_table(PlaneRef::of_table(i)));
  }
  for (std::uint32_t carrier = table_count_; carrier < carriers_.size(); ++carrier) {
    find_wall(carrier);
  }
  table_count_ = count();
  for (std::uint32_t i = known; i < plane_count; ++i) {
    numbers_.push_back(carriers_[table_sides_[i] >> 1].number);
  }
}

CarrierSide Carriers::add_of_table(PlaneRef ref) {
  const Plane plane = tree_->planes[ref.index()];
  const std::uint64_t hash = shape_hash(plane);
  const std::uint32_t same = by_shape_.find(
      hash, [&](std::uint32_t carrier) { return is_same_plane(carriers_[carrier].plane, plane); });
  if (same == FlatIndex::kNone) {
    const auto carrier = static_cast<std::uint32_t>(carriers_.size());
    carriers_.push_back({plane, {ref, ref.flipped()}, carrier});
    by_shape_.insert(hash, carrier);
    return 2 * carrier;
  }
  Carrier& carrier = carriers_[same];
  const int axis = main_axis(plane);
  const std::uint32_t side = plane.normal[axis] * carrier.plane.normal[axis] < 0 ? 1 : 0;
  if (carrier.names[side].is_flipped()) carrier.names[side] = ref;
  return 2 * same + side;
}

/// Finds the cell wall that a plane of the table lies in, if any.
void Carriers::find_wall(std::uint32_t carrier) {
  const Plane& plane = carriers_[carrier].plane;
  const int axis = main_axis(plane);
  if (plane.normal[(axis + 1) % 3] != 0 || plane.normal[(axis + 2) % 3] != 0) return;
  const double at = plane.offset / plane.normal[axis];
  const double index = std::nearbyint((at / tree_->universe.half_side + 1) * 0x1p29);
  if (!(index >= 0 && index <= 0x1p30)) return;
  const PlaneRef wall = PlaneRef::of_wall(axis, static_cast<std::uint32_t>(index));
  if (!is_same_plane(plane, tree_->plane_set()[wall])) return;
  carriers_[carrier].number = number_of_wall(wall);
  walls_in_table_.insert(number_of_wall(wall), carrier);
}

std::uint32_t Carriers::carrier_of(std::uint32_t number) {
  if (number < kFirstWall) return number;
  for (const FlatIndex* walls : {&walls_in_table_, &other_walls_}) {
    const std::uint32_t known = walls->find(number);
    if (known != FlatIndex::kNone) return known;
  }
  const std::uint32_t wall = number - kFirstWall;
  const PlaneRef ref =
      PlaneRef::of_wall(static_cast<int>(wall / kWallsPerAxis), wall % kWallsPerAxis);
  const auto carrier = static_cast<std::uint32_t>(carriers_.size());
  carriers_.push_back({tree_->plane_set()[ref], {ref, ref.flipped()}, number});
  other_walls_.insert(number, carrier);
  return carrier;
}

}  // namespace spoctree
