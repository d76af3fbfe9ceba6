#include "tools/model/blocks.hpp"

#include "tools/model/face_list.hpp"

namespace spoctree::model {

namespace {
void add_octahedron(FaceList& faces, const glm::dvec3& centre, double radius) {
  for (const double z : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double x : {1.0, -1.0}) {
        const glm::dvec3 on_x = centre + glm::dvec3(x * radius, 0, 0);
        const glm::dvec3 on_y = centre + glm::dvec3(0, y * radius, 0);
        const glm::dvec3 on_z = centre + glm::dvec3(0, 0, z * radius);
        // x, y, z is the order of the first octant; each reflection turns it round.
        if (x * y * z > 0)
          faces.add({on_x, on_y, on_z});
        else
          faces.add({on_y, on_x, on_z});
      }
}
}  // namespace

PolygonMesh make_cube() {
  FaceList faces;
  faces.add_box(glm::dvec3(-50), glm::dvec3(50));
  return faces.mesh();
}

PolygonMesh make_octahedron() {
  FaceList faces;
  add_octahedron(faces, glm::dvec3(0), 50);
  return faces.mesh();
}

PolygonMesh make_diamond() {
  FaceList faces;
  // The face towards u + v is a rhombus: its far corners on those axes, its near ones on a cube.
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : {1.0, -1.0}) {
      for (const double b : {1.0, -1.0}) {
        glm::dvec3 u(0), v(0), w(0);
        u[axis] = 50 * a;
        v[(axis + 1) % 3] = 50 * b;
        w[(axis + 2) % 3] = 50 * a * b;
        faces.add({u, 0.5 * (u + v - w), v, 0.5 * (u + v + w)});
      }
    }
  }
  return faces.mesh();
}

PolygonMesh make_l_bracket() {
  FaceList faces;
  faces.add_prism({{0, 0}, {80, 0}, {80, 20}, {20, 20}, {20, 60}, {0, 60}}, 0, 40);
  return faces.mesh();
}

PolygonMesh make_double_torus() {
  FaceList faces;
  faces.add_prism(
      {{0, 0}, {100, 0}, {100, 60}, {0, 60}}, 0, 20,
      {{{20, 20}, {20, 40}, {40, 40}, {40, 20}}, {{60, 20}, {60, 40}, {80, 40}, {80, 20}}});
  return faces.mesh();
}

PolygonMesh make_nested_boxes() {
  FaceList faces;
  bool hollow = false;
  for (const double half_side : {50.0, 30.0, 15.0, 5.0}) {
    faces.add_box(glm::dvec3(-half_side), glm::dvec3(half_side), hollow);
    hollow = !hollow;
  }
  return faces.mesh();
}

PolygonMesh make_two_parts() {
  FaceList faces;
  faces.add_box(glm::dvec3(0), glm::dvec3(40));
  add_octahedron(faces, {80, 20, 20}, 25);
  return faces.mesh();
}

PolygonMesh make_saddle() {
  const glm::dvec3 middle(0, 0, 40);
  const Corners rim{{40, 40, 60}, {-40, 40, 20}, {-40, -40, 60}, {40, -40, 20}};
  Corners foot = rim;
  for (glm::dvec3& corner : foot) corner.z = 0;

  FaceList faces;
  faces.add({foot[3], foot[2], foot[1], foot[0]});
  faces.add_walls(foot, rim);
  for (int i = 0; i < 4; ++i) faces.add({middle, rim[i], rim[(i + 1) % 4]});
  return faces.mesh();
}

}  // namespace spoctree::model
