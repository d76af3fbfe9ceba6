#include "tools/model/test_objects.hpp"

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "tools/model/face_list.hpp"
#include "tools/model/round_solids.hpp"

namespace spoctree::model {

namespace {

/// A square around the z axis, counterclockwise seen from above.
Corners2 square(double half_width, glm::dvec2 middle = {0, 0}) {
  const double h = half_width;
  return {{middle.x - h, middle.y - h},
          {middle.x + h, middle.y - h},
          {middle.x + h, middle.y + h},
          {middle.x - h, middle.y + h}};
}

PolygonMesh prism(const Corners2& profile, double z_low, double z_high) {
  FaceList faces;
  faces.add_prism(profile, z_low, z_high);
  return faces.mesh();
}

PolygonMesh box(const glm::dvec3& half_widths) {
  FaceList faces;
  faces.add_box(-half_widths, half_widths);
  return faces.mesh();
}

Corners reversed(Corners corners) { return {corners.rbegin(), corners.rend()}; }

}  // namespace

PolygonMesh make_slice() { return box({50, 12.5, 50}); }

PolygonMesh make_small_cube() { return box({6.25, 6.25, 6.25}); }

PolygonMesh make_pyramid() {
  const Corners base = at_height(square(50), -50);
  const glm::dvec3 apex(0, 0, 50);
  FaceList faces;
  faces.add(reversed(base));
  for (std::size_t i = 0; i < base.size(); ++i)
    faces.add({base[i], base[(i + 1) % base.size()], apex});
  return faces.mesh();
}

PolygonMesh make_wedge() {
  const Corners base = at_height(square(25), 0);
  const Corners top = at_height(square(5), 40);
  FaceList faces;
  faces.add(reversed(base));
  faces.add(top);
  faces.add_walls(base, top);
  return faces.mesh();
}

PolygonMesh make_octagonal_prism() {
  const double a = 50 * (std::numbers::sqrt2 - 1);
  return prism({{a, -50}, {50, -a}, {50, a}, {a, 50}, {-a, 50}, {-50, a}, {-50, -a}, {-a, -50}},
               -50, 50);
}

PolygonMesh make_rectangular_prism() {
  // Made over the y-z plane: turning the axes round once keeps the faces' orientation.
  PolygonMesh mesh = prism({{-50, -50}, {0, -50}, {50, 50}, {0, 50}}, 0, 50);
  for (glm::dvec3& point : mesh.points) point = {point.z, point.x, point.y};
  return mesh;
}

PolygonMesh make_arc(int sides) {
  Corners2 profile;
  const auto add_arc = [&](double radius, int from, int step) {
    for (int k = 0; k <= sides; ++k) {
      const int at = from + step * k;
      const double angle = std::numbers::pi / 2 * at / sides;
      // The ends are on the axes.
      profile.emplace_back(at == sides ? 0 : radius * std::cos(angle),
                           at == 0 ? 0 : radius * std::sin(angle));
    }
  };
  add_arc(50, 0, 1);
  add_arc(25, sides, -1);
  return prism(profile, -12.5, 12.5);
}

PolygonMesh make_self_occluding(int sides) {
  constexpr double kFloor = -50;
  constexpr double kPlate = -40;
  struct Tower {
    Corners2 profile;
    double top;
  };
  std::vector<Tower> towers;
  for (const double x : {-32.0, 32.0}) {
    for (const double y : {-32.0, 32.0}) towers.push_back({square(10, {x, y}), 50});
  }
  const PolygonMesh round = make_cylinder(sides);
  Corners2 circle;
  for (std::size_t k = 0; k < static_cast<std::size_t>(sides); ++k)
    circle.emplace_back(0.36 * round.points[k].x, 0.36 * round.points[k].y);
  towers.push_back({circle, 35});

  FaceList faces;
  const Corners2 plate = square(50);
  faces.add(reversed(at_height(plate, kFloor)));
  faces.add_walls(at_height(plate, kFloor), at_height(plate, kPlate));
  std::vector<Corners> feet;
  for (const Tower& tower : towers) {
    const Corners foot = at_height(tower.profile, kPlate);
    const Corners top = at_height(tower.profile, tower.top);
    feet.push_back(reversed(foot));
    faces.add_walls(foot, top);
    faces.add(top);
  }
  faces.add(at_height(plate, kPlate), feet);
  return faces.mesh();
}

}  // namespace spoctree::model
