// Planes on the grid, and short names for them.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// The plane { y : normal . y = offset } in universe coordinates; its half-space { normal . y <=
/// offset } is the side of the material. `normal` is a unit vector and `offset` at most 2 in
/// magnitude, both rounded to multiples of 2^-52: every Plane is a set of four integers of at most
/// 54 bits, so the predicates on planes are exact.
struct Plane {
  Vec3 normal{0.0};
  double offset = 0;

  Plane flipped() const { return {-normal, -offset}; }
  bool operator==(const Plane&) const = default;
};

/// True if the four numbers are on the grid and the normal is of unit length up to rounding.
bool is_valid(const Plane& plane);

/// Names an oriented plane: a plane of the table, or a cell wall, either way round. Bit layout:
/// 63: is a wall - 62: flipped - walls: 32-33 the axis, 0-31 the wall index (see wall_coordinate) -
/// planes of the table: 0-31 the index. A wall that is not flipped has its normal along +axis.
class PlaneRef {
 public:
  PlaneRef() = default;
  static PlaneRef of_table(std::uint32_t index) { return PlaneRef(index); }
  static PlaneRef of_wall(int axis, std::uint32_t index) {
    return PlaneRef(kWall | (static_cast<std::uint64_t>(axis) << 32) | index);
  }

  bool is_wall() const { return (code_ & kWall) != 0; }
  bool is_flipped() const { return (code_ & kFlipped) != 0; }
  /// The index in the plane table, or the index of the wall.
  std::uint32_t index() const { return static_cast<std::uint32_t>(code_); }
  int axis() const { return static_cast<int>((code_ >> 32) & 3); }
  PlaneRef flipped() const { return PlaneRef(code_ ^ kFlipped); }
  /// The same plane in its unflipped orientation.
  PlaneRef carrier() const { return PlaneRef(code_ & ~kFlipped); }
  std::uint64_t code() const { return code_; }

  bool operator==(const PlaneRef&) const = default;
  auto operator<=>(const PlaneRef&) const = default;

 private:
  static constexpr std::uint64_t kWall = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kFlipped = std::uint64_t{1} << 62;
  explicit PlaneRef(std::uint64_t code) : code_(code) {}
  std::uint64_t code_ = 0;
};

/// What PlaneRefs mean: a plane table and the half side of the universe cube.
class PlaneSet {
 public:
  PlaneSet(const std::vector<Plane>& table, double half_side)
      : table_(&table), half_side_(half_side) {}
  Plane operator[](PlaneRef ref) const {
    Plane plane;
    if (ref.is_wall()) {
      plane.normal[ref.axis()] = 1.0;
      plane.offset = wall_coordinate(half_side_, ref.index());
    } else {
      plane = (*table_)[ref.index()];
    }
    return ref.is_flipped() ? plane.flipped() : plane;
  }
  double half_side() const { return half_side_; }

 private:
  const std::vector<Plane>* table_;
  double half_side_;
};

}  // namespace spoctree
