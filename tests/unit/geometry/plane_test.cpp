#include "common/geometry/plane.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/support/grid_planes.hpp"

namespace spoctree {
namespace {

TEST(IsValidPlane, AcceptsUnitNormalsOnTheGrid) {
  Random random(1);
  for (int k = 0; k < 10000; ++k) {
    const Plane plane = grid_plane_through(random_direction(random), random_vector(random, 1));
    EXPECT_TRUE(is_valid(plane));
    EXPECT_TRUE(is_valid(plane.flipped()));
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double offset : {-2.0, -1.0, 0.0, 0x1p-52, 2.0}) {
      Plane plane;
      plane.normal[axis] = -1;
      plane.offset = offset;
      EXPECT_TRUE(is_valid(plane));
    }
  }
}

TEST(IsValidPlane, RefusesEveryValueOutOfItsRange) {
  const Plane good = grid_plane_through({1, 2, 3}, {0.25, 0.5, -0.25});
  ASSERT_TRUE(is_valid(good));
  const double bad_values[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               0x1p-53,
                               0x1p-60,
                               1e-300,
                               5e-324,
                               1e300,
                               2 + 0x1p-51,
                               -3};
  for (const double value : bad_values) {
    Plane bad = good;
    bad.offset = value;
    EXPECT_FALSE(is_valid(bad)) << value;
    for (int axis = 0; axis < 3; ++axis) {
      bad = good;
      bad.normal[axis] = value;
      EXPECT_FALSE(is_valid(bad)) << value;
    }
  }
  for (const double factor : {0.0, 0.5, 1 - 0x1p-40, 1 + 0x1p-40, 2.0}) {
    Plane bad = good;
    for (int axis = 0; axis < 3; ++axis) {
      bad.normal[axis] =
          std::ldexp(std::nearbyint(std::ldexp(good.normal[axis] * factor, 52)), -52);
    }
    EXPECT_FALSE(is_valid(bad)) << factor;
  }
}

TEST(PlaneRef, HasTheBitLayoutThatItsCommentNames) {
  EXPECT_EQ(PlaneRef().code(), 0u);
  EXPECT_EQ(PlaneRef::of_table(5).code(), 5u);
  EXPECT_EQ(PlaneRef::of_table(0xffffffffu).code(), 0xffffffffu);
  EXPECT_EQ(PlaneRef::of_table(5).flipped().code(), (1ull << 62) | 5u);
  EXPECT_EQ(PlaneRef::of_wall(0, 7).code(), (1ull << 63) | 7u);
  EXPECT_EQ(PlaneRef::of_wall(2, 1u << 30).code(), (1ull << 63) | (2ull << 32) | (1u << 30));
  EXPECT_EQ(PlaneRef::of_wall(1, 7).flipped().code(),
            (1ull << 63) | (1ull << 62) | (1ull << 32) | 7u);
}

TEST(PlaneRef, GivesBackWhatItWasMadeOf) {
  std::set<std::uint64_t> codes;
  std::size_t count = 0;
  for (const std::uint32_t index : {0u, 1u, 1u << 29, 1u << 30, 0xfffffffeu}) {
    for (int axis = -1; axis < 3; ++axis) {
      const PlaneRef ref = axis < 0 ? PlaneRef::of_table(index) : PlaneRef::of_wall(axis, index);
      EXPECT_EQ(ref.is_wall(), axis >= 0);
      EXPECT_EQ(ref.index(), index);
      if (axis >= 0) {
        EXPECT_EQ(ref.axis(), axis);
      }
      EXPECT_FALSE(ref.is_flipped());
      const PlaneRef other = ref.flipped();
      EXPECT_TRUE(other.is_flipped());
      EXPECT_EQ(other.is_wall(), ref.is_wall());
      EXPECT_EQ(other.index(), index);
      EXPECT_EQ(other.flipped(), ref);
      EXPECT_EQ(other.carrier(), ref);
      EXPECT_EQ(ref.carrier(), ref);
      EXPECT_NE(other, ref);
      codes.insert(ref.code());
      codes.insert(other.code());
      count += 2;
    }
  }
  EXPECT_EQ(codes.size(), count);
}

TEST(PlaneSet, KnowsTableAndWallsEitherWayRound) {
  const std::vector<Plane> table{grid_plane_through({1, 2, 3}, {0.25, 0.5, -0.25}),
                                 grid_plane_through({-1, 0, 1}, {0.125, 0.5, 0})};
  const PlaneSet planes(table, 0.75);
  EXPECT_EQ(planes[PlaneRef::of_table(1)], table[1]);
  EXPECT_EQ(planes[PlaneRef::of_table(1).flipped()].normal, -table[1].normal);
  EXPECT_EQ(planes[PlaneRef::of_table(1).flipped()].offset, -table[1].offset);
  const Plane wall = planes[PlaneRef::of_wall(1, 3u << 28)];  // three quarters of the way up
  EXPECT_EQ(wall.normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(wall.offset, 0.375);
  EXPECT_EQ(planes[PlaneRef::of_wall(1, 3u << 28).flipped()].normal, (Vec3{0, -1, 0}));
  EXPECT_EQ(planes[PlaneRef::of_wall(1, 3u << 28).flipped()].offset, -0.375);
}

}  // namespace
}  // namespace spoctree
