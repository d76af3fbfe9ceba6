// Times each stage of the pipeline, mesh to surface.

#include <benchmark/benchmark.h>

#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/benchmark/benchmark_model.hpp"

namespace spoctree {

namespace {

/// `prepare` makes what `work` needs, before the clock runs.
template <class Prepare, class Work>
void add(const std::shared_ptr<BenchmarkModel>& model, const char* stage, Prepare prepare,
         Work work) {
  benchmark::RegisterBenchmark((stage + ("/" + model->name())).c_str(),
                               [model, prepare, work](benchmark::State& state) {
                                 prepare(*model);
                                 for (auto _ : state) benchmark::DoNotOptimize(work(*model));
                                 state.counters["faces"] = model->face_count();
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace

void register_pipeline_benchmarks(const std::shared_ptr<BenchmarkModel>& model) {
  using Model = BenchmarkModel;
  const auto read = [](Model& m) { m.soup(); };
  const auto import = [](Model& m) { m.queries(); };
  const auto build = [](Model& m) { m.built(); };
  const auto encode = [](Model& m) { m.stream(); };
  add(model, "import", read, [](Model& m) { return import_solid(m.soup(), m.name(), {}); });
  add(model, "build", import, [](Model& m) { return build_octree(m.solid(), m.queries(), {}); });
  add(model, "certify", build, [](Model& m) {
    certify(m.built(), m.solid(), m.queries());
    return m.built().tree.levels.size();
  });
  add(model, "encode", build, [](Model& m) { return encode_stream(m.built().tree, {}); });
  add(model, "decode", encode, [](Model& m) { return decode_stream(m.stream()); });
  add(model, "rebuild", build, [](Model& m) { return rebuild_surface(m.built().tree); });
  add(model, "decode+rebuild", encode,
      [](Model& m) { return rebuild_surface(decode_stream(m.stream())); });
}

}  // namespace spoctree
