// What the benchmarks are run on: mesh files, or spheres made by program, and what each stage of
// the pipeline makes of them. Every part is made once, when it is first asked for.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "client/rebuild/surface.hpp"
#include "server/build/build_octree.hpp"
#include "server/mesh/polygon_soup.hpp"
#include "server/solid/solid.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

class BenchmarkModel {
 public:
  BenchmarkModel(std::string name, std::function<PolygonSoup()> read);

  const std::string& name() const { return name_; }
  const PolygonSoup& soup();
  const Solid& solid();
  const SolidQueries& queries();
  /// With certified levels.
  BuiltOctree& built();
  const std::string& stream();
  const Surface& surface();
  /// Triangles of the solid, whatever the faces of the file were.
  double face_count() { return static_cast<double>(solid().triangles.size()); }

 private:
  std::string name_;
  std::function<PolygonSoup()> read_;
  std::optional<PolygonSoup> soup_;
  std::optional<Solid> solid_;
  std::optional<SolidQueries> queries_;
  std::optional<BuiltOctree> built_;
  std::optional<std::string> stream_;
  std::optional<Surface> surface_;
};

/// A mesh file, called by its name without folder and ending.
std::shared_ptr<BenchmarkModel> mesh_file_model(const std::string& path);

/// The generated model of that name.
std::shared_ptr<BenchmarkModel> wavy_sphere_model(int bands);

/// Registers each benchmark of a file for a model, as "stage/model".
void register_pipeline_benchmarks(const std::shared_ptr<BenchmarkModel>& model);
/// Of a .spo file: rebuilding, and drawing from `Camera()`, as "tree-STAGE/NAME".
void register_tree_benchmarks(const std::string& spo_path);
void register_drawing_benchmarks(const std::shared_ptr<BenchmarkModel>& model);

}  // namespace spoctree
