// What must be true of every rebuilt surface, asked without the code that made it.
#pragma once

#include <string>
#include <vector>

#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// What is wrong with the surface itself, one line each; empty if nothing is: loops are cycles of
/// different vertices in range; vertices lie on their faces' planes; outer loops run
/// counter-clockwise around the plane's normal, holes clockwise; every directed edge of a loop is
/// met by as many opposite ones; the edges list each of them once with all its sides; no edge lies
/// within a flat face; no vertex lies within an edge without other need.
std::vector<std::string> faults_of(const Surface& surface, const Octree& tree);

/// The same for polygons: in range, different corners, closed.
std::vector<std::string> faults_of(const PolygonMesh& mesh);

/// Model volume of a polygon mesh by the divergence theorem.
double volume_of(const PolygonMesh& mesh);

/// How often the surface winds around a point that is not on it (1 inside, 0 outside), from the
/// crossings of a ray with its faces.
int winding_number(const Surface& surface, Vec3 point);

}  // namespace spoctree
