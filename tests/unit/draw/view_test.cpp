#include "client/draw/view.hpp"

#include <gtest/gtest.h>

#include "client/draw/solid_points.hpp"
#include "common/base/errors.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree::test {
namespace {

using Stereo = ViewOptions::Stereo;

/// The universe cube [-1, 1]^3 as material, 10 model units for each of its own, around (100, 0, 0).
Octree cube() {
  Octree tree = tree_of(Voxels{1, [](int, int, int) { return true; }});
  tree.universe.center = {100, 0, 0};
  tree.universe.scale_exponent = 3;
  return tree;
}

View view_of(const ViewOptions& options) {
  const auto views = make_views(options, cube());
  EXPECT_EQ(views.size(), 1U);
  return views.at(0);
}

void expect_near(Vec2 point, Vec2 expected, double tolerance = 1e-9) {
  EXPECT_NEAR(point.x, expected.x, tolerance);
  EXPECT_NEAR(point.y, expected.y, tolerance);
}

TEST(Views, NamedOnesAreADraughtsmans) {
  // Where +X, +Y and +Z point to in the picture.
  struct Case {
    const char* name;
    Vec2 x, y, z;
  };
  for (const Case& c :
       {Case{"front", {1, 0}, {0, 0}, {0, 1}}, Case{"back", {-1, 0}, {0, 0}, {0, 1}},
        Case{"left", {0, 0}, {-1, 0}, {0, 1}}, Case{"right", {0, 0}, {1, 0}, {0, 1}},
        Case{"top", {1, 0}, {0, 1}, {0, 0}}, Case{"bottom", {1, 0}, {0, -1}, {0, 0}}}) {
    ViewOptions options;
    options.named = {c.name};
    const Camera camera = view_of(options).camera;
    EXPECT_EQ(camera.project({1, 0, 0}), c.x) << c.name;
    EXPECT_EQ(camera.project({0, 1, 0}), c.y) << c.name;
    EXPECT_EQ(camera.project({0, 0, 1}), c.z) << c.name;
  }
}

TEST(Views, IsometricShortensAllAxesAlike) {
  ViewOptions options;
  options.named = {"iso"};
  const Camera camera = view_of(options).camera;
  const double length = std::sqrt(2.0 / 3);
  EXPECT_NEAR(glm::length(camera.project({1, 0, 0})), length, 1e-12);
  EXPECT_NEAR(glm::length(camera.project({0, 1, 0})), length, 1e-12);
  EXPECT_NEAR(glm::length(camera.project({0, 0, 1})), length, 1e-12);
}

TEST(Views, SeveralMakeASheetWithNames) {
  ViewOptions options;
  options.named = {"top", "front"};
  const auto views = make_views(options, cube());
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].name, "top");
  EXPECT_EQ(views[1].name, "front");
  EXPECT_EQ(views[1].frame.upper, Vec2(1, 1));
}

TEST(Views, AnEyeLooksAtTheMiddleOfTheModel) {
  ViewOptions options;
  options.eye = Vec3{100, -40, 0};  // 5 universe units in front
  const View view = view_of(options);
  ASSERT_TRUE(view.camera.is_perspective());
  expect_near(view.camera.project({0, 0, 0}), {0, 0});
  EXPECT_NEAR(view.camera.focal_length(), 5, 1e-12);
  // The nearest face is 4 away: its corners are seen at 5/4.
  expect_near(view.frame.upper, {1.25, 1.25});
  expect_near(view.frame.lower, {-1.25, -1.25});
}

TEST(Views, AFieldOfViewIsASquare) {
  ViewOptions options;
  options.eye = Vec3{100, -40, 0};
  options.target = Vec3{100, 0, 8};
  options.fov_deg = 90;
  const View view = view_of(options);
  const double half = std::hypot(5, 1);
  expect_near(view.frame.upper, {half, half});
  expect_near(view.frame.lower, {-half, -half});
}

TEST(Views, AnEyeInsideSeesARightAngle) {
  ViewOptions options;
  options.eye = Vec3{100, 0, 0};
  options.target = Vec3{104, 0, 0};
  const View view = view_of(options);
  expect_near(view.frame.upper, {0.5, 0.5});
}

TEST(Views, BothEyesOfAPairShowTheTargetInOnePlaceAndLookTheSameWay) {
  for (const bool is_perspective : {false, true}) {
    ViewOptions options;
    options.stereo = Stereo::Beside;
    options.eye_separation = 0.1;
    if (is_perspective) options.eye = Vec3{100, -40, 0};
    const auto views = make_views(options, cube());
    ASSERT_EQ(views.size(), 2U);
    const Vec2 left = views[0].camera.project({0, 0, 0}) - views[0].frame.lower;
    const Vec2 right = views[1].camera.project({0, 0, 0}) - views[1].frame.lower;
    expect_near(left, right);
    if (!is_perspective) continue;
    EXPECT_EQ(views[0].camera.toward_viewer(), views[1].camera.toward_viewer());
    EXPECT_NEAR(glm::distance(views[0].camera.eye(), views[1].camera.eye()), 0.5, 1e-12);
    EXPECT_LT(views[0].camera.eye().x, views[1].camera.eye().x);
  }
}

// What is nearer than the target is farther to the right for the left eye.
TEST(Views, NearPointsAreShiftedAgainstTheEyes) {
  for (const bool is_perspective : {false, true}) {
    ViewOptions options;
    options.stereo = Stereo::Anaglyph;
    if (is_perspective) {
      options.eye = Vec3{100, -40, 0};
    } else {
      options.from = Vec3{0, -1, 0};
    }
    const auto views = make_views(options, cube());
    ASSERT_EQ(views.size(), 2U);
    const auto x_of = [&](int eye, Vec3 point) {
      const View& view = views[static_cast<std::size_t>(eye)];
      return view.camera.project(point).x - view.frame.lower.x;
    };
    EXPECT_GT(x_of(0, {0, -1, 0}), x_of(1, {0, -1, 0}));
    EXPECT_LT(x_of(0, {0, 1, 0}), x_of(1, {0, 1, 0}));
    EXPECT_TRUE(views[1].is_over_last);
    EXPECT_EQ(views[0].ink, Ink::LeftEye);
  }
}

TEST(Views, RefuseWhatContradictsItself) {
  const auto refuse = [](auto change) {
    ViewOptions options;
    change(options);
    EXPECT_THROW(make_views(options, cube()), UsageError);
  };
  const Vec3 far{100, -40, 0};
  const Vec3 infinite{std::numeric_limits<double>::infinity(), 0, 0};
  refuse([](ViewOptions& o) { o.named = {"side"}; });
  refuse([&](ViewOptions& o) {
    o.named = {"front"};
    o.eye = far;
  });
  refuse([&](ViewOptions& o) {
    o.from = far;
    o.eye = far;
  });
  refuse([&](ViewOptions& o) {
    o.from = far;
    o.target = far;
  });
  refuse([](ViewOptions& o) { o.fov_deg = 50; });
  refuse([&](ViewOptions& o) {
    o.eye = far;
    o.fov_deg = 180;
  });
  refuse([&](ViewOptions& o) {
    o.eye = far;
    o.fov_deg = std::nan("");
  });
  refuse([&](ViewOptions& o) {
    o.eye = far;
    o.target = far;
  });
  refuse([&](ViewOptions& o) { o.eye = infinite; });
  refuse([](ViewOptions& o) { o.eye = Vec3{1e300, 0, 0}; });
  refuse([](ViewOptions& o) { o.from = Vec3{0.0}; });
  refuse([](ViewOptions& o) { o.up = Vec3{0.0}; });
  refuse([](ViewOptions& o) {
    o.named = {"top", "iso"};
    o.stereo = Stereo::Beside;
  });
  refuse([](ViewOptions& o) {
    o.stereo = Stereo::Beside;
    o.eye_separation = 0;
  });
}

TEST(SolidPoints, AreTheUniversesWhereThereIsNoSolid) {
  const Octree nothing = tree_of(Voxels{1, [](int, int, int) { return false; }});
  const auto points = coarsest_points(nothing);
  EXPECT_EQ(points.size(), 8U);
  EXPECT_EQ(middle_of(points), Vec3(0.0));
  EXPECT_EQ(middle_of({{0, 0, 0}, {2, 4, -6}, {1, 1, 1}}), Vec3(1, 2, -2.5));
}

}  // namespace
}  // namespace spoctree::test
