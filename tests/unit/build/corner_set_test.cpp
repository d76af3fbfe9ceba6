// The corner set against asking every corner.
#include "server/build/corner_set.hpp"

#include <gtest/gtest.h>

#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

TEST(CornerSet, FindsWhatAskingEveryCornerFinds) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    const Solid solid =
        seed % 2 == 0
            ? height_field_solid(random_height_field(6, Vec3(-0.75), 0.25, -0.5, 0.125, 7, random))
            : uneven_solid(6, random);
    const Incidence incidence(solid);
    const CornerSides sides(solid, incidence);
    std::size_t yes = 0;
    std::size_t no = 0;
    for (const std::uint32_t depth : {0u, 1u, 2u}) {
      const auto cells = cells_of(solid, incidence, depth);
      for (const Cell& cell : cells) {
        CornerSet set;
        set.add(FragmentCorner{}, 0);  // forgotten by `clear`
        set.clear();
        for (const Fragment& fragment : cell.boundary.fragments) {
          for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) {
            set.add(corner, fragment.triangle);
          }
        }
        set.prepare();
        for (std::uint32_t plane = 0; plane < solid.planes.size(); ++plane) {
          for (const int sign : {-1, 1}) {
            bool expected = false;
            for (const Fragment& fragment : cell.boundary.fragments) {
              for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) {
                expected |= sides.side(corner, fragment.triangle, plane) == sign;
              }
            }
            ASSERT_EQ(set.any_on_side(plane, sign, solid.planes[plane], sides), expected);
            (expected ? yes : no) += 1;
          }
        }
      }
    }
    EXPECT_GT(yes, 100u);
    EXPECT_GT(no, 100u);
  }
}

TEST(CornerSet, HasNothingOnAnySideWhenEmpty) {
  const Solid solid = box_solid(Vec3(-0.5), Vec3(0.5));
  const Incidence incidence(solid);
  CornerSet set;
  set.prepare();
  EXPECT_FALSE(set.any_on_side(0, +1, solid.planes[0], CornerSides(solid, incidence)));
  EXPECT_FALSE(set.any_on_side(0, -1, solid.planes[0], CornerSides(solid, incidence)));
}

}  // namespace
}  // namespace spoctree
