// Masks: what openings leave of the picture, and what of a line is seen through them.
#include "client/cells/sight_mask.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spoctree {
namespace {

/// An opening between points of the picture plane, or of space.
std::vector<SightOpening::Corner> opening(const std::vector<SightPoint>& points) {
  std::vector<SightOpening::Corner> corners;
  for (std::size_t k = 0; k < points.size(); ++k) {
    corners.push_back({points[k], sight_line(points[k], points[(k + 1) % points.size()])});
  }
  return corners;
}

const Rectangle kPicture{{-1, -1}, {1, 1}};
constexpr double kThin = 1e-12;

TEST(SightMask, OfAPictureIsItsRectangle) {
  const SightMask mask = mask_of({{-1, -2}, {3, 4}});
  EXPECT_DOUBLE_EQ(area_of(mask.corners), 24);
  for (const SightMask::Corner& corner : mask.corners) {
    EXPECT_DOUBLE_EQ(corner.line(Vec2{1, 1}) > 0, true);
    EXPECT_EQ(corner.line(corner.at), 0);
  }
}

TEST(SightMask, IsCutByAnOpeningThatReachesBeyondIt) {
  const SightMask picture = mask_of(kPicture);
  const auto corners = opening({{0, 0, 1}, {5, 0, 1}, {5, 5, 1}, {0, 5, 1}});
  SightMask left;
  ASSERT_TRUE(MaskClipper().clip(picture.corners, {corners}, kThin, left));
  EXPECT_DOUBLE_EQ(area_of(left.corners), 1);
}

TEST(SightMask, IsKeptByAnOpeningAroundIt) {
  const SightMask picture = mask_of(kPicture);
  const auto corners = opening({{-2, -2, 1}, {5, -2, 1}, {5, 5, 1}, {-2, 5, 1}});
  SightMask left;
  ASSERT_TRUE(MaskClipper().clip(picture.corners, {corners}, kThin, left));
  EXPECT_EQ(left.corners.size(), 4u);
  EXPECT_DOUBLE_EQ(area_of(left.corners), 4);
}

TEST(SightMask, EndsWhereAnOpeningIsBesideIt) {
  const SightMask picture = mask_of(kPicture);
  SightMask left;
  const auto beside = opening({{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}});
  EXPECT_FALSE(MaskClipper().clip(picture.corners, {beside}, kThin, left));
  // A slit narrower than the thinnest mask.
  const auto slit = opening({{0, -1, 1}, {1e-13, -1, 1}, {1e-13, 1, 1}, {0, 1, 1}});
  EXPECT_FALSE(MaskClipper().clip(picture.corners, {slit}, kThin, left));
}

/// A floor's opening below the eye reaches behind it: the picture has all below the horizon.
TEST(SightMask, IsCutByAnOpeningThatReachesBehindTheEye) {
  const SightMask picture = mask_of(kPicture);
  // At y = -1, seen from above: x from -100 to 100, depth w from -100 to 100.
  const auto floor = opening({{-100, -1, -100}, {100, -1, -100}, {100, -1, 100}, {-100, -1, 100}});
  SightMask left;
  ASSERT_TRUE(MaskClipper().clip(picture.corners, {floor}, kThin, left));
  // Down to y = -1 in the picture; the floor ends at y / w = -1 / 100.
  EXPECT_NEAR(area_of(left.corners), 2 * (1 - 0.01), 1e-12);
}

TEST(SightMask, ShowsThePartOfALineWithinIt) {
  const SightMask picture = mask_of(kPicture);
  Interval part{0, 1};
  clip_line({-3, 0, 1}, {5, 0, 1}, picture.corners, 0, part);
  EXPECT_DOUBLE_EQ(part.begin, 0.25);
  EXPECT_DOUBLE_EQ(part.end, 0.5);
  part = {0, 1};
  clip_line({-3, 2, 1}, {5, 2, 1}, picture.corners, 0, part);
  EXPECT_FALSE(part.begin < part.end);
}

/// In a perspective, parameters count lengths in space: half-way in the picture is not half-way.
TEST(SightMask, ShowsPartsOfLinesInSpace) {
  const SightMask picture = mask_of(kPicture);
  Interval part{0, 1};
  // x / w runs from 0 to 2, through 1 where t = 2 / 3: there, w is 1 + 2 t and x is 3.5 t.
  clip_line({0, 0, 1}, {3.5, 0, 3}, picture.corners, 0, part);
  EXPECT_DOUBLE_EQ(part.begin, 0);
  EXPECT_NEAR(part.end, 1 / 1.5, 1e-15);
}

TEST(SightMask, ShowsWhatIsOnItsBorder) {
  const SightMask picture = mask_of(kPicture);
  Interval part{0, 1};
  clip_line({-1, 1 + 1e-12, 1}, {1, 1 + 1e-12, 1}, picture.corners, 1e-11, part);
  EXPECT_EQ(part.begin, 0);
  EXPECT_EQ(part.end, 1);
}

TEST(SightMask, KeepsTheHalfInFrontOfAPlaneThroughTheEye) {
  SightMask mask = mask_of(kPicture);
  const double slope = std::sqrt(0.5);
  ASSERT_TRUE(MaskClipper().clip(mask, {slope, slope, 0}, kThin));
  EXPECT_DOUBLE_EQ(area_of(mask.corners), 2);
  EXPECT_FALSE(MaskClipper().clip(mask, {-slope, -slope, 0}, kThin));
}

}  // namespace
}  // namespace spoctree
