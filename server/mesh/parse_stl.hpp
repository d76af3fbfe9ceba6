// STL, text and binary: triangles that each bring their own corners, into triangles over shared
// vertices.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Reads an STL file, text or binary: what has exactly the size of a binary file is one, since many
/// binary headers begin with "solid". Exactly equal corners become one vertex (-0.0 equals 0.0),
/// numbered in the order of the file. Normals, names and colours are skipped; a text file may have
/// several solids. What is odd but does no harm is in the soup's remarks: see parse_text_stl.hpp
/// and parse_binary_stl.hpp. Error messages read "name:line: what" for text, "name: facet 7 (byte
/// 434): what" for binary; facets are counted from 0. Linear in the size of `bytes`. Throws
/// BadInput for anything else, and for a file without a facet.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

}  // namespace spoctree
