// Times what a viewer does with a finished tree, of any kind: classical octrees, say.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "client/lines/camera.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface.hpp"
#include "common/program/threads.hpp"
#include "common/tree/cube_measures.hpp"
#include "common/wire/spo_file.hpp"
#include "tools/benchmark/benchmark_model.hpp"

namespace spoctree {

namespace {

/// What the stages need, made when it is first asked for.
class TreeModel {
 public:
  explicit TreeModel(std::string path) : path_(std::move(path)) {}

  const Octree& tree() {
    if (!tree_) tree_ = SpoFile(path_).tree();
    return *tree_;
  }
  const Surface& surface() {
    if (!surface_) surface_ = rebuild_surface(tree());
    return *surface_;
  }
  const LineScene& scene() {
    if (!scene_) scene_.emplace(tree(), surface());
    return *scene_;
  }

  void count_nodes(benchmark::State& state) {
    double nodes = 0;
    double black = 0;
    bool has_planes = false;
    for (const Level& level : tree().levels) {
      nodes += level.size();
      black +=
          static_cast<double>(std::count(level.kinds.begin(), level.kinds.end(), NodeKind::Black));
      has_planes = has_planes || !level.references.empty();
    }
    state.counters["nodes"] = nodes;
    state.counters["full_leaves"] = black;
    if (!has_planes) {
      state.counters["graphics_nodes"] = static_cast<double>(count_exposed_cubes(tree()));
    }
  }

 private:
  std::string path_;
  std::optional<Octree> tree_;
  std::optional<Surface> surface_;
  std::optional<LineScene> scene_;
};

/// By one thread. `work` returns the number of things made.
template <class Prepare, class Work>
void add(const std::shared_ptr<TreeModel>& model, const std::string& name, Prepare prepare,
         Work work) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [model, prepare, work](benchmark::State& state) {
                                 const ThreadLimit one_thread(1);
                                 prepare(*model);
                                 std::size_t made = 0;
                                 for (auto _ : state) made = work(*model);
                                 state.counters["made"] = static_cast<double>(made);
                                 model->count_nodes(state);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace

void register_tree_benchmarks(const std::string& spo_path) {
  const auto model = std::make_shared<TreeModel>(spo_path);
  std::string name = "/";
  name += std::filesystem::path(spo_path).stem().string();
  add(
      model, "tree-rebuild" + name, [](TreeModel& m) { m.tree(); },
      [](TreeModel& m) { return rebuild_surface(m.tree()).faces.size(); });
  add(
      model, "tree-line-scene" + name, [](TreeModel& m) { m.surface(); },
      [](TreeModel& m) { return LineScene(m.tree(), m.surface()).creases().creases.size(); });
  add(
      model, "tree-draw" + name, [](TreeModel& m) { m.scene(); },
      [](TreeModel& m) { return visible_lines(m.scene(), Camera()).size(); });
}

}  // namespace spoctree
