// Volumes of material in cells against counting cubes, boxes cut by boxes, and sums.
#include "server/build/cell_volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

double sum_of_cells(const Solid& solid, std::uint32_t depth) {
  const Incidence incidence(solid);
  const SolidQueries queries(solid);
  double sum = 0;
  for (const Cell& cell : cells_of(solid, incidence, depth)) {
    sum += material_volume(solid, queries, cell);
  }
  return sum;
}

TEST(MaterialVolume, CountsVoxels) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Voxels voxels = random_voxels(3, random);
    const Solid solid = voxel_solid(voxels);
    const Incidence incidence(solid);
    const SolidQueries queries(solid);
    const double voxel = 1.0 / 64;  // (2 / 8)^3
    for (const std::uint32_t depth : {0u, 1u, 2u, 3u}) {
      const int cells = 1 << depth;
      const int each = 8 / cells;
      std::size_t i = 0;
      for (const Cell& cell : cells_of(solid, incidence, depth)) {
        const int at[3] = {static_cast<int>(i) % cells * each,
                           static_cast<int>(i) / cells % cells * each,
                           static_cast<int>(i) / (cells * cells) * each};
        ++i;
        int count = 0;
        for (int k = 0; k < each * each * each; ++k) {
          count += voxels(at[0] + k % each, at[1] + k / each % each, at[2] + k / (each * each));
        }
        EXPECT_NEAR(material_volume(solid, queries, cell), count * voxel, 1e-13)
            << "seed " << seed << " depth " << depth << " cell " << i - 1;
      }
    }
  }
}

TEST(MaterialVolume, OfABoxIsThatOfTheCommonBox) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    Vec3 lower;
    Vec3 upper;
    for (int axis = 0; axis < 3; ++axis) {
      // Some sides in walls, others anywhere on the grid.
      const auto anywhere = [&] { return std::ldexp(std::floor(random.between(1, 1024)), -10); };
      const auto in_wall = [&] { return 0.125 * (1 + random.below(8)); };
      lower[axis] = -(random.chance(0.5) ? in_wall() : anywhere());
      upper[axis] = random.chance(0.5) ? in_wall() : anywhere();
    }
    const Solid solid = box_solid(lower, upper);
    const Incidence incidence(solid);
    const SolidQueries queries(solid);
    for (const std::uint32_t depth : {0u, 1u, 2u, 3u}) {
      for (const Cell& cell : cells_of(solid, incidence, depth)) {
        double expected = 1;
        for (int axis = 0; axis < 3; ++axis) {
          expected *= std::max(0.0, std::min(upper[axis], cell.wall(solid, axis, true)) -
                                        std::max(lower[axis], cell.wall(solid, axis, false)));
        }
        EXPECT_NEAR(material_volume(solid, queries, cell), expected, 1e-14);
      }
    }
  }
}

TEST(MaterialVolume, OfAllCellsIsThatOfTheSolid) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const HeightField field = random_height_field(4, Vec3(-1), 0.5, -0.75, 0.125, 13, random);
    const Solid even = height_field_solid(field);
    const Solid uneven = uneven_solid(4, random);
    for (const std::uint32_t depth : {0u, 1u, 2u, 3u}) {
      EXPECT_NEAR(sum_of_cells(even, depth), field.volume(), 1e-13);
      EXPECT_NEAR(sum_of_cells(uneven, depth), uneven.volume, 1e-13);
    }
  }
}

TEST(MaterialVolume, OfAHollowBoxLeavesOutTheCavity) {
  const Solid solid = together(box_solid(Vec3(-0.75), Vec3(0.75)),
                               turned(box_solid(Vec3(-0.25, -0.5, 0), Vec3(0.5, 0.25, 0.3125))));
  for (const std::uint32_t depth : {0u, 1u, 2u, 3u}) {
    EXPECT_NEAR(sum_of_cells(solid, depth), 1.5 * 1.5 * 1.5 - 0.75 * 0.75 * 0.3125, 1e-14);
  }
}

}  // namespace
}  // namespace spoctree
