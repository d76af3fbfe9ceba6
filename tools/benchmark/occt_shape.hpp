// A rebuilt surface -> the boundary representation that OpenCASCADE's drawing algorithms take.
#pragma once

#include <TopoDS_Shape.hxx>

#include "client/rebuild/surface.hpp"
#include "common/geometry/plane.hpp"

namespace spoctree {

/// A solid of one shell whose faces are the surface's, each a part of its plane with all its holes,
/// and share their edges and vertices: what sewing the faces together would lead to. OpenCASCADE
/// takes points closer than 1e-7 for one, so a unit of the universe is 1000 here, as if the part
/// were a metre large and drawn in millimetres. Throws std::runtime_error, or an exception of
/// OpenCASCADE's, where it refuses a face or an edge.
TopoDS_Shape make_occt_solid(const Surface& surface, const PlaneSet& planes);

/// Gives each face of a shape triangles, as HLRBRep_PolyAlgo needs them; no corners are added.
void triangulate(const TopoDS_Shape& shape);

}  // namespace spoctree
