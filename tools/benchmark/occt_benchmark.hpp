// Hidden lines found by OpenCASCADE, which is what FreeCAD and CadQuery draw with.
#pragma once

#include <memory>

#include "tools/benchmark/benchmark_model.hpp"

namespace spoctree {

/// "draw-occt-poly" (HLRBRep_PolyAlgo, FreeCAD's coarse view, on the triangulated faces) and
/// "draw-occt-exact" (HLRBRep_Algo on the plane faces themselves): all edges of the boundary that
/// the tree gives back, seen as "draw" sees them, once each, by one thread as they always are. Only
/// finding the visible parts is timed; making the shape before is not, nor making edges of the
/// visible parts after it. Models of more than `most_faces` triangles are passed over: both need
/// time quadratic in the faces, and the exact one 3 GB of memory for 70,000 of them.
void register_occt_benchmarks(const std::shared_ptr<BenchmarkModel>& model, double most_faces);

}  // namespace spoctree
