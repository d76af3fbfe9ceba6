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
  /// Numbers the planes of the table densely, in their order.
  explicit Carriers(const Octree& tree);

  /// A number for the geometric plane, the same for all its names: that of the carrier if it is a
  /// plane of the table, a larger one for other walls. May be called from many threads.
  std::uint32_t number_of(PlaneRef ref) const {
    if (!ref.is_wall()) return table_sides_[ref.index()] >> 1;
    if (!walls_in_table_.empty()) {
      const std::uint32_t same = walls_in_table_.find(ref.carrier().code());
      if (same != FlatIndex::kNone) return same;
    }
    return kFirstWall + static_cast<std::uint32_t>(ref.axis()) * kWallsPerAxis + ref.index();
  }
  CarrierSide side_of_table(std::uint32_t index) const { return table_sides_[index]; }

  /// The carrier with this number; a wall becomes the next one when it is first asked for.
  std::uint32_t carrier_of(std::uint32_t number);

  std::uint32_t count() const { return static_cast<std::uint32_t>(carriers_.size()); }
  const Plane& plane(std::uint32_t carrier) const { return carriers_[carrier].plane; }
  /// A name for the plane, oriented towards `side`: of the table if possible, unflipped if
  /// possible.
  PlaneRef name(CarrierSide side) const { return carriers_[side >> 1].names[side & 1]; }
  /// True if the carrier is a cell wall (and a plane of the table, perhaps).
  bool is_wall(std::uint32_t carrier) const { return carriers_[carrier].is_wall; }

 private:
  static constexpr std::uint32_t kWallsPerAxis = (std::uint32_t{1} << kMaxDepth) + 1;
  static constexpr std::uint32_t kFirstWall = static_cast<std::uint32_t>(-1) - 3 * kWallsPerAxis;

  struct Carrier {
    Plane plane;
    PlaneRef names[2];
    bool is_wall;
  };
  CarrierSide add_of_table(PlaneRef ref);
  void find_wall(std::uint32_t carrier);

  PlaneSet planes_;
  std::vector<Carrier> carriers_;
  std::vector<CarrierSide> table_sides_;
  FlatIndex by_shape_;        // hash of the geometric plane -> carrier of the table
  FlatIndex walls_in_table_;  // PlaneRef::code -> carrier of the table
  FlatIndex other_walls_;     // number -> carrier
};

}  // namespace spoctree
