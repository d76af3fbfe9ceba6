// States of cell corners, against exact inside tests of solids that know their inside.
#include "server/build/corner_states.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "server/solid/solid_queries.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

/// Gives every cell the state of one corner, lets the others follow, and compares them.
/// `is_inside` is asked about points off the boundary only. Returns the share of known corners.
template <class IsInside>
double judge(const Solid& solid, std::uint32_t depth, IsInside is_inside) {
  const Incidence incidence(solid);
  std::size_t known = 0;
  std::size_t all = 0;
  for (Cell& cell : cells_of(solid, incidence, depth)) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      cell.corners.fill(CornerState::Unknown);
      cell.corners[seed] =
          is_inside(just_inside(solid, cell, seed)) ? CornerState::Inside : CornerState::Outside;
      propagate_corner_states(solid, cell);
      for (unsigned octant = 0; octant < 8; ++octant) {
        ++all;
        const CornerState state = cell.corners[octant];
        known += state != CornerState::Unknown;
        if (state == CornerState::Boundary || state == CornerState::Unknown) continue;
        EXPECT_EQ(state == CornerState::Inside, is_inside(just_inside(solid, cell, octant)))
            << "corner " << octant << " of a cell at " << cell.lower[0] << " " << cell.lower[1]
            << " " << cell.lower[2] << " seen from " << seed;
      }
    }
  }
  return static_cast<double>(known) / static_cast<double>(all);
}

TEST(CornerStates, OfVoxelsWhoseFacesLieInWalls) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Voxels voxels = random_voxels(2, random);
    const Solid solid = voxel_solid(voxels);
    const auto is_inside = [&](Vec3 p) {
      const Vec3 cell = (p + 1.0) * 2.0;
      return voxels(static_cast<int>(std::floor(cell.x)), static_cast<int>(std::floor(cell.y)),
                    static_cast<int>(std::floor(cell.z)));
    };
    for (const std::uint32_t depth : {1u, 2u, 3u}) judge(solid, depth, is_inside);
  }
}

TEST(CornerStates, OfHeightFieldsOverTheWalls) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const HeightField field = random_height_field(4, Vec3(-1), 0.5, -0.75, 0.125, 13, random);
    const Solid solid = height_field_solid(field);
    const auto is_inside = [&](Vec3 p) { return field.is_inside(p).value(); };
    for (const std::uint32_t depth : {1u, 2u, 3u}) judge(solid, depth, is_inside);
  }
}

TEST(CornerStates, AllFollowFromOneWhereNothingIsDegenerate) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Random random(seed);
    const Solid solid = uneven_solid(4, random);
    const SolidQueries queries(solid);
    const auto is_inside = [&](Vec3 p) { return queries.side_of(p) == SolidQueries::Side::In; };
    EXPECT_EQ(judge(solid, 2, is_inside), 1);
  }
}

TEST(CornerStates, ACornerOnTheBoundaryIsCalledThat) {
  // The box's corner stands exactly on the common corner of all cells.
  const Solid solid = box_solid(Vec3(-0.5), Vec3(0));
  const Incidence incidence(solid);
  auto cells = cells_of(solid, incidence, 1);
  cells[0].corners[0] = CornerState::Outside;
  propagate_corner_states(solid, cells[0]);
  EXPECT_EQ(cells[0].corners[7], CornerState::Boundary);
  for (const unsigned octant : {1u, 2u, 4u}) {
    EXPECT_EQ(cells[0].corners[octant], CornerState::Outside);
  }
}

}  // namespace
}  // namespace spoctree
