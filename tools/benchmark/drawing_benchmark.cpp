// Times finding the visible lines, in different views.

#include <benchmark/benchmark.h>

#include <limits>
#include <optional>

#include "client/lines/camera.hpp"
#include "client/lines/visible_lines.hpp"
#include "common/program/threads.hpp"
#include "server/build/build_octree.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/benchmark/benchmark_model.hpp"

namespace spoctree {

namespace {

/// What a drawing is made from. Made when it is first asked for.
struct Scene {
  explicit Scene(std::shared_ptr<BenchmarkModel> drawn) : model(std::move(drawn)) {}
  virtual ~Scene() = default;

  virtual const Octree& tree() { return model->built().tree; }
  virtual const Surface& surface() { return model->surface(); }
  const LineScene& lines() {
    if (!prepared) prepared.emplace(tree(), surface());
    return *prepared;
  }

  std::shared_ptr<BenchmarkModel> model;
  std::optional<LineScene> prepared;
};

/// The model's mesh with a plate between it and the viewer of `Camera()`, hiding all of it.
PolygonSoup behind_plate(const PolygonSoup& model) {
  const Camera camera;
  const Vec3 axes[3] = {camera.right(), camera.up(), camera.toward_viewer()};
  Vec3 lower(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
  for (const Vec3 point : model.points) {
    const Vec3 seen{glm::dot(axes[0], point), glm::dot(axes[1], point), glm::dot(axes[2], point)};
    lower = glm::min(lower, seen);
    upper = glm::max(upper, seen);
  }
  const double size = glm::length(upper - lower);
  const Vec3 corner[2] = {{lower.x - 0.05 * size, lower.y - 0.05 * size, upper.z + 0.05 * size},
                          {upper.x + 0.05 * size, upper.y + 0.05 * size, upper.z + 0.10 * size}};
  PolygonSoup soup = model;
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (int i = 0; i < 8; ++i) {  // bit a of i: lower or upper along axis a
    soup.points.push_back(axes[0] * corner[i & 1].x + axes[1] * corner[(i >> 1) & 1].y +
                          axes[2] * corner[(i >> 2) & 1].z);
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    for (const std::uint32_t i : face) soup.corners.push_back(first + i);
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

struct SceneBehindPlate : Scene {
  using Scene::Scene;

  const Octree& tree() override {
    if (!built) {
      const Solid solid = import_solid(behind_plate(model->soup()), model->name(), {});
      built = build_octree(solid, SolidQueries(solid), {});
    }
    return built->tree;
  }
  const Surface& surface() override {
    if (!rebuilt) rebuilt = rebuild_surface(tree());
    return *rebuilt;
  }

  std::optional<BuiltOctree> built;
  std::optional<Surface> rebuilt;
};

/// What is done once per level, for all views: on every core.
void add_scene(const std::shared_ptr<Scene>& scene) {
  benchmark::RegisterBenchmark(
      ("line-scene/" + scene->model->name()).c_str(),
      [scene](benchmark::State& state) {
        scene->surface();
        for (auto _ : state) {
          benchmark::DoNotOptimize(LineScene(scene->tree(), scene->surface()));
        }
        state.counters["faces"] = scene->model->face_count();
      })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

/// By one thread; `lines` is how many lines the drawing has.
void add(const std::shared_ptr<Scene>& scene, const char* stage, const Camera& camera) {
  benchmark::RegisterBenchmark((stage + ("/" + scene->model->name())).c_str(),
                               [scene, camera](benchmark::State& state) {
                                 scene->lines();
                                 const ThreadLimit one_thread(1);
                                 std::size_t lines = 0;
                                 for (auto _ : state) {
                                   lines = visible_lines(scene->lines(), camera).size();
                                 }
                                 state.counters["lines"] = static_cast<double>(lines);
                                 state.counters["faces"] = scene->model->face_count();
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace

void register_drawing_benchmarks(const std::shared_ptr<BenchmarkModel>& model) {
  const auto scene = std::make_shared<Scene>(model);
  add_scene(scene);
  add(scene, "draw", Camera());
  add(scene, "draw-front", Camera(Vec3{0, -1, 0}));
  add(scene, "draw-near-front", Camera(Vec3{0.02, -1, 0.013}));
  add(scene, "draw-perspective", Camera::perspective(Vec3{1.1, -1.42, 0.88}, Vec3{0, 0, 0}));
  add(std::make_shared<SceneBehindPlate>(model), "draw-behind-plate", Camera());
}

}  // namespace spoctree
