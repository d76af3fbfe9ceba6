// A polygon mesh -> the figures by which its tests judge it. Written apart from the generator, in
// plain doubles, for models of some thousand faces.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

struct OrientedPlane {
  glm::dvec3 normal;  ///< unit length, outward
  double offset;      ///< normal . x of its points
};

enum class Bend { Convex, Flat, Concave };

/// Vector area of the face: along its outward normal, as long as the face is large.
glm::dvec3 vector_area(const PolygonMesh& mesh, const Loop& face);

double diagonal(const PolygonMesh& mesh);

/// Volume by the divergence theorem.
double volume(const PolygonMesh& mesh);

/// What keeps the mesh from being closed, one complaint or none: a corner out of range, a point
/// that is unused or stands twice, a directed edge that stands twice or without its reverse.
std::string why_not_closed(const PolygonMesh& mesh);

/// Largest distance of a corner from the plane of its face.
double worst_flatness(const PolygonMesh& mesh);

/// No side of the face touches another one but at the corner they share. O(sides^2).
bool is_simple(const PolygonMesh& mesh, const Loop& face);

/// The planes of the faces, each once; faces turned opposite ways are in different planes.
std::vector<OrientedPlane> distinct_planes(const PolygonMesh& mesh);

/// How many of the planes have the whole mesh on their inner side.
std::size_t count_hull_planes(const PolygonMesh& mesh);

/// Number of shells: sets of faces that hang together by edges.
std::size_t count_shells(const PolygonMesh& mesh);

/// V - E + F.
long euler_characteristic(const PolygonMesh& mesh);

/// How the edges at a point bend, in their order around it. REQUIRES: a closed mesh.
std::vector<Bend> bends_around(const PolygonMesh& mesh, std::uint32_t point);

}  // namespace spoctree::model
