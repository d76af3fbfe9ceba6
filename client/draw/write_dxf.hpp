// A drawing -> DXF (R12, which every program reads).
#pragma once

#include <string>

#include "client/draw/drawing.hpp"

namespace spoctree {

/// LINE entities, and POLYLINEs for strokes of several lines; the unit is the page's millimetre
/// (the model's unit at scale 1), the origin its lower left corner, y upwards. A layer per pen,
/// with its colour and line type (CONTINUOUS or DASHED): "SILHOUETTE", "CREASE_STEP",
/// "CREASE_HIDDEN", ... Groups with a source have layers of their own, "CREASE_CONVEX_3": the
/// node's kind and level, and the names of the planes as extended data of the application SPOCTREE.
std::string to_dxf(const Drawing& drawing);

}  // namespace spoctree
