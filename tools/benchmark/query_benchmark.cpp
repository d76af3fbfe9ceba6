#include "tools/benchmark/query_benchmark.hpp"

#include <benchmark/benchmark.h>

#include <ctime>

#include "tools/benchmark/query_samples.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kQuestions = 100'000;

/// What the benchmarks of one model share. Everything is made when it is first asked for.
struct Queries {
  explicit Queries(std::shared_ptr<BenchmarkModel> asked) : model(std::move(asked)) {}

  void prepare() {
    if (!index) index = std::make_unique<const QueryIndex>(model->built().tree);
    if (points.empty()) points = sample_points(model->solid(), kQuestions);
    if (rays.empty()) rays = sample_rays(model->solid(), kQuestions);
  }
  void prepare_cgal() {
    prepare();
    if (!cgal) cgal = std::make_unique<const CgalQueries>(model->solid());
  }

  std::shared_ptr<BenchmarkModel> model;
  std::unique_ptr<const QueryIndex> index;
  std::unique_ptr<const CgalQueries> cgal;
  std::vector<Vec3> points;
  std::vector<Ray> rays;
  double points_per_s = 0;
  double rays_per_s = 0;
};

/// Runs `ask` for all questions as often as the benchmark wants; questions per second of processor
/// time: nobody uses more than one thread, and others may be at work on the machine.
template <class Ask>
double time_questions(benchmark::State& state, Ask&& ask) {
  const std::clock_t begin = std::clock();
  for (auto _ : state) benchmark::DoNotOptimize(ask());
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kQuestions));
  return static_cast<double>(kQuestions) * static_cast<double>(state.iterations()) / time;
}

template <class Classify>
std::size_t count_inside(const std::vector<Vec3>& points, const Classify& classify) {
  std::size_t inside = 0;
  for (const Vec3 point : points) inside += classify(point) == PointClass::In;
  return inside;
}

template <class Hits>
std::size_t count_hits(const std::vector<Ray>& rays, const Hits& hits) {
  std::size_t hit = 0;
  for (const Ray& ray : rays) hit += hits(ray);
  return hit;
}

template <class Run>
void add(const std::string& stage, const std::shared_ptr<Queries>& queries, Run run) {
  benchmark::RegisterBenchmark((stage + "/" + queries->model->name()).c_str(),
                               [queries, run](benchmark::State& state) {
                                 run(state, *queries);
                                 state.counters["faces"] = queries->model->face_count();
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace

void register_query_benchmarks(const std::shared_ptr<BenchmarkModel>& model) {
  const auto queries = std::make_shared<Queries>(model);
  add("query-index", queries, [](benchmark::State& state, Queries& q) {
    q.prepare();
    for (auto _ : state) benchmark::DoNotOptimize(QueryIndex(q.model->built().tree));
  });
  add("classify", queries, [](benchmark::State& state, Queries& q) {
    q.prepare();
    q.points_per_s = time_questions(state, [&] {
      return count_inside(q.points, [&](Vec3 point) { return q.index->classify(point); });
    });
  });
  add("classify-cgal", queries, [](benchmark::State& state, Queries& q) {
    q.prepare_cgal();
    const double rate = time_questions(state, [&] {
      return count_inside(q.points, [&](Vec3 point) { return q.cgal->classify(point); });
    });
    state.counters["ours"] = q.points_per_s / rate;
  });
  const auto is_hit = [](const RayAnswer& answer) { return answer.kind == RayAnswer::Kind::Hit; };
  add("ray", queries, [is_hit](benchmark::State& state, Queries& q) {
    q.prepare();
    q.rays_per_s = time_questions(state, [&] {
      return count_hits(q.rays, [&](const Ray& ray) { return is_hit(q.index->first_hit(ray)); });
    });
  });
  add("ray-cgal", queries, [](benchmark::State& state, Queries& q) {
    q.prepare_cgal();
    const double rate = time_questions(state, [&] {
      return count_hits(q.rays, [&](const Ray& ray) { return q.cgal->hits(ray); });
    });
    state.counters["ours"] = q.rays_per_s / rate;
  });
}

}  // namespace spoctree
