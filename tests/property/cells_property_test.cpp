// Empty space as cells: they are convex and disjoint, with the solid they fill the universe cube,
// their openings are all that they share, and the eye is found in them; what is seen through them
// is what is seen from front to back. On models, random and degenerate trees, at all levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "client/cells/cell_scene.hpp"
#include "client/lines/extent.hpp"
#include "common/geometry/predicates.hpp"
#include "common/tree/classify.hpp"
#include "server/build/build_octree.hpp"
#include "tests/support/compare_methods.hpp"
#include "tests/support/degenerate_tree.hpp"
#include "tests/support/eyes_within.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/support/polyhedron_checks.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

Octree tree_of_model(const char* name, std::optional<int> size = {}) {
  const Solid solid = model_solid(name, size);
  return build_octree(solid, SolidQueries(solid), {}).tree;
}

/// A tree, and the level looked at.
void for_trees(const std::function<void(const Octree&, std::uint32_t)>& look) {
  for (const char* name :
       {"cube", "l-bracket", "double-torus", "nested-boxes", "two-parts", "saddle", "house-plan"}) {
    SCOPED_TRACE(name);
    const Octree tree = tree_of_model(name);
    for (std::uint32_t level = 0; level < tree.levels.size(); ++level) look(tree, level);
  }
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("random tree " + std::to_string(seed));
    RandomTreeOptions options;
    options.max_nodes = 200;
    const Octree tree = random_tree(seed, options);
    look(tree, static_cast<std::uint32_t>(tree.levels.size() - 1));
    look(tree, 1);
  }
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("degenerate tree " + std::to_string(seed));
    const Octree tree = degenerate_tree(seed, 2 + seed % 2);
    look(tree, static_cast<std::uint32_t>(tree.levels.size() - 1));
  }
}

EmptySpace space_of(const Octree& tree, std::uint32_t level, bool merges = true) {
  EmptySpaceOptions options;
  options.level = level;
  options.merges_cells = merges;
  return EmptySpace(tree, options);
}

/// The cells whose planes have a point on their inner sides: strictly, or not.
std::vector<std::uint32_t> cells_with(const EmptySpace& space, Vec3 point, bool strictly) {
  std::vector<std::uint32_t> found;
  const PlaneSet planes = space.tree().plane_set();
  for (std::uint32_t cell = 0; cell < space.cells().size(); ++cell) {
    const Polyhedron& polyhedron = space.cells()[cell];
    if (std::all_of(polyhedron.faces.begin(), polyhedron.faces.end(),
                    [&](const Polyhedron::Face& face) {
                      const int side = side_of_any_point(planes[face.plane], point);
                      return side < 0 || (side == 0 && !strictly);
                    })) {
      found.push_back(cell);
    }
  }
  return found;
}

/// Points anywhere, on walls, and at corners of cells (rounded, but within the universe cube).
std::vector<Vec3> sample_points(const EmptySpace& space, std::uint64_t seed) {
  Random random(seed);
  const double half = space.tree().universe.half_side;
  std::vector<Vec3> points;
  for (int k = 0; k < 60; ++k) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = k % 3 == 0 && random.below(2) == 0
                        ? half * (static_cast<double>(random.below(9)) / 4 - 1)
                        : half * random.between(-1, 1);
    }
    points.push_back(point);
  }
  for (std::size_t cell = 0; cell < space.cells().size(); cell += 1 + space.cells().size() / 20) {
    points.push_back(glm::clamp(space.cells()[cell].vertices[0].position, -half, half));
  }
  return points;
}

TEST(EmptySpace, CellsAreConvexPolyhedra) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const EmptySpace space = space_of(tree, level);
    for (std::size_t cell = 0; cell < std::min<std::size_t>(space.cells().size(), 40); ++cell) {
      ASSERT_EQ(structure_error(space.cells()[cell], tree.plane_set()), "");
    }
  });
}

TEST(EmptySpace, FillsTheUniverseCubeTogetherWithTheSolid) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const double side = 2 * tree.universe.half_side;
    const double solid = volume(rebuild_surface(tree, level));
    for (const bool merges : {false, true}) {
      const EmptySpace space = space_of(tree, level, merges);
      double empty = 0;
      for (const Polyhedron& cell : space.cells()) empty += volume(cell);
      EXPECT_NEAR(space.material_volume(), solid, 1e-11);
      EXPECT_NEAR(empty + solid, side * side * side, 1e-11);
    }
  });
}

TEST(EmptySpace, HasEveryEmptyPointInOneCellAndNoOtherPointInAny) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const EmptySpace space = space_of(tree, level);
    for (const Vec3 point : sample_points(space, 7)) {
      const std::vector<std::uint32_t> strictly = cells_with(space, point, true);
      const std::vector<std::uint32_t> around = cells_with(space, point, false);
      ASSERT_LE(strictly.size(), 1u);
      if (strictly.size() == 1) {
        ASSERT_EQ(around.size(), 1u);
      }
      const PointClass place = classify_point(tree, point, level);
      const double farthest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
      if (farthest < tree.universe.half_side && place == PointClass::Out) {
        ASSERT_GE(around.size(), 1u);
      }
      if (place == PointClass::In) {
        ASSERT_TRUE(around.empty());
      }
    }
  });
}

TEST(EmptySpace, FindsTheCellsOfTheEye) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const EmptySpace space = space_of(tree, level);
    for (const Vec3 point : sample_points(space, 11)) {
      ASSERT_EQ(space.find_cells(Viewpoint{point, 1}), cells_with(space, point, false));
    }
    const std::vector<std::uint32_t> outside = {kOuterSpace};
    EXPECT_EQ(space.find_cells(Viewpoint{{0, 0, 5}, 1}), outside);
    EXPECT_EQ(space.find_cells(Viewpoint{{0.1, 0.2, 0.3}, 0}), outside);
  });
}

TEST(EmptySpace, FindsTheCellsOfAnEyeThatMoves) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const EmptySpace space = space_of(tree, level);
    Vec3 eye{0.0};
    std::uint32_t cell = kOuterSpace;
    for (const Vec3 point : sample_points(space, 13)) {
      const std::vector<std::uint32_t> wanted = cells_with(space, point, false);
      if (cell != kOuterSpace) {
        ASSERT_EQ(space.find_cells(point, cell, eye), wanted);
      }
      if (wanted.size() != 1) continue;
      eye = point;
      cell = wanted[0];
    }
  });
}

double area_of(std::span<const Vec3> corners) {
  Vec3 twice_area{0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    twice_area += glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  }
  return 0.5 * glm::length(twice_area);
}

std::vector<Vec3> face_corners(const Polyhedron& cell, const Polyhedron::Face& face) {
  std::vector<Vec3> corners;
  for (const Polyhedron::Corner& corner : cell.loop(face)) {
    corners.push_back(cell.vertices[corner.vertex].position);
  }
  return corners;
}

TEST(Openings, LieInTheBoundariesOfBothNeighbours) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const EmptySpace space = space_of(tree, level);
    const PlaneSet planes = tree.plane_set();
    for (const Opening& opening : space.openings().openings) {
      for (const std::uint32_t cell : opening.cells) {
        if (cell == kOuterSpace) continue;
        const bool is_first = cell == opening.cells[0];
        const PlaneRef outward = is_first ? opening.plane : opening.plane.flipped();
        const auto& faces = space.cells()[cell].faces;
        ASSERT_TRUE(std::any_of(faces.begin(), faces.end(), [&](const Polyhedron::Face& face) {
          return face.plane == outward;
        }));
        for (const Vec3 corner : space.openings().corners_of(opening)) {
          const Plane own = planes[outward];
          ASSERT_NEAR(glm::dot(own.normal, corner), own.offset, 1e-12);
          for (const Polyhedron::Face& face : faces) {
            const Plane plane = planes[face.plane];
            ASSERT_LE(glm::dot(plane.normal, corner) - plane.offset, 1e-12);
          }
        }
      }
    }
  });
}

bool is_in_universe_wall(const Surface& surface, const Surface::Face& face, double half_side) {
  const auto vertices = surface.vertices_of(surface.loops_of(face)[0]);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double wall : {-half_side, half_side}) {
      if (std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t vertex) {
            return std::abs(surface.vertices[vertex][axis] - wall) < 1e-12;
          })) {
        return true;
      }
    }
  }
  return false;
}

/// What of the cells' boundaries is no opening is the solid's boundary: nothing is closed that is
/// open, and nothing open that is closed.
TEST(Openings, AreAllThatTheSolidLeavesOfTheCellsBoundaries) {
  for_trees([](const Octree& tree, std::uint32_t level) {
    const Surface surface = rebuild_surface(tree, level);
    double closed = area(surface);
    for (const Surface::Face& face : surface.faces) {
      if (!is_in_universe_wall(surface, face, tree.universe.half_side)) continue;
      Surface outermost = surface;  // no cell is beyond these
      outermost.faces = {face};
      closed -= area(outermost);
    }
    for (const bool merges : {false, true}) {
      const EmptySpace space = space_of(tree, level, merges);
      double sum = 0;
      for (const Polyhedron& cell : space.cells()) {
        for (const Polyhedron::Face& face : cell.faces) sum += area_of(face_corners(cell, face));
      }
      for (const Opening& opening : space.openings().openings) {
        const int cells = opening.cells[1] == kOuterSpace ? 1 : 2;
        sum -= cells * area_of(space.openings().corners_of(opening));
      }
      EXPECT_NEAR(sum, closed, 1e-9);
    }
  });
}

TEST(EmptySpace, HasFewerCellsWhereNeighboursAreMerged) {
  const Octree tree = tree_of_model("house-plan");
  const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
  EXPECT_LT(2 * space_of(tree, last).cells().size(), space_of(tree, last, false).cells().size());
}

TEST(EmptySpace, OfAHouseHasRoomsFromWhichNoWayLeadsOut) {
  const Octree tree = tree_of_model("house-plan");
  const EmptySpace space = space_of(tree, 99);
  const std::vector<bool> is_open = cells_open_to_outer_space(space);
  const Vec3 rooms[] = {{3000, 4000, 1500}, {8000, 6000, 1500}, {8000, 2000, 1500}};
  for (const Vec3 room : rooms) {
    const auto cells = space.find_cells(Viewpoint{tree.universe.to_universe(room), 1});
    ASSERT_FALSE(cells.empty());
    EXPECT_FALSE(is_open[cells[0]]);
  }
}

/// Both methods draw the same, up to 1e-6 of the diagonal. The length drawn, in diagonals.
double expect_same(const LineScene& scene, const CellScene& cells, const Camera& camera,
                   Rectangle frame) {
  // What lies exactly on the frame's border may be in the picture or not.
  frame = {frame.lower - 1e-3, frame.upper + 1e-3};
  const DrawingDifference difference = compare_methods(scene, cells, camera, frame);
  EXPECT_EQ(difference.only_first, 0);
  EXPECT_EQ(difference.only_second, 0);
  for (const std::string& fault : difference.faults) ADD_FAILURE() << fault;
  return difference.length / scene.diagonal();
}

const Vec3 kDirections[] = {{0.55, -0.71, 0.44}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}, {-1, 1, 1}};

TEST(Avenues, ShowWhatIsSeenFromFrontToBack) {
  double drawn = 0;
  for_trees([&](const Octree& tree, std::uint32_t level) {
    const LineScene scene(tree, rebuild_surface(tree, level), level);
    const CellScene cells(scene);
    for (const Vec3 direction : kDirections) {
      SCOPED_TRACE("from " + std::to_string(direction.x) + ", " + std::to_string(direction.y));
      const Camera camera(direction);
      drawn += expect_same(scene, cells, camera, extent_of_universe(tree.universe, camera));
    }
    const Camera outside = Camera::perspective({2.1, -3.3, 1.7}, {0.1, 0, -0.1});
    drawn += expect_same(scene, cells, outside, extent_of_universe(tree.universe, outside));
  });
  EXPECT_GT(drawn, 100);
}

TEST(Avenues, ShowFromWithinWhatIsSeenFromFrontToBack) {
  double drawn = 0;
  for_trees([&](const Octree& tree, std::uint32_t level) {
    const LineScene scene(tree, rebuild_surface(tree, level), level);
    const CellScene cells(scene);
    for (const EyeWithin& eye : eyes_within(cells.space(), 3)) {
      for (const Vec3 direction : kDirections) {
        const Camera camera = Camera::perspective(eye.at, eye.at - 0.5 * direction);
        const double half = camera.focal_length();
        drawn += expect_same(scene, cells, camera, {{-half, -half}, {half, half}});
      }
    }
  });
  EXPECT_GT(drawn, 20);
}

TEST(Avenues, ShowTheSameToAnEyeInAWallOfTheTree) {
  // Material on both sides of the wall meets in the picture along a line that reaches past the
  // viewer, and hides the lines on it.
  for (const std::uint64_t seed : {94u, 604u}) {
    const Octree tree = random_tree(seed, {.max_nodes = 200});
    const LineScene scene(tree, rebuild_surface(tree));
    const CellScene cells(scene);
    for (const EyeWithin& eye : eyes_within(cells.space(), 3)) {
      const Camera camera = Camera::perspective(eye.at, eye.at - 0.5 * kDirections[0]);
      const double half = camera.focal_length();
      expect_same(scene, cells, camera, {{-half, -half}, {half, half}});
    }
  }
}

/// Middles of faces and edges of cells, corners, as rounding leaves them, well off the solid.
std::vector<Vec3> eyes_on_borders(const EmptySpace& space, std::uint32_t level) {
  std::vector<Vec3> eyes;
  const auto& cells = space.cells();
  for (std::size_t cell = 0; cell < cells.size(); cell += 1 + cells.size() / 6) {
    const Polyhedron& polyhedron = cells[cell];
    eyes.push_back(polyhedron.vertices[0].position);
    for (const Polyhedron::Face& face : polyhedron.faces) {
      const std::vector<Vec3> corners = face_corners(polyhedron, face);
      eyes.push_back(0.5 * (corners[0] + corners[1]));
      eyes.push_back((corners[0] + corners[1] + corners[2]) / 3.0);
    }
  }
  std::erase_if(eyes, [&](Vec3 eye) {
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Vec3 aside{octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1};
      const Vec3 beside = eye + 1e-6 * aside;
      const double half = space.tree().universe.half_side;
      if (std::max({std::abs(beside.x), std::abs(beside.y), std::abs(beside.z)}) > half ||
          classify_point(space.tree(), beside, level) != PointClass::Out) {
        return true;
      }
    }
    return false;
  });
  return eyes;
}

TEST(Avenues, ShowTheSameToAnEyeOnTheBorderOfCells) {
  double drawn = 0;
  for (const char* name : {"mechanical-piece", "double-torus", "house-plan"}) {
    SCOPED_TRACE(name);
    const Octree tree = tree_of_model(name);
    const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
    const LineScene scene(tree, rebuild_surface(tree));
    const CellScene cells(scene);
    for (const Vec3 eye : eyes_on_borders(cells.space(), last)) {
      for (const Vec3 direction : kDirections) {
        const Camera camera = Camera::perspective(eye, eye - 0.5 * direction);
        const double half = camera.focal_length();
        drawn += expect_same(scene, cells, camera, {{-half, -half}, {half, half}});
      }
    }
  }
  EXPECT_GT(drawn, 100);
}

/// Hidden lines are what is left, whatever finds the others.
TEST(Avenues, LeaveTheSameHiddenLines) {
  const Octree tree = tree_of_model("mechanical-piece");
  const LineScene scene(tree, rebuild_surface(tree));
  const CellScene cells(scene);
  const Camera camera;
  LineOptions options;
  options.with_hidden_lines = true;
  const VisibleLines front = visible_lines(scene, camera, options);
  options.find_seen_parts = cells.finder();
  const VisibleLines seen = visible_lines(scene, camera, options);
  ASSERT_EQ(front.size(), seen.size());
  for (std::size_t k = 0; k < front.size(); ++k) {
    EXPECT_EQ(front[k].hidden, seen[k].hidden);
    EXPECT_EQ(front[k].kind, seen[k].kind);
    EXPECT_LT(glm::distance(front[k].a, seen[k].a), 1e-9);
    EXPECT_LT(glm::distance(front[k].b, seen[k].b), 1e-9);
  }
}

TEST(Avenues, SeeOneRoomOnlyWhereThereAreNoDoors) {
  const Octree tree = tree_of_model("nested-boxes");
  const LineScene scene(tree, rebuild_surface(tree));
  const CellScene cells(scene);
  const Camera camera = Camera::perspective({0.25, 0.01, 0.02}, {0.25, 0.5, 0.1});
  AvenueCounts counts;
  LineOptions options;
  options.find_seen_parts = cells.finder(&counts);
  visible_lines(scene, camera, options);
  EXPECT_GE(counts.avenues, counts.cells);
  const std::vector<bool> is_open = cells_open_to_outer_space(cells.space());
  EXPECT_LE(counts.cells,
            static_cast<std::uint64_t>(std::count(is_open.begin(), is_open.end(), false)));
}

TEST(Avenues, AreNoneFromWithinMaterial) {
  const Octree tree = tree_of_model("cube");
  const LineScene scene(tree, rebuild_surface(tree));
  const CellScene cells(scene);
  AvenueCounts counts;
  LineOptions options;
  options.find_seen_parts = cells.finder(&counts);
  EXPECT_TRUE(visible_lines(scene, Camera::perspective({0.1, 0, 0}, {1, 0, 0}), options).empty());
  EXPECT_EQ(counts.avenues, 0u);
}

}  // namespace
}  // namespace spoctree
