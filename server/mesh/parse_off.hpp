// OFF, the text format of Geomview: counts, vertices, then faces as lists of vertex numbers.
#pragma once

#include <optional>
#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// What the keyword at the head of an OFF file announces, [ST][C][N][4][n]OFF, in capitals or not.
struct OffKeyword {
  bool has_texture = false;    ///< ST: a vertex has two texture coordinates
  bool has_colours = false;    ///< C: a vertex has a colour, of three or four numbers
  bool has_normals = false;    ///< N: a vertex has a normal
  bool homogeneous = false;    ///< 4: a vertex is x, y, z and a w to divide by
  bool has_dimension = false;  ///< n: the number of dimensions follows
  std::string_view rest;       ///< digits that follow without a blank between; mostly empty
};
std::optional<OffKeyword> parse_off_keyword(std::string_view word);

/// Reads text OFF. The keyword may be missing, and the counts may stand on its line; the count of
/// edges is not used and may be missing. Each vertex and each face has a line of its own. What
/// follows on it (normals, colours, texture coordinates) is skipped, as is what follows the last
/// face: the counts say what belongs to the mesh. A file that cannot be read so may also have its
/// values anywhere on lines; whether it was meant like that shows by its faces: each edge has to
/// have an even number of them. 4OFF points are divided by their w. Faces of one or two corners are
/// left out (soup.collapsed).
/// `name` stands before each error message: "name:line: what". Faces and vertices are counted
/// from 0. Linear in the size of `bytes`, n log n where values are anywhere.
/// Throws BadInput for everything else, for binary OFF, and for a file without a face.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

}  // namespace spoctree
