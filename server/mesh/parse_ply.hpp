// PLY, text and binary of both byte orders: tables of vertices and of faces.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Reads x, y and z (of any type) of the element `vertex` and the list `vertex_indices` or
/// `vertex_index` (of any integer types) of the element `face`; other elements and properties are
/// skipped, and the order of all of them is free. In text each row has a line of its own. A file
/// has to end where its header's counts say.
/// Error messages read "name:line: what" in the header and in text, "name: byte 1234: what" in
/// binary tables; vertices and faces are counted from 0. Linear in the size of `bytes`.
/// Throws BadInput for anything else and for a file without a face.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

}  // namespace spoctree
