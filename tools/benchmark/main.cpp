// Runs the benchmarks on mesh files, or on spheres where none is given.
// Usage: spoctree-benchmark [--benchmark_filter=REGEX ...] [MESH...]
// Times are those of the wall and, as `CPU`, of all threads together.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>

#include "tools/benchmark/benchmark_model.hpp"
#include "tools/benchmark/query_benchmark.hpp"

int main(int argc, char** argv) {
  using namespace spoctree;
  benchmark::Initialize(&argc, argv);  // takes its own arguments away
  std::vector<std::shared_ptr<BenchmarkModel>> models;
  for (int i = 1; i < argc; ++i) models.push_back(mesh_file_model(argv[i]));
  if (models.empty()) {
    for (const int bands : {16, 32, 64, 128}) models.push_back(wavy_sphere_model(bands));
  }
  for (const auto& model : models) {
    register_pipeline_benchmarks(model);
    register_query_benchmarks(model);
  }
  models.clear();
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "spoctree-benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
