#include "tools/benchmark/benchmark_model.hpp"

#include <filesystem>
#include <utility>

#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {

namespace {

PolygonSoup wavy_sphere(int bands) {
  const model::PolygonMesh mesh = model::make_model("wavy-sphere", bands);
  PolygonSoup soup;
  soup.points = mesh.points;
  soup.first_corner = {0};
  for (const auto& face : mesh.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

}  // namespace

BenchmarkModel::BenchmarkModel(std::string name, std::function<PolygonSoup()> read)
    : name_(std::move(name)), read_(std::move(read)) {}

const PolygonSoup& BenchmarkModel::soup() {
  if (!soup_) soup_ = read_();
  return *soup_;
}

const Solid& BenchmarkModel::solid() {
  if (!solid_) solid_ = import_solid(soup(), name_, {});
  return *solid_;
}

const SolidQueries& BenchmarkModel::queries() {
  if (!queries_) queries_.emplace(solid());
  return *queries_;
}

BuiltOctree& BenchmarkModel::built() {
  if (!built_) {
    built_ = build_octree(solid(), queries(), {});
    certify(*built_, solid(), queries());
  }
  return *built_;
}

const std::string& BenchmarkModel::stream() {
  if (!stream_) stream_ = encode_stream(built().tree, {});
  return *stream_;
}

const Surface& BenchmarkModel::surface() {
  if (!surface_) surface_ = rebuild_surface(built().tree);
  return *surface_;
}

std::shared_ptr<BenchmarkModel> mesh_file_model(const std::string& path) {
  return std::make_shared<BenchmarkModel>(std::filesystem::path(path).stem().string(),
                                          [path] { return read_mesh(path); });
}

std::shared_ptr<BenchmarkModel> wavy_sphere_model(int bands) {
  return std::make_shared<BenchmarkModel>("wavy-sphere-" + std::to_string(bands),
                                          [bands] { return wavy_sphere(bands); });
}

}  // namespace spoctree
