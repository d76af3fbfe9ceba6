#include "server/silhouettes/views.hpp"

#include <gtest/gtest.h>

#include <set>

#include "common/base/errors.hpp"

namespace spoctree {
namespace {

glm::dvec3 middle_of(int octant) { return glm::dvec3(towards_octant(octant)) * 0.5; }

std::string quarter(const View& view, int octant) {
  const glm::dvec3 p = middle_of(octant);
  const double across = view.across(p);
  const double down = view.down(p);
  const std::string row = down < 0.5 ? "upper " : "lower ";
  if (across == 0.5) return row + "middle";
  return row + (across < 0.5 ? "left" : "right");
}

TEST(Views, AreThreeFacesSixEdgesAndFourCorners) {
  std::array<int, 3> count{};
  std::set<std::string_view> names;
  for (const View& view : all_views()) {
    ++count[static_cast<std::size_t>(view.kind)];
    names.insert(view.name);
  }
  EXPECT_EQ(count, (std::array{3, 6, 4}));
  EXPECT_EQ(names.size(), 13u);
}

TEST(Views, HaveNoTwoDirectionsThatAreOpposite) {
  for (const View& a : all_views()) {
    for (const View& b : all_views()) {
      if (&a == &b) continue;
      EXPECT_NE(a.towards_viewer, b.towards_viewer);
      EXPECT_NE(a.towards_viewer, -b.towards_viewer);
    }
  }
}

TEST(Views, HavePictureAxesThatAreRightHandedWithTheLineOfSight) {
  for (const View& view : all_views()) {
    EXPECT_EQ(dot(view.right, view.up), 0) << view.name;
    EXPECT_EQ(dot(view.right, view.towards_viewer), 0) << view.name;
    EXPECT_EQ(dot(view.up, view.towards_viewer), 0) << view.name;
    const glm::dvec3 r(view.right);
    const glm::dvec3 u(view.up);
    const glm::dvec3 cross(r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z, r.x * u.y - r.y * u.x);
    EXPECT_GT(cross.x * view.towards_viewer.x + cross.y * view.towards_viewer.y +
                  cross.z * view.towards_viewer.z,
              0)
        << view.name;
  }
}

TEST(Views, ShowTheWholeCubeAndNothingBeyond) {
  for (const View& view : all_views()) {
    double least = 1;
    double most = 0;
    for (int octant = 0; octant < 8; ++octant) {
      const glm::dvec3 corner(towards_octant(octant));
      for (const double place : {view.across(corner), view.down(corner)}) {
        EXPECT_GE(place, 0);
        EXPECT_LE(place, 1);
        least = std::min(least, place);
        most = std::max(most, place);
      }
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(most, 1);
  }
}

TEST(Views, HaveTheQuadrantsOfThePapersFigures3And4) {
  EXPECT_EQ(quarter(*find_view("face-x"), 5), "upper left");
  EXPECT_EQ(quarter(*find_view("face-x"), 4), "upper left");
  EXPECT_EQ(quarter(*find_view("face-x"), 7), "upper right");
  EXPECT_EQ(quarter(*find_view("face-x"), 6), "upper right");
  EXPECT_EQ(quarter(*find_view("face-y"), 7), "upper left");
  EXPECT_EQ(quarter(*find_view("face-y"), 5), "upper left");
  EXPECT_EQ(quarter(*find_view("face-z"), 4), "upper left");
  EXPECT_EQ(quarter(*find_view("face-z"), 0), "upper left");
}

TEST(Views, HaveTheSquaresOfThePapersFigure6) {
  const View& view = *find_view("edge-37");
  EXPECT_EQ(quarter(view, 6), "upper right");
  EXPECT_EQ(quarter(view, 7), "upper middle");
  EXPECT_EQ(quarter(view, 4), "upper middle");
}

TEST(Views, AreNamedByTheOctantsNearestToTheViewer) {
  for (const View& view : all_views()) {
    if (view.kind == ViewKind::Face) continue;
    int nearest = 0;
    for (int octant = 0; octant < 8; ++octant)
      nearest = std::max(nearest, dot(view.towards_viewer, towards_octant(octant)));
    std::string octants;
    for (int octant = 0; octant < 8; ++octant) {
      if (dot(view.towards_viewer, towards_octant(octant)) == nearest)
        octants += std::to_string(octant);
    }
    EXPECT_EQ(view.name.substr(view.name.find('-') + 1), octants);
  }
}

TEST(ParseViews, TakesGroupsAndNamesInTheOrderGiven) {
  EXPECT_EQ(parse_views("face"), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(parse_views("all").size(), 13u);
  EXPECT_EQ(parse_views("corner,face-y"), (std::vector<std::size_t>{9, 10, 11, 12, 1}));
}

TEST(ParseViews, RefusesUnknownViewsAndRepetitions) {
  for (const char* list : {"", "face-w", "face,", ",face", "face,face-x", "edge-37,edge-37"})
    EXPECT_THROW(parse_views(list), UsageError) << list;
}

TEST(Views, HaveSquarePixelsInThePicturesOfTheirShapes) {
  const auto size = [](const char* name) {
    const PictureSize s = size_with_square_pixels(*find_view(name), 1000);
    return std::pair(s.width, s.height);
  };
  EXPECT_EQ(size("face-z"), std::pair(1000, 1000));
  EXPECT_EQ(size("edge-46"), std::pair(1414, 1000));
  EXPECT_EQ(size("corner-5"), std::pair(1414, 1633));
}

}  // namespace
}  // namespace spoctree
