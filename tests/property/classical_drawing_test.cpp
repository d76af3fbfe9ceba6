// What is drawn of classical octrees is what an exact method sees of the cubes' boundary: no
// cracks, nothing hidden, nothing twice, at the last level and at one before.
#include <gtest/gtest.h>

#include "client/lines/line_scene.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/polygon_mesh.hpp"
#include "server/build/build_octree.hpp"
#include "tests/support/drawing_judge.hpp"
#include "tests/support/model_solid.hpp"

namespace spoctree {
namespace {

Octree classical(const char* name, PartialCells partial) {
  const Solid solid = model_solid(name);
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = ClassicalRules{4, partial};
  return build_octree(solid, queries, options).tree;
}

PlainMesh boundary_of(const Octree& tree, const Surface& surface) {
  const PolygonMesh mesh = make_polygon_mesh(surface, tree.universe);
  return parse_off_text(to_off(mesh));
}

void judge_views(const Octree& tree, std::uint32_t level) {
  SCOPED_TRACE(testing::Message() << "level " << level);
  const Surface surface = rebuild_surface(tree, level);
  const PlainMesh mesh = boundary_of(tree, surface);
  const LineScene scene(tree, surface, level);
  const bool is_last = level + 1 == tree.levels.size();
  const auto judge = [&](const Camera& camera, const JudgeView& view, bool with_hidden) {
    LineOptions options;
    options.with_hidden_lines = with_hidden;
    std::vector<DrawnLine> lines;
    for (const VisibleLine& line : visible_lines(scene, camera, options)) {
      lines.push_back(
          {tree.universe.to_model(line.a), tree.universe.to_model(line.b), line.hidden});
      EXPECT_EQ(line.is_step, !is_last);
    }
    const DrawingJudgement found = judge_drawing(mesh, view, lines);
    EXPECT_GT(found.seen, 0);
    EXPECT_TRUE(found.is_good()) << "no edge " << found.no_edge << ", hidden " << found.not_seen
                                 << ", missed " << found.missed << ", doubled " << found.doubled;
    for (const std::string& fault : found.faults) ADD_FAILURE() << fault;
  };
  for (const Vec3 from : {Vec3(0.55, -0.71, 0.44), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 1),
                          Vec3(0.002, -1, 0.001)}) {
    SCOPED_TRACE(testing::Message() << "from " << from.x << ' ' << from.y << ' ' << from.z);
    judge(Camera(from), JudgeView::parallel(from), from.z > 0.4);
  }
  const Vec3 eye(2.1, -3.3, 1.7);
  const Vec3 target(0.1, 0, -0.1);
  judge(Camera::perspective(eye, target),
        JudgeView::perspective(tree.universe.to_model(eye), tree.universe.to_model(target)), false);
}

TEST(ClassicalDrawing, IsWhatIsSeenOfTheCubes) {
  for (const char* name : {"cylinder", "cone", "sphere", "pyramid", "self-occluding", "diamond",
                           "double-torus", "nested-boxes"}) {
    for (const PartialCells partial : {PartialCells::Full, PartialCells::Half}) {
      SCOPED_TRACE(testing::Message() << name << ", partial " << static_cast<int>(partial));
      const Octree tree = classical(name, partial);
      const auto last = static_cast<std::uint32_t>(tree.levels.size() - 1);
      judge_views(tree, last);
      judge_views(tree, last - 1);
    }
  }
}

}  // namespace
}  // namespace spoctree
