// Every model: closed, flat faces, the volume, genus and number of planes known by construction.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/errors.hpp"
#include "tests/unit/model/expectations.hpp"
#include "tests/unit/model/mesh_measures.hpp"
#include "tools/model/models.hpp"

namespace spoctree::model {
namespace {

class EveryModel : public testing::TestWithParam<Expectation> {
 protected:
  const PolygonMesh mesh_ = make_model(GetParam().name, GetParam().size);
};

TEST_P(EveryModel, HasEveryDirectedEdgeOnceAndItsReverseOnce) {
  EXPECT_EQ(why_not_closed(mesh_), "");
}

TEST_P(EveryModel, HasFlatFaces) { EXPECT_LE(worst_flatness(mesh_), 1e-14 * diagonal(mesh_)); }

TEST_P(EveryModel, HasSimpleFaces) {
  for (const Loop& face : mesh_.faces) EXPECT_TRUE(is_simple(mesh_, face));
}

TEST_P(EveryModel, HasItsKnownVolume) {
  EXPECT_NEAR(volume(mesh_), GetParam().volume, 1e-12 * GetParam().volume);
}

TEST_P(EveryModel, HasItsKnownShellsAndGenus) {
  const auto shells = static_cast<long>(GetParam().shells);
  EXPECT_EQ(count_shells(mesh_), GetParam().shells);
  EXPECT_EQ(euler_characteristic(mesh_), 2 * shells - 2 * GetParam().genus);
}

TEST_P(EveryModel, HasItsKnownNumberOfPlanes) {
  EXPECT_EQ(distinct_planes(mesh_).size(), GetParam().planes);
}

TEST_P(EveryModel, ReadsBackFromItsTextToTheLastBit) {
  std::istringstream text(to_off(mesh_));
  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  text >> magic >> points >> faces >> edges;
  EXPECT_EQ(magic, "OFF");
  ASSERT_EQ(points, mesh_.points.size());
  ASSERT_EQ(faces, mesh_.faces.size());
  EXPECT_EQ(euler_characteristic(mesh_),
            static_cast<long>(points + faces) - static_cast<long>(edges));
  for (const glm::dvec3& point : mesh_.points)
    for (int axis = 0; axis < 3; ++axis) {
      std::string number;
      text >> number;
      EXPECT_EQ(std::stod(number), point[axis]);
      EXPECT_NE(number, "-0");
    }
  for (const Loop& face : mesh_.faces) {
    std::size_t sides = 0;
    text >> sides;
    ASSERT_EQ(sides, face.size());
    for (const std::uint32_t corner : face) {
      std::uint32_t read = 0;
      text >> read;
      EXPECT_EQ(read, corner);
    }
  }
  std::string rest;
  EXPECT_FALSE(text >> rest);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(expectations()),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(ModelList, IsCoveredByTheExpectations) {
  const std::vector<Expectation> expected = expectations();
  for (const ModelInfo& info : models())
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const Expectation& one) {
      return one.name == info.name;
    })) << info.name;
}

TEST(MechanicalPiece, HasThirteenOfItsPlanesOnItsHullAsInThePaper) {
  EXPECT_EQ(count_hull_planes(make_model("mechanical-piece")), 13U);
}

TEST(MechanicalPiece, IsSymmetrical) {
  const PolygonMesh mesh = make_model("mechanical-piece");
  for (const glm::dvec3& point : mesh.points)
    EXPECT_NE(
        std::find(mesh.points.begin(), mesh.points.end(), glm::dvec3(-point.x, point.y, point.z)),
        mesh.points.end());
}

TEST(Saddle, HasAVertexWithConvexAndConcaveEdgesByTurns) {
  const PolygonMesh mesh = make_model("saddle");
  const auto middle = std::find(mesh.points.begin(), mesh.points.end(), glm::dvec3(0, 0, 40));
  ASSERT_NE(middle, mesh.points.end());
  const auto bends = bends_around(mesh, static_cast<std::uint32_t>(middle - mesh.points.begin()));
  ASSERT_EQ(bends.size(), 4U);
  EXPECT_NE(bends[0], Bend::Flat);
  EXPECT_NE(bends[1], Bend::Flat);
  EXPECT_NE(bends[0], bends[1]);
  EXPECT_EQ(bends[0], bends[2]);
  EXPECT_EQ(bends[1], bends[3]);
}

TEST(LBracket, HasOneConcaveEdge) {
  const PolygonMesh mesh = make_model("l-bracket");
  std::size_t ends = 0;
  for (std::uint32_t point = 0; point < mesh.points.size(); ++point) {
    const auto bends = bends_around(mesh, point);
    ends += static_cast<std::size_t>(std::count(bends.begin(), bends.end(), Bend::Concave));
  }
  EXPECT_EQ(ends, 2U);
}

TEST(NestedBoxes, AlternateBetweenFullAndHollow) {
  // Along the x axis, leaving a shell counts one and entering one takes it back.
  const PolygonMesh mesh = make_model("nested-boxes");
  const auto is_inside = [&](double x) {
    int left = 0;
    for (const OrientedPlane& plane : distinct_planes(mesh))
      if (std::abs(plane.normal.x) == 1 && plane.offset * plane.normal.x > x)
        left += plane.normal.x > 0 ? 1 : -1;
    return left == 1;
  };
  EXPECT_FALSE(is_inside(0));
  EXPECT_TRUE(is_inside(10));
  EXPECT_FALSE(is_inside(20));
  EXPECT_TRUE(is_inside(40));
  EXPECT_FALSE(is_inside(60));
}

TEST(RoundSolids, AreClosedAtLargeSizes) {
  EXPECT_EQ(why_not_closed(make_model("sphere", 200)), "");
  EXPECT_EQ(why_not_closed(make_model("cylinder", 2000)), "");
  EXPECT_EQ(why_not_closed(make_model("cone", 2000)), "");
}

TEST(RoundSolids, HitTheAxesExactly) {
  const PolygonMesh sphere = make_model("sphere", 20);
  for (const glm::dvec3& pole :
       {glm::dvec3(50, 0, 0), glm::dvec3(-50, 0, 0), glm::dvec3(0, 50, 0), glm::dvec3(0, -50, 0),
        glm::dvec3(0, 0, 50), glm::dvec3(0, 0, -50)})
    EXPECT_NE(std::find(sphere.points.begin(), sphere.points.end(), pole), sphere.points.end());
}

std::string complaint(std::string_view name, std::optional<int> size) {
  try {
    make_model(name, size);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(MakeModel, NamesAllModelsWhereTheNameIsUnknown) {
  for (const ModelInfo& info : models())
    EXPECT_NE(complaint("teapot", {}).find(info.name), std::string::npos);
}

TEST(MakeModel, NamesTheRangeWhereTheSizeIsOutside) {
  for (const int size : {-1, 0, 2, 2001}) {
    EXPECT_NE(complaint("cylinder", size).find("from 3 to 2000"), std::string::npos);
    EXPECT_NE(complaint("cone", size).find("from 3 to 2000"), std::string::npos);
  }
  EXPECT_NE(complaint("sphere", 1001).find("from 3 to 1000"), std::string::npos);
}

TEST(MakeModel, RefusesASizeWhereThereIsOneOnly) { EXPECT_NE(complaint("cube", 5), "none"); }

}  // namespace
}  // namespace spoctree::model
