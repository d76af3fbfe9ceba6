#include "client/lines/visible_lines.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "tests/support/sight_oracle.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

std::size_t count(const VisibleLines& lines, LineKind kind) {
  return static_cast<std::size_t>(std::count_if(
      lines.begin(), lines.end(), [&](const VisibleLine& line) { return line.kind == kind; }));
}

double total_length(const VisibleLines& lines) {
  double sum = 0;
  for (const VisibleLine& line : lines) sum += glm::distance(line.a, line.b);
  return sum;
}

/// The line with these ends, either way round, or nullptr.
const VisibleLine* find_line(const VisibleLines& lines, Vec3 a, Vec3 b) {
  for (const VisibleLine& line : lines) {
    const bool forward = glm::distance(line.a, a) < 1e-8 && glm::distance(line.b, b) < 1e-8;
    const bool backward = glm::distance(line.a, b) < 1e-8 && glm::distance(line.b, a) < 1e-8;
    if (forward || backward) return &line;
  }
  return nullptr;
}

struct Scene {
  Octree tree;
  Surface surface;
};

Scene scene_of(const Voxels& voxels, bool merged = true) {
  Scene scene{tree_of(voxels, merged), surface_of(voxels)};
  EXPECT_TRUE(validate(scene.tree).empty());
  return scene;
}

VisibleLines draw(const Scene& scene, Vec3 toward_viewer, const LineOptions& options = {}) {
  return visible_lines(scene.tree, scene.surface, Camera(toward_viewer), options);
}

void expect_agreement(const Scene& scene, Vec3 toward_viewer, int samples) {
  const VisibleLines lines = draw(scene, toward_viewer);
  const SightOracle oracle(scene.surface, scene.tree.plane_set(), toward_viewer);
  std::size_t tried = 0;
  for (const std::string& error : compare(lines, oracle, samples, tried)) {
    ADD_FAILURE() << error << " seen from (" << toward_viewer.x << ", " << toward_viewer.y << ", "
                  << toward_viewer.z << ")";
  }
  EXPECT_GT(tried, 0u);
}

const Vec3 kViews[] = {{0.55, -0.71, 0.44}, {-0.3, 0.2, 0.9}, {1, 1, 1},    {-1, 2, -3},
                       {0, -1, 0},          {0, 0, 1},        {0, 0, -1},   {-1, 0, 0},
                       {1, 1, 0},           {0, -1, 1},       {1, 0, 1e-9}, {1e-3, -1, 2e-3}};

/// A box of cells.
Voxels box(int depth, int x0, int y0, int z0, int x1, int y1, int z1) {
  return {depth, [=](int x, int y, int z) {
            return x >= x0 && x < x1 && y >= y0 && y < y1 && z >= z0 && z < z1;
          }};
}

/// One convex piece as a CONVEX root, from planes whose common points are simple vertices.
Scene convex_scene(const std::vector<Plane>& planes) {
  Scene scene;
  scene.tree.planes = planes;
  std::vector<std::uint32_t> references(planes.size());
  for (std::uint32_t k = 0; k < references.size(); ++k) references[k] = k;
  Level level;
  level.append(NodeKind::Convex, references);
  scene.tree.levels.push_back(level);
  return scene;
}

double on_grid(double value) { return std::ldexp(std::nearbyint(std::ldexp(value, 52)), -52); }

Scene octahedron() {
  std::vector<Plane> planes;
  const double third = on_grid(1 / std::sqrt(3.0));
  for (int k = 0; k < 8; ++k) {
    planes.push_back(
        {{k & 1 ? third : -third, k & 2 ? third : -third, k & 4 ? third : -third}, third * 0.5});
  }
  Scene scene = convex_scene(planes);
  Surface& surface = scene.surface;
  surface.vertices = {{-0.5, 0, 0}, {0.5, 0, 0},  {0, -0.5, 0},
                      {0, 0.5, 0},  {0, 0, -0.5}, {0, 0, 0.5}};
  for (std::uint32_t k = 0; k < 8; ++k) {
    std::uint32_t corners[3] = {k & 1u, 2 + (k >> 1 & 1u), 4 + (k >> 2 & 1u)};
    const bool odd = ((k & 1) + (k >> 1 & 1) + (k >> 2 & 1)) % 2 == 0;
    if (odd) std::swap(corners[1], corners[2]);
    surface.faces.push_back({PlaneRef::of_table(k), k, 1});
    surface.loops.push_back({3 * k, 3});
    for (const std::uint32_t corner : corners) surface.loop_vertices.push_back(corner);
  }
  for (std::uint32_t a = 0; a < 6; ++a) {
    for (std::uint32_t b = a + 1; b < 6; ++b) {
      if (a / 2 == b / 2) continue;
      Surface::Edge edge{a, b, static_cast<std::uint32_t>(surface.sides.size()), 0};
      for (std::uint32_t face = 0; face < 8; ++face) {
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t from = surface.loop_vertices[3 * face + k];
          const std::uint32_t to = surface.loop_vertices[3 * face + (k + 1) % 3];
          if (from == a && to == b) surface.sides.push_back({face, true});
          if (from == b && to == a) surface.sides.push_back({face, false});
        }
      }
      edge.side_count = static_cast<std::uint32_t>(surface.sides.size()) - edge.first_side;
      EXPECT_EQ(edge.side_count, 2u);
      surface.edges.push_back(edge);
    }
  }
  return scene;
}

TEST(VisibleLines, ShowsNineLinesOfACubeSixOfThemSilhouettes) {
  const VisibleLines lines = draw(scene_of(box(1, 0, 0, 0, 1, 1, 1)), {0.55, -0.71, 0.44});
  EXPECT_EQ(lines.size(), 9u);
  EXPECT_EQ(count(lines, LineKind::Silhouette), 6u);
  // The three lines that meet in the corner nearest to the viewer.
  EXPECT_NE(find_line(lines, {0, -1, 0}, {-1, -1, 0}), nullptr);
  EXPECT_NE(find_line(lines, {0, -1, 0}, {0, 0, 0}), nullptr);
  EXPECT_NE(find_line(lines, {0, -1, 0}, {0, -1, -1}), nullptr);
}

TEST(VisibleLines, ShowsFourLinesOfACubeSeenFromTheFront) {
  for (const Vec3 view : {Vec3{0, -1, 0}, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 0},
                          Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    const VisibleLines lines = draw(scene_of(box(1, 0, 0, 0, 1, 1, 1)), view);
    ASSERT_EQ(lines.size(), 4u);
    for (const VisibleLine& line : lines) {
      // On the near face, the one with the larger coordinate along the view.
      const double near = glm::dot(view, Vec3{-0.5, -0.5, -0.5}) + 0.5;
      EXPECT_NEAR(glm::dot(view, line.a), near, 1e-9);
      EXPECT_NEAR(glm::dot(view, line.b), near, 1e-9);
      EXPECT_EQ(line.kind, LineKind::Silhouette);
    }
  }
}

TEST(VisibleLines, ShowsSevenLinesOfACubeSeenAlongAFaceDiagonal) {
  // Two faces are seen, at 45 degrees, the other four edge-on or from behind.
  EXPECT_EQ(draw(scene_of(box(1, 0, 0, 0, 1, 1, 1)), {1, 1, 0}).size(), 7u);
}

TEST(VisibleLines, KnowTwoPlanesThatMeetInTheLineAlsoWhereFourFacesMeet) {
  // Two cells that touch in an edge only: the corners of a chess board.
  const Voxels voxels{1, [](int x, int y, int) { return x == y; }};
  for (const VisibleLine& line : draw(scene_of(voxels), {0.55, -0.71, 0.44})) {
    const Octree tree = tree_of(voxels);
    const Vec3 along = glm::normalize(line.b - line.a);
    const Vec3 n = tree.plane_set()[line.planes[0]].normal;
    const Vec3 m = tree.plane_set()[line.planes[1]].normal;
    EXPECT_NEAR(std::abs(glm::dot(glm::cross(n, m), along)), 1, 1e-12);
  }
}

TEST(VisibleLines, DrawsASolidBlockOfManyCellsAsOneCube) {
  const Scene scene = scene_of(box(4, 2, 2, 2, 10, 10, 10), false);
  const VisibleLines lines = draw(scene, {0.55, -0.71, 0.44});
  EXPECT_EQ(lines.size(), 9u);
  EXPECT_EQ(count(lines, LineKind::Silhouette), 6u);
  EXPECT_NEAR(total_length(lines), 9 * 1.0, 1e-8);
  EXPECT_EQ(draw(scene, {0, -1, 0}).size(), 4u);
}

TEST(VisibleLines, ShowsEightLinesOfAnOctahedron) {
  const Scene scene = octahedron();
  // 0.3 x + 0.2 y + 0.9 z is positive on the normals of the four upper faces only: seen are the
  // four edges that meet in the upper vertex, and the square around.
  const VisibleLines lines = draw(scene, {0.3, 0.2, 0.9});
  EXPECT_EQ(lines.size(), 8u);
  EXPECT_EQ(count(lines, LineKind::Silhouette), 4u);
  // Straight from above the lower edges lie under the upper ones.
  EXPECT_EQ(draw(scene, {0, 0, 1}).size(), 8u);
  // Along (1, 1, 0) the outline is a rhombus of four edges, each before another one, and one edge
  // of the square runs across its middle.
  EXPECT_EQ(draw(scene, {1, 1, 0}).size(), 5u);
}

TEST(VisibleLines, ShowsTheReflexEdgeOfAnLBracketFromItsOpenSideOnly) {
  const Voxels bracket{
      2, [](int x, int y, int z) { return y < 2 && ((z == 0 && x < 3) || (x == 0 && z < 3)); }};
  const Scene scene = scene_of(bracket);
  const Vec3 a{-0.5, -1, -0.5};
  const Vec3 b{-0.5, 0, -0.5};
  const VisibleLines open = draw(scene, {0.55, -0.71, 0.44});
  ASSERT_NE(find_line(open, a, b), nullptr);
  EXPECT_EQ(find_line(open, a, b)->kind, LineKind::Crease);
  // A prism over an L has 18 edges. Seen into the angle, hidden are the three edges that meet in
  // the corner farthest away, and no other.
  EXPECT_EQ(open.size(), 15u);
  EXPECT_EQ(find_line(draw(scene, {-0.55, -0.71, -0.44}), a, b), nullptr);
}

TEST(VisibleLines, CutsALineWhereABlockInFrontHidesIt) {
  // A slab up to z = -0.5, and a block over it: x -0.5 .. 0, y -0.5 .. 0, z 0.5 .. 1.
  const Voxels voxels{2,
                      [](int x, int y, int z) { return z == 0 || (z == 3 && x == 1 && y == 1); }};
  // From the slab's edge x = -1, z = -0.5, the line of sight (t - 1, y + 0.1 t, 2 t - 0.5) is at
  // the height of the block for t in 0.5 .. 0.75, and inside it if y is between -0.575 and -0.05.
  const VisibleLines lines = draw(scene_of(voxels), {1, 0.1, 2});
  EXPECT_NE(find_line(lines, {-1, -1, -0.5}, {-1, -0.575, -0.5}), nullptr);
  EXPECT_NE(find_line(lines, {-1, -0.05, -0.5}, {-1, 1, -0.5}), nullptr);
  EXPECT_EQ(lines.size(), 2u + 8u + 9u);
}

TEST(VisibleLines, CutsLinesAtBothEndsOfABarInFront) {
  // A bar along y over a narrower slab, seen from straight above: the bar hides a piece of the
  // slab's two edges, and nothing else is seen of the slab but its outline.
  const Voxels inset{3, [](int x, int y, int z) {
                       return (z < 2 && y >= 2 && y < 6) || (z == 5 && x >= 2 && x < 4);
                     }};
  const VisibleLines lines = draw(scene_of(inset), {0, 0, 1});
  EXPECT_EQ(lines.size(), 4u + 6u);
  EXPECT_NE(find_line(lines, {-1, -0.5, -0.5}, {-0.5, -0.5, -0.5}), nullptr);
  EXPECT_NE(find_line(lines, {0, -0.5, -0.5}, {1, -0.5, -0.5}), nullptr);
  EXPECT_NE(find_line(lines, {-1, 0.5, -0.5}, {-0.5, 0.5, -0.5}), nullptr);
  EXPECT_NE(find_line(lines, {0, 0.5, -0.5}, {1, 0.5, -0.5}), nullptr);
}

TEST(VisibleLines, HidesABoxBehindALargerOne) {
  const Voxels voxels{2, [](int x, int y, int z) {
                        return y == 0 || (y == 2 && x >= 1 && x < 3 && z >= 1 && z < 3);
                      }};
  EXPECT_EQ(draw(scene_of(voxels), {0, -1, 0}).size(), 4u);
  EXPECT_EQ(draw(scene_of(voxels), {0.1, -1, 0.1}).size(), 9u);
  EXPECT_EQ(draw(scene_of(voxels), {0, 1, 0}).size(), 8u);
}

TEST(VisibleLines, AddsHiddenLinesIfAsked) {
  LineOptions options;
  options.with_hidden_lines = true;
  const Scene scene = scene_of(box(1, 0, 0, 0, 1, 1, 1));
  const VisibleLines lines = draw(scene, {0.55, -0.71, 0.44}, options);
  EXPECT_EQ(lines.size(), 12u);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](auto& line) { return line.hidden; }), 3);
  // From the front all of them lie under the visible ones.
  EXPECT_EQ(draw(scene, {0, -1, 0}, options).size(), 4u);
}

TEST(VisibleLines, LeavesOutCreasesBelowTheAngleButNoSilhouette) {
  LineOptions options;
  options.crease_angle_deg = 91;
  const Scene scene = scene_of(box(1, 0, 0, 0, 1, 1, 1));
  EXPECT_EQ(draw(scene, {0.55, -0.71, 0.44}, options).size(), 6u);
  options.crease_angle_deg = 90;
  EXPECT_EQ(draw(scene, {0.55, -0.71, 0.44}, options).size(), 9u);
}

TEST(VisibleLines, RejectsAnglesOutOfRange) {
  const Scene scene = scene_of(box(1, 0, 0, 0, 1, 1, 1));
  for (const double angle : {-1.0, 180.5, std::nan("")}) {
    LineOptions options;
    options.crease_angle_deg = angle;
    EXPECT_THROW(draw(scene, {0, 0, 1}, options), UsageError);
  }
}

TEST(VisibleLines, AreNoneForAnEmptyTree) {
  const Voxels nothing{1, [](int, int, int) { return false; }};
  EXPECT_TRUE(draw(scene_of(nothing), {0, 0, 1}).empty());
}

TEST(VisibleLines, AgreeWithRaysOnCubesThatTouchInAnEdge) {
  const Voxels voxels{1, [](int x, int y, int) { return x == y; }};
  for (const Vec3 view : kViews) expect_agreement(scene_of(voxels), view, 5);
}

TEST(VisibleLines, AgreeWithRaysOnStairs) {
  const Voxels voxels{3, [](int x, int y, int z) { return z <= x && z <= y; }};
  for (const Vec3 view : kViews) expect_agreement(scene_of(voxels), view, 3);
}

TEST(VisibleLines, AgreeWithRaysOnAMengerSponge) {
  const Voxels voxels{4, [](int x, int y, int z) {
                        return x < 9 && y < 9 && z < 9 && in_menger_sponge(x, y, z, 2);
                      }};
  const Scene scene = scene_of(voxels);
  for (const Vec3 view : kViews) expect_agreement(scene, view, 1);
}

TEST(VisibleLines, DrawTheFrontOfAMengerSpongeAsSquares) {
  const Voxels voxels{4, [](int x, int y, int z) {
                        return x < 9 && y < 9 && z < 9 && in_menger_sponge(x, y, z, 2);
                      }};
  // The outline, the hole in the middle and eight small holes, four lines each; what lies deeper
  // is under these lines.
  for (const Vec3 view : {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, -1}}) {
    EXPECT_EQ(draw(scene_of(voxels), view).size(), 4u * 10u);
  }
}

TEST(VisibleLines, AreTheSameEveryTime) {
  const Voxels voxels{3, [](int x, int y, int z) { return (x * 5 + y * 3 + z * 7) % 4 < 2; }};
  const Scene scene = scene_of(voxels);
  const VisibleLines once = draw(scene, {0.3, 0.4, 0.5});
  const VisibleLines again = draw(scene, {0.3, 0.4, 0.5});
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].a, again[k].a);
    EXPECT_EQ(once[k].b, again[k].b);
  }
}

}  // namespace
}  // namespace spoctree
