// Wavefront OBJ: its vertices and polygons; everything about looks and names is skipped.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Reads the `v` and `f` (or `fo`) statements of an OBJ file, in capitals or not; all others are
/// skipped. Of a `v` the first three numbers count (weights and colours may follow); of a corner
/// `v/vt/vn` the first. Negative numbers count back from the last vertex above the face. A face may
/// use a vertex that comes later in the file. A backslash at the end of a line joins it to the
/// next. Faces of one or two corners are left out (soup.collapsed), but for one that breaks off at
/// the very end of the file.
/// `name` stands before each error message: "name:line: what". Vertices are counted from 1, as in
/// the file. Linear in the size of `bytes`.
/// Throws BadInput for numbers and statements that cannot be read so, and for a file without a
/// face.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

}  // namespace spoctree
