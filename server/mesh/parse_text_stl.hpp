// The text form of STL.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Whether `bytes` begins like a text STL file: without NUL bytes, and one of the first lines
/// begins with "solid" or "facet".
bool looks_like_text_stl(std::string_view bytes);

/// Reads a text STL file. Words may be in any case and stand on any line; `end loop` and the like
/// may be two words, and a name may be glued to `endsolid`; what follows # or ; or // is a comment,
/// and lines of colours are skipped. Remarked: a file that does not begin with `solid` or ends
/// without `endsolid`, lines before the first facet that are none of this, and text without a facet
/// behind the last solid.
/// Throws BadInput("name:line: what") for anything else, and for a file without a facet. Linear.
PolygonSoup parse_text_stl(std::string_view bytes, std::string_view name);

}  // namespace spoctree
