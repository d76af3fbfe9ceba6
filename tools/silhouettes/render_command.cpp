#include "tools/silhouettes/render_command.hpp"

#include <filesystem>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <system_error>
#include <vector>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"
#include "common/base/parallel.hpp"
#include "common/program/output.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/silhouettes/render_silhouette.hpp"
#include "server/silhouettes/views.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/silhouettes/view_cube.hpp"

namespace spoctree {

namespace {

Solid read_solid(const std::string& mesh) {
  ImportOptions options;
  options.flat_tolerance = 0;  // no point moves
  return import_solid(read_mesh(mesh), mesh, options);
}

std::vector<glm::dvec3> points_in(const Universe& cube, const Solid& solid,
                                  const RenderArguments& arguments) {
  constexpr double kSlack = 1e-9;  // the cube's side is rounded, too
  std::vector<glm::dvec3> points;
  points.reserve(solid.vertices.size());
  for (const Vec3& vertex : solid.vertices) {
    const glm::dvec3 p = in_cube(cube, solid.universe.to_model(vertex));
    if (glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(1 + kSlack))))
      throw BadInput(arguments.mesh + ": reaches beyond the cube " + arguments.cube);
    points.push_back(p);
  }
  return points;
}

}  // namespace

void run_render(const RenderArguments& arguments) {
  const std::vector<std::size_t> views = parse_views(arguments.views);
  const Solid solid = read_solid(arguments.mesh);
  const Universe cube =
      arguments.cube.empty() ? solid.universe : parse_cube(arguments.cube, "--cube");
  const std::vector<glm::dvec3> points = points_in(cube, solid, arguments);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(solid.triangles.size());
  for (const SolidTriangle& t : solid.triangles)
    triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});

  if (arguments.square_pixels && 2 * arguments.size > kMostMaskPixels)
    throw UsageError("--square-pixels: corner views would be larger than " +
                     std::to_string(kMostMaskPixels) + " pixels");
  const std::filesystem::path folder(arguments.folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(arguments.folder + ": " + error.message());
  parallel_for(views.size(), [&](std::size_t i) {
    const View& view = all_views()[views[i]];
    const PictureSize size = arguments.square_pixels ? size_with_square_pixels(view, arguments.size)
                                                     : PictureSize{arguments.size, arguments.size};
    const Mask mask = render_silhouette(view, points, triangles, size.width, size.height);
    const std::string name = std::string(view.name) + "." + std::string(name_of(arguments.format));
    write_file_atomically(folder / name, encode_mask(mask, arguments.format));
  });
  write_file_atomically(folder / kCubeFile, cube_text(cube));
  print(arguments.folder + ": " + std::to_string(views.size()) + " silhouettes\n");
}

}  // namespace spoctree
