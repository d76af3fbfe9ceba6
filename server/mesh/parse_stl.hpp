// STL, text and binary: triangles that each bring their own corners, into triangles over shared
// vertices.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Whether `bytes` has exactly the size that a binary STL file with its facet count has. No text
/// file within mesh_limits::kMaxFileBytes does: four printable bytes make too large a count.
bool has_size_of_binary_stl(std::string_view bytes);

/// Reads an STL file; text and binary are told apart by has_size_of_binary_stl, since many binary
/// headers begin with "solid". Exactly equal corners become one vertex (-0.0 equals 0.0), numbered
/// in the order of the file. Normals and names are skipped; a text file may have several solids.
/// Error messages read "name:line: what" for text, "name: facet 7 (byte 434): what" for binary;
/// facets are counted from 0. Linear in the size of `bytes`.
/// Throws BadInput for anything else, and for a file without a facet.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// The two halves of parse_stl. REQUIRES for the binary one: has_size_of_binary_stl(bytes).
PolygonSoup parse_text_stl(std::string_view bytes, std::string_view name);
PolygonSoup parse_binary_stl(std::string_view bytes, std::string_view name);

}  // namespace spoctree
