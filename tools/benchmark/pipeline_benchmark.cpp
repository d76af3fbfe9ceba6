// Times each stage of the pipeline, mesh to lines, on spheres with growing numbers of faces (dented,
// so that they are not one CONVEX node), and fits how each grows.
// Run: spoctree-benchmark [--benchmark_filter=REGEX]

#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>

#include "client/lines/camera.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/classify.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "server/mesh/polygon_soup.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

/// A sphere of `bands` latitude bands with waves on it.
PolygonSoup wavy_sphere(int bands) {
  const model::PolygonMesh mesh = model::make_model("sphere", bands);
  PolygonSoup soup;
  for (const Vec3& point : mesh.points) {
    const Vec3 u = glm::normalize(point);
    soup.points.push_back(
        point * (1 + 0.05 * std::sin(9 * u.x) * std::sin(8 * u.y) * std::sin(7 * u.z)));
  }
  soup.first_corner = {0};
  for (const auto& face : mesh.faces) {
    // Waves bend the sphere's flat faces: fans of triangles.
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      soup.corners.insert(soup.corners.end(), {face[0], face[k], face[k + 1]});
      soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
  }
  return soup;
}

/// Everything that the stages need, made once per size.
struct Stages {
  explicit Stages(int bands)
      : soup(wavy_sphere(bands)),
        solid(import_solid(soup, "sphere", {})),
        queries(solid),
        built(build_octree(solid, queries, {})) {
    certify(built, solid, queries);
    stream = encode_stream(built.tree, {});
    surface = rebuild_surface(built.tree);
  }
  PolygonSoup soup;
  Solid solid;
  SolidQueries queries;
  BuiltOctree built;
  std::string stream;
  Surface surface;
};

Stages& stages(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<Stages>> made;
  auto& entry = made[state.range(0)];
  if (!entry) entry = std::make_unique<Stages>(static_cast<int>(state.range(0)));
  return *entry;
}

void report_faces(benchmark::State& state, const Stages& s) {
  const auto faces = static_cast<std::int64_t>(s.solid.triangles.size());
  state.SetComplexityN(faces);
  state.counters["faces"] = static_cast<double>(faces);
  state.SetItemsProcessed(state.iterations() * faces);
}

template <class Work>
void time_stage(benchmark::State& state, Work&& work) {
  Stages& s = stages(state);
  for (auto _ : state) benchmark::DoNotOptimize(work(s));
  report_faces(state, s);
}

void import(benchmark::State& state) {
  time_stage(state, [](Stages& s) { return import_solid(s.soup, "sphere", {}); });
}
void build(benchmark::State& state) {
  time_stage(state, [](Stages& s) { return build_octree(s.solid, s.queries, {}); });
}
void certify_levels(benchmark::State& state) {
  time_stage(state, [](Stages& s) {
    certify(s.built, s.solid, s.queries);
    return s.built.tree.levels.size();
  });
}
void encode(benchmark::State& state) {
  time_stage(state, [](Stages& s) { return encode_stream(s.built.tree, {}); });
}
void decode(benchmark::State& state) {
  time_stage(state, [](Stages& s) { return decode_stream(s.stream); });
}
void rebuild(benchmark::State& state) {
  time_stage(state, [](Stages& s) { return rebuild_surface(s.built.tree); });
}
void draw(benchmark::State& state) {
  time_stage(state, [](Stages& s) {
    return visible_lines(s.built.tree, s.surface, Camera(Vec3{0.55, -0.71, 0.44}), {});
  });
}
/// One query per face, at points spread through the universe cube.
void classify(benchmark::State& state) {
  time_stage(state, [](Stages& s) {
    std::size_t inside = 0;
    const std::size_t count = s.solid.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      // A low-discrepancy sequence (additive recurrence with the plastic number's powers).
      const auto spread = [i](double ratio) {
        const double x = static_cast<double>(i + 1) * ratio;
        return 2 * (x - std::floor(x)) - 1;
      };
      const Vec3 point{spread(0.8191725133961645), spread(0.6710436067037893),
                       spread(0.5497004779019703)};
      inside += classify_point(s.built.tree, point) == PointClass::In;
    }
    return inside;
  });
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int bands : {16, 32, 64, 128}) b->Arg(bands);
  b->Unit(benchmark::kMillisecond)->Complexity();
}

BENCHMARK(import)->Apply(sizes);
BENCHMARK(build)->Apply(sizes);
BENCHMARK(certify_levels)->Apply(sizes);
BENCHMARK(encode)->Apply(sizes);
BENCHMARK(decode)->Apply(sizes);
BENCHMARK(classify)->Apply(sizes);
BENCHMARK(rebuild)->Apply(sizes);
BENCHMARK(draw)->Apply(sizes);

}  // namespace
}  // namespace spoctree

BENCHMARK_MAIN();
