// OFF, the text format of Geomview: counts, vertices, then faces as lists of vertex numbers.
#pragma once

#include <optional>
#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// What the keyword at the head of an OFF file announces, [ST][C][N][4][n]OFF.
struct OffKeyword {
  bool homogeneous = false;    ///< 4: x y z w for each vertex
  bool has_dimension = false;  ///< n: the dimension follows, before the counts
  std::string_view rest;       ///< what stands after OFF without a blank between; mostly empty
};
std::optional<OffKeyword> parse_off_keyword(std::string_view word);

/// Reads text OFF. The keyword may be missing, and the counts may stand on its line; the count of
/// edges is not used and may be missing. Each vertex and each face has a line of its own. What
/// follows on it (normals, colours, texture coordinates) is skipped, as is what follows the last
/// face: the counts say what belongs to the mesh. 4OFF points are divided by their w.
/// `name` stands before each error message: "name:line: what". Faces and vertices are counted
/// from 0. Linear in the size of `bytes`.
/// Throws BadInput for everything else, for binary OFF, and for a file without a face.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

}  // namespace spoctree
