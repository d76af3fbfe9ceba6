// The binary form of STL.
#pragma once

#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Whether `bytes` has exactly the size that a binary STL file with its facet count has. No text
/// file within mesh_limits::kMaxFileBytes does: four printable bytes make too large a count.
bool has_size_of_binary_stl(std::string_view bytes);

/// Whether `bytes` can hold the facets that a binary STL file with its facet count has, and the
/// coordinates of the first of them are finite.
bool looks_like_binary_stl(std::string_view bytes);

/// Reads a binary STL file. Its size should follow from its facet count; if it does not, that is
/// remarked where it is evident what is meant:
/// - bytes that make no whole number of facets, or are all NUL, follow the facets counted: they are
///   ignored;
/// - the file holds another whole number of facets than its count says, and with all of them each
///   edge has an even number of facets: they are all read. (A part of them leaves a border, unless
///   it ends exactly between two shells.)
/// Throws BadInput for anything else, and for a file without a facet: "name: facet 7 (byte 434):
/// what" for a facet, counted from 0. Linear, n log n where the count is wrong.
PolygonSoup parse_binary_stl(std::string_view bytes, std::string_view name);

}  // namespace spoctree
