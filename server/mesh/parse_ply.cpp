#include "server/mesh/parse_ply.hpp"

#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/closed_surface.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/ply_header.hpp"
#include "server/mesh/ply_rows.hpp"

namespace spoctree {

namespace {

const PlyElement& required_element(const PlyHeader& header, const char* element,
                                   std::uint64_t limit, std::string_view name) {
  const PlyElement* found = header.find(element);
  const std::string place = std::string(name) + ": the PLY header ";
  if (found == nullptr) throw BadInput(place + "has no element " + quoted(element));
  if (found->count > limit) {
    throw BadInput(place + "claims " + std::to_string(found->count) + " of the element " +
                   quoted(element) + ", the limit is " + std::to_string(limit));
  }
  return *found;
}

// Names are in lower case, whatever the file has.
bool is_coordinate(const PlyProperty& property) {
  return property.name == "x" || property.name == "y" || property.name == "z";
}

bool is_corner_list(const PlyProperty& property) {
  return property.name == "vertex_indices" || property.name == "vertex_index";
}

void check_vertex_properties(const PlyElement& vertex, std::string_view name) {
  int coordinates = 0;
  for (const PlyProperty& property : vertex.properties) {
    if (is_coordinate(property) && !property.is_list) ++coordinates;
  }
  if (coordinates != 3) {
    throw BadInput(std::string(name) + ": the element 'vertex' needs the numbers x, y and z");
  }
}

void check_face_properties(const PlyElement& face, std::string_view name) {
  int lists = 0;
  bool all_are_integer_lists = true;
  for (const PlyProperty& property : face.properties) {
    if (!is_corner_list(property)) continue;
    ++lists;
    all_are_integer_lists &= property.is_list && is_integer(property.type);
  }
  if (lists != 1 || !all_are_integer_lists) {
    throw BadInput(std::string(name) +
                   ": the element 'face' needs one list of integers 'vertex_indices' (or "
                   "'vertex_index')");
  }
  if (face.count == 0) throw BadInput(std::string(name) + ": the file has no faces");
}

template <class Rows>
std::uint64_t list_length(Rows& rows, const PlyProperty& list) {
  const std::int64_t length = rows.integer(list.count_type);
  if (length < 0) rows.fail("has a list of negative length");
  return static_cast<std::uint64_t>(length);
}

template <class Rows>
void skip_property(Rows& rows, const PlyProperty& property) {
  rows.skip(property.type, property.is_list ? list_length(rows, property) : 1);
}

template <class Rows>
void skip_element(Rows& rows, const PlyElement& element) {
  if (element.properties.empty()) return;  // its rows hold nothing, not even lines
  for (std::uint64_t i = 0; i < element.count; ++i) {
    rows.begin_row({"row", i});
    for (const PlyProperty& property : element.properties) skip_property(rows, property);
    rows.end_row();
  }
}

template <class Rows>
void read_vertices(Rows& rows, const PlyElement& element, PolygonSoup& soup) {
  soup.points.reserve(element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    rows.begin_row({"vertex", i});
    glm::dvec3 point;
    for (const PlyProperty& property : element.properties) {
      if (is_coordinate(property)) {
        const int axis = property.name[0] - 'x';
        point[axis] = rows.coordinate(axis, property.type);
      } else {
        skip_property(rows, property);
      }
    }
    rows.end_row();
    soup.points.push_back(point);
  }
  soup.precision = rows.precision();
}

template <class Rows>
void read_corners(Rows& rows, const PlyProperty& list, std::uint64_t vertices, PolygonSoup& soup) {
  const std::uint64_t length = list_length(rows, list);
  for (std::uint64_t i = 0; i < length; ++i) {
    const std::int64_t index = rows.integer(list.type);
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
      rows.fail("uses vertex " + std::to_string(index) + ", the file has " +
                std::to_string(vertices) + " vertices");
    }
    soup.corners.push_back(static_cast<std::uint32_t>(index));
  }
  const std::string fault = close_face(soup);
  if (!fault.empty()) rows.fail(fault);
}

template <class Rows>
void read_faces(Rows& rows, const PlyElement& element, std::uint64_t vertices, PolygonSoup& soup) {
  soup.first_corner.reserve(element.count + 1);
  soup.corners.reserve(3 * element.count);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    rows.begin_row({"face", i});
    for (const PlyProperty& property : element.properties) {
      if (is_corner_list(property)) {
        read_corners(rows, property, vertices, soup);
      } else {
        skip_property(rows, property);
      }
    }
    rows.end_row();
  }
}

template <class Rows>
PolygonSoup read_tables(Rows rows, const PlyHeader& header, const PlyElement& vertex,
                        const PlyElement& face) {
  PolygonSoup soup;
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) {
      read_vertices(rows, element, soup);
    } else if (&element == &face) {
      read_faces(rows, element, vertex.count, soup);
    } else {
      skip_element(rows, element);
    }
  }
  // Where the header counts too few faces, those behind are missing in the surface.
  if (const std::size_t behind = rows.bytes_behind(); behind > 0) {
    if (!is_closed_surface(soup)) rows.fail_behind();
    soup.remarks.push_back("ignored: " + std::to_string(behind) +
                           (behind == 1 ? " byte" : " bytes") +
                           " behind the last row that the header counts");
  }
  return soup;
}

// Values on any lines may be found in a damaged file, too, by taking them for others. It shows by
// the faces.
PolygonSoup read_text_tables(std::string_view bytes, std::string_view name, const PlyHeader& header,
                             const PlyElement& vertex, const PlyElement& face) {
  try {
    return read_tables(PlyTextRows(bytes, name, header, PlyTextLayout::Lines), header, vertex,
                       face);
  } catch (const BadInput&) {
    try {
      PolygonSoup soup = read_tables(PlyTextRows(bytes, name, header, PlyTextLayout::AnyLines),
                                     header, vertex, face);
      if (is_closed_surface(soup)) return soup;
    } catch (const BadInput&) {
    }
    throw;
  }
}

}  // namespace

PolygonSoup parse_ply(std::string_view bytes, std::string_view name) {
  if (bytes.empty()) throw BadInput(std::string(name) + ": the file is empty");
  const PlyHeader header = parse_ply_header(bytes, name);
  const PlyElement& vertex = required_element(header, "vertex", mesh_limits::kMaxPoints, name);
  const PlyElement& face = required_element(header, "face", mesh_limits::kMaxFaces, name);
  check_vertex_properties(vertex, name);
  check_face_properties(face, name);
  if (header.encoding == PlyEncoding::Ascii) {
    return read_text_tables(bytes, name, header, vertex, face);
  }
  return read_tables(PlyBinaryRows(bytes, name, header), header, vertex, face);
}

}  // namespace spoctree
