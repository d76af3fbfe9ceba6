// Convex cells -> the convex polygons that neighbours share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/progress_meter.hpp"
#include "common/base/small_count.hpp"
#include "common/geometry/polyhedron.hpp"

namespace spoctree {

/// Stands for the space around the universe cube.
inline constexpr auto kOuterSpace = static_cast<std::uint32_t>(-1);

/// A polygon through which two cells see each other.
struct Opening {
  std::uint32_t cells[2] = {0, 0};  ///< the second one may be kOuterSpace
  PlaneRef plane;                   ///< outward of the first cell
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
};

struct Openings {
  std::vector<Opening> openings;
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> begin;    ///< by cell, into `numbers`; then that of outer space
  std::vector<std::uint32_t> numbers;  ///< of openings

  /// Counter-clockwise seen from the second cell.
  std::span<const Vec3> corners_of(const Opening& opening) const {
    return {corners.data() + opening.first_corner, opening.corner_count};
  }
  /// The numbers of a cell's openings, ascending; those of the universe's walls for kOuterSpace.
  std::span<const std::uint32_t> of(std::uint32_t cell) const {
    const std::size_t at = cell == kOuterSpace ? begin.size() - 2 : cell;
    return {numbers.data() + begin[at], begin[at + 1] - begin[at]};
  }
};

/// All of them: where a face of one cell and one of another lie in the same plane, on different
/// sides, their intersection, exactly, if it has area; and faces in the universe's walls. About
/// O(n log n) for the faces of a plane, and the openings. REQUIRES: disjoint cells; where two meet,
/// both have a face with a plane of the same name there. Throws BadInput if there are more than
/// `most` openings, or what `progress` throws.
Openings find_openings(const std::vector<Polyhedron>& cells, const PlaneSet& planes,
                       const ProgressShare& progress = {}, std::size_t most = kMostIn32Bits / 2);

}  // namespace spoctree
