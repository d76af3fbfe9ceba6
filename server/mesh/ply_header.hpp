// The head of a PLY file, which describes the tables that follow it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace spoctree {

enum class PlyEncoding { Ascii, BinaryLittleEndian, BinaryBigEndian };

enum class PlyScalar : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
std::size_t byte_size(PlyScalar type);
bool is_integer(PlyScalar type);

/// One column: a scalar, or in each row a list with its length before it.
struct PlyProperty {
  std::string name;
  PlyScalar type;
  bool is_list = false;
  PlyScalar count_type = PlyScalar::UInt8;  ///< of the length of a list
};

/// One table of `count` rows.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t body_offset = 0;  ///< of the first byte after the header
  std::size_t body_line = 0;    ///< number of the line that begins there

  /// The element of that name, or null.
  const PlyElement* find(std::string_view name) const;
};

/// Reads the header of the PLY file `bytes`; names come in lower case. The counts in it are sure to
/// fit into the file: the least space that all rows can take is there. (Rows of an element without
/// properties take none.)
/// Throws BadInput("name:line: what") for a header that is malformed, over mesh_limits, or claims
/// more than the file can hold. O(header bytes).
PlyHeader parse_ply_header(std::string_view bytes, std::string_view name);

}  // namespace spoctree
