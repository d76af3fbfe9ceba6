// What is stated about every level, against the tree's pieces and dense samples of them.
#include "server/build/certify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/tree/pieces.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/mesh_judge.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/support/solid_mesh.hpp"
#include "tests/unit/build/cells.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

struct Pieces : PieceVisitor {
  void piece(const NodeAddress&, NodeKind kind, std::uint32_t, const Polyhedron& piece) override {
    total += volume(piece);
    if (kind != NodeKind::Grey) return;
    grey += volume(piece);
    std::vector<Vec3> corners;
    for (const PolyhedronVertex& vertex : piece.vertices) corners.push_back(vertex.position);
    grey_pieces.push_back(std::move(corners));
  }
  double total = 0;
  double grey = 0;
  std::vector<std::vector<Vec3>> grey_pieces;  ///< their corners
};

/// A point of the convex hull of some points: on the way between two, three, four of them, or all.
Vec3 random_mixture(const std::vector<Vec3>& corners, Random& random) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  const std::uint32_t parts = random.chance(0.1) ? count : 2 + random.below(3);
  Vec3 sum{0.0};
  double total = 0;
  for (std::uint32_t i = 0; i < parts; ++i) {
    const double weight = random.unit() + 1e-9;
    sum += weight * corners[parts == count ? i : random.below(count)];
    total += weight;
  }
  return sum / total;
}

/// The largest distance from the solid that is found by trying points of T_k's uncertain pieces,
/// and climbing from the best ones.
double sampled_distance(const std::vector<std::vector<Vec3>>& pieces, const MeshJudge& judge,
                        Random& random) {
  struct Place {
    double distance = 0;
    Vec3 point{0.0};
    const std::vector<Vec3>* piece = nullptr;
  };
  std::vector<Place> places;
  const auto look_at = [&](const std::vector<Vec3>& piece, Vec3 point) {
    return Place{judge.is_inside(point) ? 0.0 : judge.distance(point), point, &piece};
  };
  for (const auto& piece : pieces) {
    for (const Vec3 corner : piece) places.push_back(look_at(piece, corner));
    const std::size_t samples = 30 + 3000 / pieces.size();
    for (std::size_t i = 0; i < samples; ++i) {
      places.push_back(look_at(piece, random_mixture(piece, random)));
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance > b.distance; });
  double most = 0;
  for (std::size_t start = 0; start < std::min<std::size_t>(places.size(), 400); start += 20) {
    Place place = places[start];
    for (int i = 0; i < 300; ++i) {
      const Vec3 target = random_mixture(*place.piece, random);
      const Place next =
          look_at(*place.piece, glm::mix(place.point, target, std::pow(random.unit(), 4)));
      if (next.distance > place.distance) place = next;
    }
    most = std::max(most, place.distance);
  }
  return most;
}

double area_of(const Solid& solid, const SolidTriangle& t) {
  const Vec3 a = solid.vertices[t.vertex[0]];
  return 0.5 *
         glm::length(glm::cross(solid.vertices[t.vertex[1]] - a, solid.vertices[t.vertex[2]] - a));
}

/// True if the cell of level `level` around a point is below a leaf, found by coordinates alone.
bool is_in_leaf(const Octree& tree, Vec3 point, std::uint32_t level) {
  Vec3 lower{-tree.universe.half_side};
  double side = 2 * tree.universe.half_side;
  std::uint32_t node = 0;
  for (std::uint32_t k = 0; tree.levels[k].kinds[node] == NodeKind::Grey; ++k) {
    if (k == level) return false;
    side /= 2;
    std::uint32_t octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (point[axis] < lower[axis] + side) continue;
      octant |= 1u << axis;
      lower[axis] += side;
    }
    node = tree.levels[k].first_child[node] + octant;
  }
  return true;
}

/// The areas stated, against random points of the boundary: each is looked for a hair towards the
/// material, so that boundary in walls is found in the cell of its material.
void judge_areas(const Octree& tree, const Solid& solid, Random& random) {
  double area = 0;
  for (const SolidTriangle& t : solid.triangles) area += area_of(solid, t);
  const double unit = tree.universe.scale() * tree.universe.scale();
  constexpr int kSamples = 4000;
  std::vector<int> in_leaves(tree.levels.size(), 0);
  for (int i = 0; i < kSamples; ++i) {
    double left = area * (i + random.unit()) / kSamples;
    std::size_t chosen = 0;
    while (chosen + 1 < solid.triangles.size() && left > area_of(solid, solid.triangles[chosen])) {
      left -= area_of(solid, solid.triangles[chosen++]);
    }
    const SolidTriangle& t = solid.triangles[chosen];
    const Vec3 a = solid.vertices[t.vertex[0]];
    const Vec3 u = solid.vertices[t.vertex[1]] - a;
    const Vec3 v = solid.vertices[t.vertex[2]] - a;
    double r = random.unit(), s = random.unit();
    if (r + s > 1) r = 1 - r, s = 1 - s;
    const Vec3 point = a + r * u + s * v - 1e-9 * glm::normalize(glm::cross(u, v));
    for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
      in_leaves[k] += is_in_leaf(tree, point, k);
    }
  }
  for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
    const LevelStatement& statement = tree.levels[k].statement;
    EXPECT_NEAR(statement.outer_area / unit / area, 1, 1e-11) << "level " << k;
    const double share = static_cast<double>(in_leaves[k]) / kSamples;
    EXPECT_NEAR(statement.inner_area / unit / area, share, 5 * 0.5 / std::sqrt(kSamples))
        << "level " << k;
  }
  EXPECT_EQ(tree.levels.back().statement.inner_area, tree.levels.back().statement.outer_area);
}

void judge_statements(const Solid& solid, const SpRules& rules = {}) {
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = rules;
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  const Octree& tree = built.tree;
  const MeshJudge judge(universe_mesh_of(solid));
  const double unit = solid.universe.scale();
  Random random(1);
  double previous = 1e300;
  for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
    SCOPED_TRACE(testing::Message() << "level " << k);
    const LevelStatement& statement = tree.levels[k].statement;
    Pieces pieces;
    WalkOptions walk;
    walk.level = k;
    walk_pieces(tree, walk, pieces);
    const double cubed = unit * unit * unit;
    EXPECT_NEAR(statement.outer_volume / cubed, pieces.total, 1e-12);
    EXPECT_NEAR(statement.inner_volume / cubed, pieces.total - pieces.grey, 1e-12);

    const double bound = statement.error_bound / unit;
    const double sampled = sampled_distance(pieces.grey_pieces, judge, random);
    EXPECT_GE(bound, sampled) << "a point of T_k is farther from the solid";
    EXPECT_LE(bound, 1.2 * sampled + 1e-9) << "loose";
    EXPECT_LE(bound, previous * 1.11) << "grows";
    previous = bound;
  }
  judge_areas(tree, solid, random);
  EXPECT_EQ(tree.levels.back().statement.error_bound, 0);
  EXPECT_EQ(tree.levels.back().statement.inner_volume, tree.levels.back().statement.outer_volume);
  EXPECT_NEAR(tree.levels.back().statement.inner_volume / solid.volume, 1, 1e-11);
}

TEST(Certify, HoldsForHeightFields) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    judge_statements(uneven_solid(5, random));
    judge_statements(
        height_field_solid(random_height_field(4, Vec3(-1), 0.5, -0.75, 0.25, 8, random)));
  }
}

TEST(Certify, HoldsForVoxels) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    judge_statements(voxel_solid(random_voxels(2, random)));
  }
}

TEST(Certify, HoldsForModels) {
  for (const char* name :
       {"mechanical-piece", "l-bracket", "double-torus", "nested-boxes", "two-parts", "saddle"}) {
    SCOPED_TRACE(name);
    judge_statements(model_solid(name));
  }
}

TEST(Certify, HoldsWhereLeavesHoldManyPlanes) {
  Random random(3);
  judge_statements(uneven_solid(6, random), {8, kMaxDepth});
}

// A sphere and one beside it: leaves with more planes than are divided.
TEST(Certify, HoldsForLargeConvexParts) {
  model::PolygonMesh mesh = model::make_model("sphere", 40);
  const auto count = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.points.push_back(0.8 * mesh.points[i] + glm::dvec3{105, 20, 9});
  }
  const std::size_t faces = mesh.faces.size();
  for (std::size_t f = 0; f < faces; ++f) {
    auto face = mesh.faces[f];
    for (auto& corner : face) corner += count;
    mesh.faces.push_back(face);
  }
  const PlainMesh plain = parse_off_text(model::to_off(mesh));
  const Solid solid = import_solid(to_soup(plain), "two spheres", {});
  const SolidQueries queries(solid);
  BuiltOctree built = build_octree(solid, queries, {});
  certify(built, solid, queries);
  Pieces pieces;
  WalkOptions walk;
  walk.level = 0;
  walk_pieces(built.tree, walk, pieces);
  Random random(1);
  const double sampled =
      sampled_distance(pieces.grey_pieces, MeshJudge(universe_mesh_of(solid)), random);
  const double bound = built.tree.levels[0].statement.error_bound / solid.universe.scale();
  EXPECT_GE(bound, sampled);
  // Samples of one piece with thousands of corners are not dense.
  EXPECT_LE(bound, 1.5 * sampled);
  EXPECT_EQ(built.tree.levels.back().statement.error_bound, 0);
}

/// A sphere of triangles in single precision, in pairs that are folded a little, with all planes.
Solid noisy_sphere(std::uint32_t rows, std::uint32_t columns) {
  PolygonSoup soup;
  const auto add_face = [&](std::initializer_list<std::uint32_t> corners) {
    soup.corners.insert(soup.corners.end(), corners);
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  for (std::uint32_t row = 1; row < rows; ++row) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double latitude = std::numbers::pi * row / rows;
      const double longitude = 2 * std::numbers::pi * i / columns;
      soup.points.emplace_back(static_cast<float>(std::sin(latitude) * std::cos(longitude)),
                               static_cast<float>(std::sin(latitude) * std::sin(longitude)),
                               static_cast<float>(-std::cos(latitude)));
    }
  }
  const auto south = static_cast<std::uint32_t>(soup.points.size());
  soup.points.emplace_back(0, 0, -1);
  soup.points.emplace_back(0, 0, 1);
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::uint32_t next = (i + 1) % columns;
    const std::uint32_t last = (rows - 2) * columns;
    add_face({next, i, south});
    add_face({last + i, last + next, south + 1});
    for (std::uint32_t at = 0; at < last; at += columns) {
      add_face({at + i, at + next, at + columns + next});
      add_face({at + i, at + columns + next, at + columns + i});
    }
  }
  ImportOptions options;
  options.flat_tolerance = 0;
  return import_solid(soup, "noisy sphere", options);
}

// It is the noise of all faces alike that makes the error of the levels.
TEST(Certify, HoldsWhereAllFacesAreNoisy) { judge_statements(noisy_sphere(8, 16)); }

// What lies over a pole is wide and thin, and every triangle below it is narrow.
TEST(Certify, HoldsOverPolesOfNarrowTriangles) { judge_statements(noisy_sphere(6, 250)); }

// A box of 2 x 2 x 1.5 with a square hole through it: T_0 fills the hole; the point farthest from
// the material is on the hole's axis, half a hole's width from its walls.
TEST(Certify, KnowsTheErrorOfAHoleByThinking) {
  // A frame of voxels: the cells around the middle four of each layer.
  const Solid solid = voxel_solid({2, [](int x, int y, int z) {
                                     const bool in_hole = x % 3 != 0 && y % 3 != 0;
                                     return !in_hole && z < 3;
                                   }});
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = kPaperRules;  // or the root is a leaf
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  const LevelStatement& level0 = built.tree.levels[0].statement;
  EXPECT_EQ(level0.inner_volume, 0);
  EXPECT_NEAR(level0.outer_volume, 2 * 2 * 1.5, 1e-14);
  EXPECT_GE(level0.error_bound, 0.5);
  EXPECT_LE(level0.error_bound, 0.5 * kErrorBoundRatio + 1e-9);
}

}  // namespace
}  // namespace spoctree
