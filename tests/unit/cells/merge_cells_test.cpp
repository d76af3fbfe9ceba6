// Which neighbours become one cell, and what neighbours share.
#include "client/cells/merge_cells.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "client/cells/openings.hpp"
#include "common/geometry/polyhedron_clipper.hpp"
#include "tests/support/polyhedron_checks.hpp"

namespace spoctree {
namespace {

/// A multiple of 2^-52.
constexpr double kThreeFifths = 0.6 + 0x1p-53;
constexpr std::uint32_t kWhole = std::uint32_t{1} << kMaxDepth;
constexpr std::uint32_t kHalf = kWhole / 2;

class Cells : public testing::Test {
 protected:
  /// An octant of the universe cube, as three digits.
  Polyhedron octant(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const std::uint32_t lower[3] = {x * kHalf, y * kHalf, z * kHalf};
    return make_cell(lower, kHalf, planes_);
  }
  Polyhedron clipped(Polyhedron cell, PlaneRef plane) const {
    EXPECT_NE(PolyhedronClipper().clip(cell, plane, planes_), ClipResult::Empty);
    return cell;
  }
  MergedCells merged(std::vector<Polyhedron> cells) const {
    return merge_cells(std::move(cells), planes_);
  }

  /// 0.6 x + 0.8 y <= 0.5, rounded to the grid, twice.
  const std::vector<Plane> table_ = {{{kThreeFifths, 0.8, 0}, 0.5}, {{kThreeFifths, 0.8, 0}, 0.5}};
  const PlaneSet planes_{table_, 1};
};

TEST_F(Cells, EightOctantsBecomeTheCube) {
  std::vector<Polyhedron> cells;
  for (std::uint32_t k = 0; k < 8; ++k) cells.push_back(octant(k & 1, k >> 1 & 1, k >> 2));
  const MergedCells one = merged(cells);
  ASSERT_EQ(one.cells.size(), 1u);
  EXPECT_EQ(structure_error(one.cells[0], planes_), "");
  EXPECT_DOUBLE_EQ(volume(one.cells[0]), 8);
  EXPECT_EQ(one.cell_of, std::vector<std::uint32_t>(8, 0));
}

TEST_F(Cells, AnLIsNotConvex) {
  const MergedCells two = merged({octant(0, 0, 0), octant(1, 0, 0), octant(0, 1, 0)});
  EXPECT_EQ(two.cells.size(), 2u);
  EXPECT_EQ(two.cell_of[0] == two.cell_of[1], two.cell_of[0] != two.cell_of[2]);
}

TEST_F(Cells, BothSidesOfAPlaneBecomeWhatItDivided) {
  const PlaneRef plane = PlaneRef::of_table(0);
  const Polyhedron cell = octant(1, 1, 0);
  const MergedCells one = merged({clipped(cell, plane), clipped(cell, plane.flipped())});
  ASSERT_EQ(one.cells.size(), 1u);
  EXPECT_NEAR(volume(one.cells[0]), 1, 1e-15);
  EXPECT_EQ(one.cells[0].faces.size(), 6u);
}

/// The planes that end them are equal, but have two names: one of the faces would lose its own.
TEST_F(Cells, NeighboursInPlanesOfDifferentNamesAreLeftAlone) {
  const MergedCells same = merged({clipped(octant(0, 0, 0), PlaneRef::of_table(0)),
                                   clipped(octant(0, 0, 1), PlaneRef::of_table(0))});
  EXPECT_EQ(same.cells.size(), 1u);
  const MergedCells upper = merged({clipped(octant(1, 1, 0), PlaneRef::of_table(0)),
                                    clipped(octant(1, 1, 1), PlaneRef::of_table(0))});
  EXPECT_EQ(upper.cells.size(), 1u);
  const MergedCells different = merged({clipped(octant(1, 1, 0), PlaneRef::of_table(0)),
                                        clipped(octant(1, 1, 1), PlaneRef::of_table(1))});
  EXPECT_EQ(different.cells.size(), 2u);
}

double area(std::span<const Vec3> corners) {
  Vec3 twice_area{0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    twice_area += glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  }
  return 0.5 * glm::length(twice_area);
}

TEST_F(Cells, OpeningsAreWhatFacesHaveInCommon) {
  // The left half of the cube in one cell, two octants on its right.
  const MergedCells left =
      merged({octant(0, 0, 0), octant(0, 1, 0), octant(0, 0, 1), octant(0, 1, 1)});
  ASSERT_EQ(left.cells.size(), 1u);
  const Openings found = find_openings(
      {left.cells[0], octant(1, 0, 0), clipped(octant(1, 1, 1), PlaneRef::of_table(0))}, planes_);
  double between = 0;
  std::size_t outer = 0;
  for (const Opening& opening : found.openings) {
    if (opening.cells[1] == kOuterSpace) {
      ++outer;
      continue;
    }
    EXPECT_EQ(opening.cells[0], 0u);
    EXPECT_EQ(opening.plane, PlaneRef::of_wall(0, kHalf));
    between += area(found.corners_of(opening));
  }
  // At x = 0, the plane leaves y <= 5/8 of the second octant's face.
  EXPECT_DOUBLE_EQ(between, 1 + 0.625);
  EXPECT_EQ(outer, 5u + 3u + 1u);
  EXPECT_EQ(found.of(0).size(), 7u);
  EXPECT_EQ(found.of(kOuterSpace).size(), outer);
}

}  // namespace
}  // namespace spoctree
