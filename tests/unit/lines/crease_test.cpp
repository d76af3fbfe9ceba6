#include "client/lines/crease.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

/// Creases along z through the origin. Table: 0 is +x, 1 is +y; walls are not used.
struct Bench {
  std::vector<Plane> table{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}};
  PlaneSet planes{table, 1.0};
  Creases creases;

  explicit Bench(std::vector<CreaseSide> sides) {
    creases.creases.push_back(
        {{0, 0, -0.5}, {0, 0, 0.5}, 0, static_cast<std::uint32_t>(sides.size())});
    creases.sides = std::move(sides);
  }
  bool open(Vec3 toward_viewer) const {
    return may_be_seen(creases.creases[0], creases, planes, Camera(toward_viewer));
  }
  bool silhouette(Vec3 toward_viewer) const {
    return is_silhouette(creases.creases[0], creases, planes, Camera(toward_viewer));
  }
};

const PlaneRef kX = PlaneRef::of_table(0);
const PlaneRef kY = PlaneRef::of_table(1);

/// Material where x <= 0 and y <= 0.
Bench convex() { return Bench({{kX, true}, {kY, false}}); }
/// Material where x <= 0 or y <= 0.
Bench reflex() { return Bench({{kX, false}, {kY, true}}); }
/// Material where x and y have one sign: two wedges that touch in the crease.
Bench crossing() {
  return Bench({{kX, true}, {kY, false}, {kX.flipped(), true}, {kY.flipped(), false}});
}

TEST(MayBeSeen, HoldsUnlessAllFacesOfAConvexEdgeLookAway) {
  EXPECT_TRUE(convex().open({1, 2, 0.3}));
  EXPECT_TRUE(convex().open({-1, 2, 0.3}));
  EXPECT_TRUE(convex().open({1, -2, -0.3}));
  EXPECT_FALSE(convex().open({-1, -2, 0.3}));
}

TEST(MayBeSeen, FailsUnlessAllFacesOfAReflexEdgeFaceTheViewer) {
  EXPECT_TRUE(reflex().open({1, 2, 0.3}));
  EXPECT_FALSE(reflex().open({-1, 2, 0.3}));
  EXPECT_FALSE(reflex().open({1, -2, 0.3}));
  EXPECT_FALSE(reflex().open({-1, -2, 0.3}));
}

TEST(MayBeSeen, HoldsWhereAFaceIsSeenEdgeOnAndThePictureBesideItIsOpen) {
  EXPECT_TRUE(convex().open({0, -1, 0}));
  EXPECT_TRUE(convex().open({-1, 0, 0}));
  EXPECT_TRUE(reflex().open({0, 1, 0}));
  EXPECT_TRUE(reflex().open({1, 0, 0}));
  EXPECT_FALSE(reflex().open({0, -1, 0}));
}

TEST(MayBeSeen, AsksWhereTheEyeIsInAPerspective) {
  const Bench bench = convex();
  const auto open = [&](Vec3 eye) {
    return may_be_seen(bench.creases.creases[0], bench.creases, bench.planes,
                       Camera::perspective(eye, {0, 0, 0}));
  };
  EXPECT_TRUE(open({1, 2, 0.3}));
  EXPECT_TRUE(open({-1, 2, 0.3}));
  EXPECT_FALSE(open({-1, -2, 0.3}));
}

TEST(MayBeSeen, AsksTheSectorWhereFourFacesMeet) {
  EXPECT_FALSE(crossing().open({1, 2, 0.3}));
  EXPECT_FALSE(crossing().open({-1, -2, 0.3}));
  EXPECT_TRUE(crossing().open({-1, 2, 0.3}));
  EXPECT_TRUE(crossing().open({1, -2, 0.3}));
  // From -y: material is at x < 0, on the left.
  EXPECT_TRUE(crossing().open({0, -1, 0}));
}

TEST(Silhouettes, HaveFacesOfBothKinds) {
  EXPECT_FALSE(convex().silhouette({1, 2, 0.3}));
  EXPECT_TRUE(convex().silhouette({-1, 2, 0.3}));
  EXPECT_TRUE(convex().silhouette({0, 1, 0}));
  EXPECT_FALSE(reflex().silhouette({1, 2, 0.3}));
}

TEST(FlatCreases, AreThoseOfPlanesThatWereOneBeforeRounding) {
  Bench bench({{kX, true}, {kY, false}});
  const auto flat = [&](Plane other) {
    bench.table[1] = other;
    return is_flat(bench.creases.creases[0], bench.creases, bench.planes);
  };
  EXPECT_TRUE(flat({{1, 1e-14, 0}, 0}));
  EXPECT_FALSE(flat({{1, 1e-9, 0}, 0}));
  EXPECT_FALSE(flat({{-1, 1e-14, 0}, 0}));
}

TEST(CreaseAngle, IsThatOfTheNormals) {
  const Bench bench = convex();
  EXPECT_NEAR(crease_angle_deg(bench.creases.creases[0], bench.creases, bench.planes), 90, 1e-12);
}

}  // namespace
}  // namespace spoctree
