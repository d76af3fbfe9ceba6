#include "tools/silhouettes/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "common/base/errors.hpp"
#include "common/base/parallel.hpp"
#include "server/silhouettes/build_from_silhouettes.hpp"
#include "server/silhouettes/render_silhouette.hpp"
#include "server/silhouettes/views.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {

namespace {

constexpr double kMillimetresPerUnit = 50;

TestObject make_object(const char* name, std::optional<int> size, double paper_volume) {
  const model::PolygonMesh mesh = model::make_model(name, size);
  PolygonSoup soup;
  soup.points = mesh.points;
  for (const model::Loop& face : mesh.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  ImportOptions options;
  options.flat_tolerance = 0;  // no point moves
  const Solid solid = import_solid(soup, name, options);

  TestObject object;
  object.name = name;
  object.paper_volume = paper_volume;
  object.volume = solid.volume / std::pow(kMillimetresPerUnit, 3);
  for (const Vec3& vertex : solid.vertices)
    object.points.push_back(solid.universe.to_model(vertex) / kMillimetresPerUnit);
  glm::dvec3 low = object.points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& point : object.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  for (glm::dvec3& point : object.points) point -= (low + high) / 2.0;
  for (const SolidTriangle& t : solid.triangles)
    object.triangles.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  return object;
}

/// The rotation by a unit quaternion.
glm::dmat3 rotation_of(double w, double x, double y, double z) {
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

glm::dmat3 make_rotation(const ExperimentOptions& options, std::uint64_t number) {
  std::mt19937_64 random(options.seed * 0x9e3779b97f4a7c15u + number);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double u = uniform();
  const double a = 2 * std::numbers::pi * uniform();
  const double b = 2 * std::numbers::pi * uniform();
  switch (options.orientation_kind) {
    case OrientationKind::Uniform:  // Shoemake, Uniform random rotations, Graphics Gems III
      return rotation_of(std::sqrt(u) * std::cos(b), std::sqrt(1 - u) * std::sin(a),
                         std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b));
    case OrientationKind::Angles: {
      const double c = 2 * std::numbers::pi * u;
      return rotation_of(std::cos(a / 2), 0, 0, std::sin(a / 2)) *
             rotation_of(std::cos(b / 2), 0, std::sin(b / 2), 0) *
             rotation_of(std::cos(c / 2), std::sin(c / 2), 0, 0);
    }
    case OrientationKind::AxisAngle: {
      const double height = 2 * u - 1;
      const double radius = std::sqrt(1 - height * height);
      const double s = std::sin(b / 2);
      return rotation_of(std::cos(b / 2), s * radius * std::cos(a), s * radius * std::sin(a),
                         s * height);
    }
  }
  return glm::dmat3(1);
}

/// Volumes of the octrees of one object in one orientation, per stage, in the paper's units.
struct Trial {
  std::array<double, 3> as_seen{};
  std::array<double, 3> grown{};
};

Trial try_orientation(const TestObject& object, const glm::dmat3& rotation,
                      const ExperimentOptions& options, double cube_side) {
  std::vector<glm::dvec3> points;
  points.reserve(object.points.size());
  for (const glm::dvec3& point : object.points)
    points.push_back(rotation * point * (2 / cube_side));
  std::vector<Silhouette> silhouettes;
  for (std::size_t view = 0; view < kViewCount; ++view) {
    const PictureSize size = options.square_pixels
                                 ? size_with_square_pixels(all_views()[view], options.size)
                                 : PictureSize{options.size, options.size};
    silhouettes.push_back({view, render_silhouette(all_views()[view], points, object.triangles,
                                                   size.width, size.height)});
  }
  SilhouetteOptions build;
  build.rules.max_depth = depth_of_pixels(silhouettes);
  build.rules.corner_fraction = options.corner_fraction;
  build.stages = {kStages.begin(), kStages.end()};
  const auto volumes = [&](bool grow) {
    build.grow = grow;
    const std::vector<double> shares = volumes_from_silhouettes(silhouettes, build);
    std::array<double, 3> units{};
    for (std::size_t i = 0; i < units.size(); ++i) units[i] = shares[i] * std::pow(cube_side, 3);
    return units;
  };
  return {volumes(false), volumes(true)};
}

Accuracy accuracy_of(double volume, const std::vector<double>& octree_volumes) {
  Accuracy accuracy;
  accuracy.lowest = volume / octree_volumes.front();
  accuracy.highest = accuracy.lowest;
  double sum = 0;
  double squares = 0;
  for (const double octree_volume : octree_volumes) {
    if (octree_volume == 0)
      throw BadInput("an object is lost between the pixels: --size should be larger");
    const double ratio = volume / octree_volume;
    accuracy.lowest = std::min(accuracy.lowest, ratio);
    accuracy.highest = std::max(accuracy.highest, ratio);
    sum += ratio;
    squares += ratio * ratio;
  }
  const auto count = static_cast<double>(octree_volumes.size());
  accuracy.average = sum / count;
  accuracy.deviation =
      std::sqrt(std::max(squares / count - accuracy.average * accuracy.average, 0.0));
  return accuracy;
}

}  // namespace

std::vector<TestObject> make_test_objects() {
  return {make_object("cube", {}, 8),
          make_object("cylinder", 96, 6.2832),
          make_object("cone", 96, 2.0944),
          make_object("sphere", 48, 4.1888),
          make_object("slice", {}, 2),
          make_object("pyramid", {}, 2.6667),
          make_object("wedge", {}, 0.6293),
          make_object("octagonal-prism", {}, 6.6274),
          make_object("rectangular-prism", {}, 2),
          make_object("arc", 32, 0.2945),
          make_object("small-cube", {}, 0.0156),
          make_object("self-occluding", 64, 0)};
}

std::vector<ExperimentRow> run_experiment(const std::vector<TestObject>& objects,
                                          const ExperimentOptions& options) {
  // The largest object, the cube, reaches sqrt(3) from the middle; its corners may not touch the
  // picture's border, or there would be no room to grow.
  const double cube_side = options.cube_side > 0 ? options.cube_side : 2 * std::sqrt(3.0) * 1.001;
  const auto count = static_cast<std::size_t>(options.orientations);
  std::vector<Trial> trials(objects.size() * count);
  parallel_for(trials.size(), [&](std::size_t i) {
    trials[i] =
        try_orientation(objects[i / count], make_rotation(options, i % count), options, cube_side);
  });
  std::vector<ExperimentRow> rows;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    ExperimentRow row;
    row.object = objects[i].name;
    row.volume = objects[i].volume;
    row.paper_volume = objects[i].paper_volume;
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
      std::vector<double> as_seen;
      std::vector<double> grown;
      for (std::size_t k = 0; k < count; ++k) {
        as_seen.push_back(trials[i * count + k].as_seen[stage]);
        grown.push_back(trials[i * count + k].grown[stage]);
      }
      row.as_seen[stage] = accuracy_of(row.volume, as_seen);
      row.grown[stage] = accuracy_of(row.volume, grown);
    }
    rows.push_back(row);
  }
  return rows;
}

std::array<double, 3> ratios_as_they_stand(const TestObject& object, int size, double cube_side,
                                           const ExperimentOptions& options) {
  ExperimentOptions changed = options;
  changed.size = size;
  std::array<double, 3> ratios = try_orientation(object, glm::dmat3(1), changed, cube_side).as_seen;
  for (double& ratio : ratios) ratio = object.volume / ratio;
  return ratios;
}

ExperimentRow average_of(const std::vector<ExperimentRow>& rows) {
  ExperimentRow all;
  all.object = "average of figure 11";
  double count = 0;
  for (const ExperimentRow& row : rows) count += row.paper_volume > 0 ? 1 : 0;
  for (const ExperimentRow& row : rows) {
    if (row.paper_volume == 0) continue;
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
      all.as_seen[stage].average += row.as_seen[stage].average / count;
      all.grown[stage].average += row.grown[stage].average / count;
    }
  }
  return all;
}

}  // namespace spoctree
