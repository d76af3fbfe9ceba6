// The index against classify_point, which is judged by the definition, and rays against the
// definition in rational numbers.
#include "common/tree/query_index.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"
#include "common/tree/validate.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/exact_ray.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Octree leaf_tree(NodeKind kind, std::vector<Plane> planes,
                 std::span<const std::uint32_t> expression = {}) {
  Octree tree;
  tree.planes = std::move(planes);
  std::vector<std::uint32_t> references;
  for (std::uint32_t i = 0; i < tree.planes.size(); ++i) references.push_back(i);
  tree.levels.emplace_back().append(kind, references, expression);
  return tree;
}

Plane axis_plane(int axis, double sign, double offset) {
  Plane plane;
  plane.normal[axis] = sign;
  plane.offset = offset;
  return plane;
}

/// Points where an index might go wrong: anywhere, at the meeting points of planes, on planes, on
/// walls, corners and edges of cells, and just beside all of those.
std::vector<Vec3> awkward_points(const Octree& tree, Random& random, int count) {
  const double half = tree.universe.half_side;
  const auto any_plane = [&]() -> const Plane& {
    return tree.planes[random.below(static_cast<std::uint32_t>(tree.planes.size()))];
  };
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {
    Vec3 point = random_vector(random, 1.02 * half);
    switch (k % 6) {
      case 0:
        break;
      case 1:
        if (tree.planes.empty()) break;
        for (int attempt = 0; attempt < 9; ++attempt) {
          const Plane& p = any_plane();
          const Plane& q = any_plane();
          const Plane& r = any_plane();
          if (orientation_of_normals(p, q, r) == 0) continue;
          point = intersection_point(p, q, r).position;
          if (glm::length(point) < 2) break;
        }
        break;
      case 2: {
        if (tree.planes.empty()) break;
        const Plane& p = any_plane();
        point -= p.normal * (glm::dot(p.normal, point) - p.offset);
        break;
      }
      default:  // on one, two or three walls
        for (int axis = 0; axis < k % 6 - 2; ++axis) {
          const std::uint32_t depth = random.below(5);
          const std::uint32_t step = (1u << 30) >> depth;
          point[axis] = wall_coordinate(half, step * random.below((1u << depth) + 1));
        }
    }
    points.push_back(point);
    if (k % 3 == 0) {
      const int axis = random_integer(random, 0, 2);
      points.push_back(point);
      points.back()[axis] = std::nextafter(point[axis], random.chance(0.5) ? 3 : -3);
    }
  }
  return points;
}

void expect_same_answers(const Octree& tree, Random& random, int count) {
  for (std::uint32_t level = 0; level <= tree.levels.size(); ++level) {
    const QueryIndex index(tree, level);
    for (const Vec3 point : awkward_points(tree, random, count)) {
      ASSERT_EQ(index.classify(point), classify_point(tree, point, level))
          << "level " << level << " point " << point.x << ' ' << point.y << ' ' << point.z;
    }
  }
}

TEST(QueryIndex, ClassifiesAsTheDefinitionDoesInRandomTrees) {
  Random random(1);
  RandomTreeOptions deep;
  deep.levels = 7;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_answers(random_tree(seed), random, 100);
    expect_same_answers(random_tree(seed, deep), random, 50);
  }
}

TEST(QueryIndex, ClassifiesAsTheDefinitionDoesInTreesFullOfCoincidences) {
  Random random(2);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_answers(degenerate_tree(seed, 4), random, 60);
  }
}

TEST(QueryIndex, ClassifiesPointsThatAreNoPlacesAsOutside) {
  const Octree tree = leaf_tree(NodeKind::Black, {});
  const QueryIndex index(tree);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {kNaN, kInfinity, -kInfinity, 1.0 + 0x1p-52, -2.0, 1e300}) {
    EXPECT_EQ(index.classify({x, 0, 0}), PointClass::Out);
    EXPECT_EQ(index.classify({0, 0, x}), PointClass::Out);
  }
  EXPECT_EQ(index.classify({0, 0, 0}), PointClass::In);
  EXPECT_EQ(index.classify({1, 1, -1}), PointClass::On);
}

// A hostile tree: planes that cross every cell are not copied into every leaf.
TEST(QueryIndex, StaysAsSmallAsTheTreeWhereThousandsOfPlanesCrossEverything) {
  Random random(3);
  Octree tree;
  constexpr std::uint32_t kPlanes = 5000;
  std::vector<std::uint32_t> references;
  for (std::uint32_t i = 0; i < kPlanes; ++i) {
    tree.planes.push_back(random_plane_exactly_through(random, {0, 0, 0}, 2));
    references.push_back(i);
  }
  tree.levels.resize(5);
  tree.levels[0].append(NodeKind::Grey, references);
  for (std::size_t depth = 1; depth < 5; ++depth) {
    for (std::uint64_t node = 8 * tree.levels[depth - 1].grey_count; node > 0; --node) {
      tree.levels[depth].append(depth < 4 ? NodeKind::Grey : NodeKind::Black, {});
    }
  }
  ASSERT_TRUE(validate(tree).empty()) << validate(tree).front();
  const DecisionGraph graph = make_decision_graph(tree, 9);
  EXPECT_LT(graph.tests.size(), 16 * (kPlanes + 8 + 64 + 512 + 4096));
  expect_same_answers(tree, random, 5);
}

TEST(QueryIndex, BearsExpressionsAndUnionsOfAnyDepth) {
  Random random(4);
  constexpr std::uint32_t kCount = 20000;
  std::vector<Plane> planes;
  std::vector<std::uint32_t> tokens;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    planes.push_back(random_plane(random, Vec3(0), 1));
    tokens.push_back(kFirstPlaneToken + i);
  }
  for (std::uint32_t i = 0; i < kCount; ++i) {
    tokens.push_back(kInToken);
    tokens.push_back(kOutToken);
  }
  tokens.resize(2 * kCount);
  tokens.push_back(kOutToken);
  const Octree deep = leaf_tree(NodeKind::Vertex, planes, tokens);
  const Octree wide = leaf_tree(NodeKind::Concave, planes);
  for (const Octree* tree : {&deep, &wide}) {
    const QueryIndex index(*tree);
    for (int k = 0; k < 20; ++k) {
      const Vec3 point = random_vector(random, 1);
      EXPECT_EQ(index.classify(point), classify_point(*tree, point));
      index.first_hit({point, random_direction(random)});
    }
  }
}

// ----------------------------------------------------------------------------------------- rays

double to_double(const Rational& value) { return value.convert_to<double>(); }

/// The answer that the definition gives, with its times as doubles.
RayAnswer expected_answer(const std::vector<ExactSegment>& segments) {
  using Content = ExactSegment::Content;
  if (segments.size() == 1 && segments[0].content != Content::Unknown) return {};
  const bool starts_known = segments[0].content != Content::Unknown;
  if (starts_known && segments[1].content != Content::Unknown) {
    const double time = to_double(segments[1].from);
    return {RayAnswer::Kind::Hit, time, time};
  }
  RayAnswer answer{RayAnswer::Kind::Between, starts_known ? to_double(segments[1].from) : 0,
                   kInfinity};
  bool has_in = false;
  bool has_out = false;
  for (const ExactSegment& segment : segments) {
    has_in |= segment.content == Content::In;
    has_out |= segment.content == Content::Out;
    if (!has_in || !has_out) continue;
    answer.last = to_double(segment.from);
    break;
  }
  return answer;
}

/// The normal must be that of a plane or wall that is crossed at the hit, and face the right way.
void expect_right_normal(const Octree& tree, const Ray& ray, const RayAnswer& answer, bool enters) {
  const Vec3 point = ray.origin + answer.first * ray.direction;
  EXPECT_EQ(glm::dot(answer.normal, ray.direction) < 0, enters);
  bool found = false;
  for (const Plane& plane : tree.planes) {
    found |= (answer.normal == plane.normal || answer.normal == -plane.normal) &&
             std::abs(glm::dot(plane.normal, point) - plane.offset) < 1e-13;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = (point[axis] / tree.universe.half_side + 1) * 32;
    found |= std::abs(answer.normal[axis]) == 1 && std::abs(cells - std::round(cells)) < 1e-12;
  }
  EXPECT_TRUE(found) << answer.normal.x << ' ' << answer.normal.y << ' ' << answer.normal.z;
}

std::string describe(const std::vector<ExactSegment>& segments) {
  std::string text;
  for (const ExactSegment& segment : segments) {
    text += (segment.content == ExactSegment::Content::Out  ? " out "
             : segment.content == ExactSegment::Content::In ? " in "
                                                            : " unknown ");
    text += std::to_string(to_double(segment.from));
  }
  return text;
}

void expect_right_answer(const Octree& tree, const QueryIndex& index, const Ray& ray,
                         int (&counts)[3]) {
  const auto segments = segments_of_definition(tree, index.level(), to_rational(ray.origin),
                                               to_rational(ray.direction));
  const RayAnswer expected = expected_answer(segments);
  const RayAnswer answer = index.first_hit(ray);
  ++counts[static_cast<int>(expected.kind)];
  ASSERT_EQ(answer.kind, expected.kind)
      << describe(segments) << " answer " << answer.first << ' ' << answer.last;
  // Times of crossings at flat angles may be off by more, but these are rare.
  const double length = glm::length(ray.direction);
  const double slack = 1e-9 / length;
  if (expected.kind == RayAnswer::Kind::Hit) {
    EXPECT_NEAR(answer.first, expected.first, slack);
    EXPECT_EQ(answer.last, answer.first);
    expect_right_normal(tree, ray, answer, segments[0].content == ExactSegment::Content::Out);
  } else {
    // Bounds: never on the wrong side.
    EXPECT_LE(answer.first, expected.first);
    EXPECT_NEAR(answer.first, expected.first, slack);
    EXPECT_GE(answer.last, expected.last);
    if (expected.last < kInfinity) {
      EXPECT_NEAR(answer.last, expected.last, slack);
    }
  }
}

void expect_right_answers(const Octree& tree, Random& random, int count, int (&counts)[3]) {
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    const QueryIndex index(tree, level);
    for (int k = 0; k < count; ++k) {
      Ray ray{random_vector(random, k % 3 == 0 ? 2 : 0.9),
              random_direction(random) *
                  std::ldexp(random.between(1, 2), random_integer(random, -9, 9))};
      if (k % 3 == 1) {  // from a wall's corner or edge
        ray.origin = random_grid_point(random, 2, 1);
        if (k % 2 == 1) ray.origin[k % 3] = random.between(-1, 1);
      }
      if (k % 3 == 2 && !tree.planes.empty()) {  // from a plane, as far as doubles are on it
        const Plane& plane =
            tree.planes[random.below(static_cast<std::uint32_t>(tree.planes.size()))];
        ray.origin -= plane.normal * (glm::dot(plane.normal, ray.origin) - plane.offset);
      }
      SCOPED_TRACE(testing::Message() << "level " << level << " ray " << k);
      ASSERT_NO_FATAL_FAILURE(expect_right_answer(tree, index, ray, counts));
    }
  }
}

TEST(FirstHit, AgreesWithTheDefinitionInRandomTrees) {
  Random random(5);
  int counts[3] = {0, 0, 0};
  RandomTreeOptions small;
  small.levels = 3;
  small.max_nodes = 60;
  small.max_planes_per_node = 3;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE(seed);
    expect_right_answers(random_tree(seed, small), random, 12, counts);
  }
  for (const int count : counts) EXPECT_GT(count, 50);
}

TEST(FirstHit, AgreesWithTheDefinitionInTreesFullOfCoincidences) {
  Random random(6);
  int counts[3] = {0, 0, 0};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_right_answers(degenerate_tree(seed, 3), random, 12, counts);
  }
  for (const int count : counts) EXPECT_GT(count, 50);
}

Octree box_tree(double half) {
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) planes.push_back(axis_plane(axis, sign, half));
  }
  return leaf_tree(NodeKind::Convex, planes);
}

TEST(FirstHit, KnowsABoxFromOutsideAndFromInside) {
  const Octree tree = box_tree(0.5);
  const QueryIndex index(tree);
  const auto expect_hit = [&](Ray ray, double time, Vec3 normal) {
    const RayAnswer answer = index.first_hit(ray);
    EXPECT_EQ(answer.kind, RayAnswer::Kind::Hit);
    EXPECT_EQ(answer.first, time);
    EXPECT_EQ(answer.last, time);
    EXPECT_EQ(answer.normal, normal);
  };
  expect_hit({{-2, 0.25, 0}, {1, 0, 0}}, 1.5, {-1, 0, 0});
  expect_hit({{-2, 0.25, 0}, {4, 0, 0}}, 0.375, {-1, 0, 0});
  expect_hit({{0.25, 0, 0}, {1, 0, 0}}, 0.25, {1, 0, 0});
  expect_hit({{0.25, 0, 0}, {0, 0, -2}}, 0.25, {0, 0, -1});
  expect_hit({{-4, 0.25, 0.125}, {0x1p-500, 0, 0}}, 3.5 * 0x1p500, {-1, 0, 0});
  expect_hit({{-4, 0.25, 0.125}, {0x1p500, 0, 0}}, 3.5 * 0x1p-500, {-1, 0, 0});
  EXPECT_EQ(index.first_hit({{-2, 0.25, 0}, {-1, 0, 0}}).kind, RayAnswer::Kind::Miss);
  EXPECT_EQ(index.first_hit({{-2, 0.75, 0}, {1, 0, 0}}).kind, RayAnswer::Kind::Miss);
  EXPECT_EQ(index.first_hit({{5, 5, 5}, {1, 2, 3}}).kind, RayAnswer::Kind::Miss);
}

TEST(FirstHit, DoesNotCountTheOriginOnTheBoundary) {
  const Octree tree = box_tree(0.5);
  const QueryIndex index(tree);
  EXPECT_EQ(index.first_hit({{-0.5, 0, 0}, {-1, 0, 0}}).kind, RayAnswer::Kind::Miss);
  const RayAnswer through = index.first_hit({{-0.5, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(through.kind, RayAnswer::Kind::Hit);
  EXPECT_EQ(through.first, 1);
  EXPECT_EQ(through.normal, Vec3(1, 0, 0));
}

TEST(FirstHit, TakesWallsBetweenCellsOfMaterialForNothing) {
  Octree tree;
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, {});
  for (int octant = 0; octant < 8; ++octant) {
    tree.levels[1].append(octant == 7 ? NodeKind::White : NodeKind::Black, {});
  }
  const QueryIndex index(tree);
  const RayAnswer through = index.first_hit({{-0.5, -0.5, -0.5}, {1, 0, 0}});
  EXPECT_EQ(through.kind, RayAnswer::Kind::Hit);
  EXPECT_EQ(through.first, 1.5);
  EXPECT_EQ(through.normal, Vec3(1, 0, 0));
  const RayAnswer into_white = index.first_hit({{-0.5, 0.5, 0.5}, {1, 0, 0}});
  EXPECT_EQ(into_white.first, 0.5);
  EXPECT_EQ(into_white.normal, Vec3(1, 0, 0));
  // Along the walls themselves, and through the middle.
  EXPECT_EQ(index.first_hit({{-0.5, 0, 0.5}, {1, 0, 0}}).kind, RayAnswer::Kind::Hit);
  EXPECT_EQ(index.first_hit({{-0.5, -0.5, -0.5}, {1, 1, 1}}).first, 0.5);
  const QueryIndex root(tree, 0);
  const RayAnswer nothing_known = root.first_hit({{-0.5, -0.5, -0.5}, {1, 0, 0}});
  EXPECT_EQ(nothing_known.kind, RayAnswer::Kind::Between);
  EXPECT_EQ(nothing_known.first, 0);
  EXPECT_EQ(nothing_known.last, kInfinity);
}

// Rays at every angle through the corners and edges where cells and pieces meet: what is solid
// there must stay so, and what is behind it must not be seen.
TEST(FirstHit, LeavesNoCracksWhereCellsAndPlanesMeet) {
  Random random(7);
  // A solid ball of directions, divided by walls and by the planes of an expression through the
  // origin: material everywhere within the box.
  Octree tree = box_tree(0.75);
  tree.levels[0] = {};
  std::vector<std::uint32_t> hull{0, 1, 2, 3, 4, 5};
  tree.levels[0].append(NodeKind::Grey, hull);
  tree.levels.emplace_back();
  for (int octant = 0; octant < 8; ++octant) {
    std::vector<std::uint32_t> own;
    std::vector<std::uint32_t> tokens;
    for (std::uint32_t k = 0; k < 4; ++k) {
      own.push_back(static_cast<std::uint32_t>(tree.planes.size()));
      tree.planes.push_back(random_plane_exactly_through(random, {0.25, 0.25, 0.25}, 2));
      tokens.push_back(kFirstPlaneToken + k);
      tokens.push_back(kInToken);
    }
    tokens.push_back(kInToken);
    tree.levels[1].append(NodeKind::Vertex, own, tokens);
  }
  ASSERT_TRUE(validate(tree).empty()) << validate(tree).front();
  const QueryIndex index(tree);
  for (int k = 0; k < 20000; ++k) {
    const Vec3 target = k % 2 == 0 ? Vec3(0) : Vec3(0.25);
    const Vec3 direction = random_direction(random);
    const RayAnswer answer = index.first_hit({target - 3.0 * direction, direction});
    ASSERT_EQ(answer.kind, RayAnswer::Kind::Hit);
    const Vec3 point = target + (answer.first - 3) * direction;
    EXPECT_NEAR(std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}), 0.75, 1e-13);
    const RayAnswer from_within = index.first_hit({target, direction});
    ASSERT_EQ(from_within.kind, RayAnswer::Kind::Hit);
    const Vec3 left = target + from_within.first * direction;
    EXPECT_NEAR(std::max({std::abs(left.x), std::abs(left.y), std::abs(left.z)}), 0.75, 1e-13);
  }
}

// One plane says the same of both cubes, by its outside in one and by its inside in the other.
TEST(FirstHit, TakesARayInAFaceForOneRayBesideItInAllCells) {
  Octree tree;
  tree.planes = {axis_plane(1, 1, 0.25), axis_plane(1, -1, -0.25)};
  tree.levels.resize(2);
  tree.levels[0].append(NodeKind::Grey, {});
  for (int octant = 0; octant < 8; ++octant) {
    // y in (0, 1): below 0.25 where x < 0, above it where x > 0.
    const std::uint32_t own[1] = {octant & 1 ? 1u : 0u};
    if ((octant & 2) != 0) {
      tree.levels[1].append(NodeKind::Convex, own);
    } else {
      tree.levels[1].append(NodeKind::White, {});
    }
  }
  ASSERT_TRUE(validate(tree).empty());
  const QueryIndex index(tree);
  for (const double z : {-0.5, 0.0, 0.5}) {
    const RayAnswer there = index.first_hit({{-2, 0.25, z}, {1, 0, 0}});
    EXPECT_EQ(there.kind, RayAnswer::Kind::Hit);
    const RayAnswer back = index.first_hit({{2, 0.25, z}, {-1, 0, 0}});
    EXPECT_EQ(back.kind, RayAnswer::Kind::Hit);
    // Above, material reaches from 0 to 1; below, from -1 to 0.
    EXPECT_EQ(there.first, 2);
    EXPECT_EQ(back.first, 1);
    // From within: it leaves the one, or enters the other.
    EXPECT_EQ(index.first_hit({{-0.5, 0.25, z}, {1, 0, 0}}).first, 0.5);
  }
}

TEST(FirstHit, AnswersRaysFromAnywhere) {
  const Octree tree = box_tree(0.5);
  const QueryIndex index(tree);
  for (const double far : {1e3, 1e9, 1e200, 1e308}) {
    for (const double step : {5e-324, 1e-300, 1.0, 1e308}) {
      index.first_hit({{-far, 0.25, 0.25}, {step, 0, 0}});
      index.first_hit({{-far, far, -far}, {step, -step, step}});
      EXPECT_EQ(index.first_hit({{-far, 0.75, 0}, {step, 0, 0}}).kind, RayAnswer::Kind::Miss);
    }
  }
  const RayAnswer answer = index.first_hit({{-1e9, 0.25, 0.25}, {1, 0, 0}});
  EXPECT_EQ(answer.kind, RayAnswer::Kind::Hit);
  EXPECT_NEAR(answer.first, 1e9 - 0.5, 1e-6);
}

}  // namespace
}  // namespace spoctree
