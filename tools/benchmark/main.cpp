// Runs the benchmarks on mesh files, or on spheres where none is given.
// Usage: spoctree-benchmark [--benchmark_filter=REGEX ...] [--peers-up-to=FACES] [MESH|SPO...]
// A .spo file is rebuilt and drawn, by one thread.
// Times are those of the wall and, as `CPU`, of all threads together. --peers-up-to is for the
// peers whose time is quadratic: OpenCASCADE's drawings, if it was there when this was built.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <limits>
#include <string_view>

#include "tools/benchmark/benchmark_model.hpp"
#include "tools/benchmark/query_benchmark.hpp"
#ifdef SPOCTREE_WITH_OCCT
#include "tools/benchmark/occt_benchmark.hpp"
#endif

namespace {

constexpr std::string_view kPeersUpTo = "--peers-up-to=";

}  // namespace

int main(int argc, char** argv) {
  using namespace spoctree;
  benchmark::Initialize(&argc, argv);  // takes its own arguments away
  // What one repetition frees, the next one uses: the kernel's work is not what is measured.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  double peers_up_to = 100'000;
  std::vector<std::shared_ptr<BenchmarkModel>> models;
  bool has_trees = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.starts_with(kPeersUpTo)) {
      const char* end = argument.data() + argument.size();
      const auto read = std::from_chars(argument.data() + kPeersUpTo.size(), end, peers_up_to);
      if (read.ec != std::errc() || read.ptr != end) {
        std::fprintf(stderr, "spoctree-benchmark: %s: not a number of faces\n", argv[i]);
        return 2;
      }
    } else if (argument.ends_with(".spo")) {
      has_trees = true;
      register_tree_benchmarks(argv[i]);
    } else {
      models.push_back(mesh_file_model(argv[i]));
    }
  }
  if (models.empty() && !has_trees) {
    for (const int bands : {16, 32, 64, 128}) models.push_back(wavy_sphere_model(bands));
  }
  for (const auto& model : models) {
    register_pipeline_benchmarks(model);
    register_drawing_benchmarks(model);
#ifdef SPOCTREE_WITH_OCCT
    register_occt_benchmarks(model, peers_up_to);
#endif
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
