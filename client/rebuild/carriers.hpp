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

/// Numbers the geometric planes of a tree densely. Two planes of the table may be the same plane,
/// the same or opposite way round, and a plane of the table may lie exactly in a cell wall: all of
/// these are one carrier. Exact.
class Carriers {
 public:
  /// Numbers the planes of the table; walls get their numbers when they are first asked for.
  explicit Carriers(const Octree& tree);

  CarrierSide side_of(PlaneRef ref) {
    const CarrierSide side =
        ref.is_wall() ? side_of_wall(ref.carrier()) : table_sides_[ref.index()];
    return ref.is_flipped() ? side ^ 1u : side;
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(carriers_.size()); }
  const Plane& plane(std::uint32_t carrier) const { return carriers_[carrier].plane; }
  /// A name for the plane, oriented towards `side`: of the table if possible, unflipped if
  /// possible.
  PlaneRef name(CarrierSide side) const { return carriers_[side >> 1].names[side & 1]; }

 private:
  struct Carrier {
    Plane plane;
    PlaneRef names[2];
  };
  CarrierSide side_of_wall(PlaneRef wall);
  CarrierSide add(PlaneRef ref);

  PlaneSet planes_;
  std::vector<Carrier> carriers_;
  std::vector<CarrierSide> table_sides_;
  FlatIndex walls_;     // PlaneRef::code -> CarrierSide
  FlatIndex by_shape_;  // hash of the geometric plane -> carrier
};

}  // namespace spoctree
