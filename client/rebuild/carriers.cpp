#include "client/rebuild/carriers.hpp"

#include <bit>
#include <cmath>

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

Carriers::Carriers(const Octree& tree) : planes_(tree.plane_set()) {
  const auto count = static_cast<std::uint32_t>(tree.planes.size());
  carriers_.reserve(count);
  table_sides_.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) table_sides_.push_back(add(PlaneRef::of_table(i)));
}

CarrierSide Carriers::side_of_wall(PlaneRef wall) {
  const std::uint32_t known = walls_.find(wall.code(), [](std::uint32_t) { return true; });
  if (known != FlatIndex::kNone) return known;
  const CarrierSide side = add(wall);
  walls_.insert(wall.code(), side);
  return side;
}

CarrierSide Carriers::add(PlaneRef ref) {
  const Plane plane = planes_[ref];
  const std::uint64_t hash = shape_hash(plane);
  const std::uint32_t same = by_shape_.find(
      hash, [&](std::uint32_t carrier) { return is_same_plane(carriers_[carrier].plane, plane); });
  if (same == FlatIndex::kNone) {
    const auto carrier = static_cast<std::uint32_t>(carriers_.size());
    carriers_.push_back({plane, {ref, ref.flipped()}});
    by_shape_.insert(hash, carrier);
    return 2 * carrier;
  }
  Carrier& carrier = carriers_[same];
  const int axis = main_axis(plane);
  const std::uint32_t side = plane.normal[axis] * carrier.plane.normal[axis] < 0 ? 1 : 0;
  if (carrier.names[side].is_flipped() && !ref.is_wall()) carrier.names[side] = ref;
  return 2 * same + side;
}

}  // namespace spoctree
