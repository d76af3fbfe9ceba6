// PLY, text and binary of both byte orders: tables of vertices and of faces.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Reads x, y and z (of any type) of the element `vertex` and the list `vertex_indices` or
/// `vertex_index` (of any integer types) of the element `face`; other elements and properties are
/// skipped, and the order of all of them is free. Words of the header may be in capitals. In text
/// each row has a line of its own; or the values are anywhere on lines, if then each edge has an
/// even number of faces. A file has to end where its header's counts say, or each edge has to have
/// an even number of faces, and what follows is ignored (soup.remarks). Faces of one or two corners
/// are left out (soup.collapsed). Error messages read "name:line: what" in the header and in text,
/// "name: byte 1234: what" in binary tables; vertices and faces are counted from 0. Linear in the
/// size of `bytes`, n log n for the odd files above. Throws BadInput for anything else and for a
/// file without a face.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

}  // namespace spoctree
