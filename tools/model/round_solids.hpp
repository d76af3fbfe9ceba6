// Solids of revolution as polyhedra with as many faces as are asked for.
#pragma once

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// A sphere of radius 50 mm around the origin, its corners on the sphere: `bands` bands of latitude
/// of 2 * bands faces each, triangles at the poles and trapezoids elsewhere. O(bands^2).
/// REQUIRES: bands >= 2.
PolygonMesh make_sphere(int bands);

/// The same with waves on it, up to 2.5 mm high, its faces split into triangles: as uneven as a
/// scan, with 4 * bands * (bands - 1) planes. O(bands^2). REQUIRES: bands >= 2.
PolygonMesh make_wavy_sphere(int bands);

/// A prism over a regular polygon of radius 50 mm, 100 mm high, bottom at z = 0; its caps are
/// single polygons. REQUIRES: sides >= 3.
PolygonMesh make_cylinder(int sides);

/// A pyramid over a regular polygon of radius 50 mm, 100 mm high, bottom at z = 0; its base is a
/// single polygon. REQUIRES: sides >= 3.
PolygonMesh make_cone(int sides);

}  // namespace spoctree::model
