// Plane names -> numbers of geometric planes: what is one plane gets one number, whatever its
// names.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/flat_index.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// A carrier's number and a side of it, 2 * carrier + side. Side 0 is that of the carrier's own
/// normal: a face whose outward normal is the carrier's is on side 0, one that looks the other way
/// on side 1.
using CarrierSide = std::uint32_t;

/// The geometric planes of a tree: carriers. Two planes of the table may be the same plane, the
/// same or opposite way round, and a plane of the table may lie exactly in a cell wall: all of
/// these are one carrier. Exact.
class Carriers {
 public:
  Carriers() = default;
  /// Of all planes of the table.
  explicit Carriers(const Octree& tree) {
    grow(tree, static_cast<std::uint32_t>(tree.planes.size()));
  }

  /// Numbers the first `plane_count` planes of the table densely, in their order; those that have a
  /// number keep it. REQUIRES: the table begins with the planes of the last call's; it is there as
  /// long as carriers are asked for. O(new planes).
  void grow(const Octree& tree, std::uint32_t plane_count);

  /// A number for the geometric plane, the same for all its names, and now and after any growth: a
  /// wall's own, which is larger than any other, or that of the carrier. May be called from many
  /// threads.
  std::uint32_t number_of(PlaneRef ref) const {
    return ref.is_wall() ? number_of_wall(ref) : numbers_[ref.index()];
  }
  CarrierSide side_of_table(std::uint32_t index) const { return table_sides_[index]; }

  /// The carrier with this number; a wall that no plane of the table lies in becomes the next one
  /// when it is first asked for, until the carriers grow.
  std::uint32_t carrier_of(std::uint32_t number);

  std::uint32_t count() const { return static_cast<std::uint32_t>(carriers_.size()); }
  /// Of the planes of the table; their carriers come first.
  std::uint32_t table_count() const { return table_count_; }
  const Plane& plane(std::uint32_t carrier) const { return carriers_[carrier].plane; }
  /// A name for the plane, oriented towards `side`: of the table if possible, unflipped if
  /// possible.
  PlaneRef name(CarrierSide side) const { return carriers_[side >> 1].names[side & 1]; }
  /// True if the carrier is a cell wall (and a plane of the table, perhaps).
  bool is_wall(std::uint32_t carrier) const { return carriers_[carrier].number >= kFirstWall; }

 private:
  static constexpr std::uint32_t kWallsPerAxis = (std::uint32_t{1} << kMaxDepth) + 1;
  static constexpr std::uint32_t kFirstWall = static_cast<std::uint32_t>(-1) - 3 * kWallsPerAxis;

  struct Carrier {
    Plane plane;
    PlaneRef names[2];
    std::uint32_t number;
  };
  static std::uint32_t number_of_wall(PlaneRef ref) {
    return kFirstWall + static_cast<std::uint32_t>(ref.axis()) * kWallsPerAxis + ref.index();
  }
  CarrierSide add_of_table(PlaneRef ref);
  void find_wall(std::uint32_t carrier);

  const Octree* tree_ = nullptr;
  std::vector<Carrier> carriers_;
  std::uint32_t table_count_ = 0;
  std::vector<std::uint32_t> numbers_;  // of the table's planes
  std::vector<CarrierSide> table_sides_;
  FlatIndex by_shape_;        // hash of the geometric plane -> carrier of the table
  FlatIndex walls_in_table_;  // number -> carrier of the table
  FlatIndex other_walls_;     // number -> carrier
};

}  // namespace spoctree
