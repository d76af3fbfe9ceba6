// A drawing -> DXF (R12, which every program reads).
#pragma once

#include <string>

#include "client/draw/drawing.hpp"

namespace spoctree {

/// LINE entities, and POLYLINEs for strokes of several lines; the unit is the page's millimetre
/// (the model's unit at scale 1), the origin its lower left corner, y upwards. Layers have their
/// colour and line type (CONTINUOUS or DASHED): "SILHOUETTE", "CREASE_STEP", "HIDDEN", ... Groups
/// with a source have layers of their own: "CREASE_CONVEX_3" has the node's kind and level, and
/// "CREASE_CONVEX_3I" those whose planes stand in upper levels; "_L" and "_R" are the eyes. The
/// names of the planes, two for each stretch (of the first 200), are extended data of the
/// application SPOCTREE.
std::string to_dxf(const Drawing& drawing);

}  // namespace spoctree
