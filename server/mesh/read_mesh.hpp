// A mesh file of any format we read into a polygon soup with shared vertices.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

enum class MeshFormat { Off, Obj, Stl, Ply };

/// The format that a file's extension (in any case) names; nothing if it names none of them.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);

/// Reads an OFF, OBJ, STL or PLY file. The extension (in any case) names the format; a file whose
/// content is evidently something else is rejected by its kind's name (find_file_kind). Exactly
/// equal points are merged, faces that have fewer than three different corners are left out
/// (soup.collapsed), and unused points removed (merge_equal_points). In the soup every corner is
/// the number of a point, every coordinate is finite, and every face has three or more different
/// points, none of them twice but as wrongly_repeated_vertex allows; nothing else about the shape
/// is judged. Linear in the size of the file, n log n for some odd ones. Throws BadInput, naming
/// the file and the place in it, for anything that is not such a file or goes over
/// server/mesh/limits.hpp.
PolygonSoup read_mesh(const std::filesystem::path& path);

/// The same for a file's content; `name` stands before error messages.
PolygonSoup parse_mesh(MeshFormat format, std::string_view bytes, std::string_view name);

}  // namespace spoctree
