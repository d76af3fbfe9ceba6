#include "server/mesh/parse_stl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/point_table.hpp"
#include "server/mesh/stored_number.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;  // normal and three corners as 12 floats, 2 bytes unused
constexpr std::size_t kFirstCornerOffset = 12;

std::uint64_t claimed_facets(std::string_view bytes) {
  return stored_number<std::uint32_t>(bytes, kCountOffset, ByteOrder::LittleEndian);
}

bool equals_ignoring_case(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

class TextStlReader {
 public:
  TextStlReader(std::string_view bytes, std::string_view name)
      : cursor_(bytes, name, {.comment = '\0'}), table_(soup_.points) {}

  PolygonSoup read() {
    while (cursor_.next_line()) {
      expect("solid");
      cursor_.next_line();  // past the name, which may be anything and ends with its line
      std::string_view word = cursor_.next_word();
      while (equals_ignoring_case(word, "facet")) {
        read_facet({"facet", facet_number()});
        word = cursor_.next_word_of_any_line();
      }
      if (!equals_ignoring_case(word, "endsolid")) fail_expected("facet or endsolid", word);
    }
    if (facet_number() == 0) cursor_.fail("the file has no facets");
    soup_.precision = digits_.precision();
    return std::move(soup_);
  }

 private:
  std::size_t facet_number() const { return soup_.face_count() + soup_.collapsed.count; }

  void expect(std::string_view keyword) {
    const std::string_view word = cursor_.next_word_of_any_line();
    if (!equals_ignoring_case(word, keyword)) fail_expected(keyword, word);
  }

  [[noreturn]] void fail_expected(std::string_view keyword, std::string_view word) const {
    cursor_.fail("facet " + std::to_string(facet_number()) + ": expected " + std::string(keyword) +
                 ", found " + (word.empty() ? "the end of the file" : quoted(word)));
  }

  void read_facet(Item facet) {
    expect("normal");
    // Normals follow from the corners. Many writers have "nan" here for thin facets.
    for (int axis = 0; axis < 3; ++axis) {
      if (cursor_.next_word().empty()) cursor_.fail(to_string(facet) + ": the normal is cut short");
    }
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = cursor_.read_coordinate(facet, axis, digits_);
      }
      soup_.corners.push_back(table_.find_or_add(point));
    }
    const std::string_view word = cursor_.next_word_of_any_line();
    if (equals_ignoring_case(word, "vertex")) {
      cursor_.fail(to_string(facet) + " has more than 3 corners");
    }
    if (!equals_ignoring_case(word, "endloop")) fail_expected("endloop", word);
    expect("endfacet");
    if (soup_.points.size() > mesh_limits::kMaxPoints) {
      cursor_.fail("the file has more than " + std::to_string(mesh_limits::kMaxPoints) +
                   " vertices");
    }
    const std::string fault = close_face(soup_);
    if (!fault.empty()) cursor_.fail(to_string(facet) + " " + fault);
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  DigitRecord digits_;
  PointTable table_;
};

}  // namespace

bool has_size_of_binary_stl(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() - kHeaderBytes == kFacetBytes * claimed_facets(bytes);
}

PolygonSoup parse_text_stl(std::string_view bytes, std::string_view name) {
  return TextStlReader(bytes, name).read();
}

PolygonSoup parse_binary_stl(std::string_view bytes, std::string_view name) {
  const std::uint64_t facets = claimed_facets(bytes);
  if (facets == 0) throw BadInput(std::string(name) + ": the file has no facets");
  PolygonSoup soup;
  soup.precision.binary_digits = std::numeric_limits<float>::digits;
  PointTable table(soup.points);
  soup.corners.reserve(3 * facets);
  soup.first_corner.reserve(facets + 1);
  for (std::uint64_t i = 0; i < facets; ++i) {
    const std::size_t begin = kHeaderBytes + kFacetBytes * i;
    const auto fail = [&](const std::string& what) {
      throw BadInput(std::string(name) + ": facet " + std::to_string(i) + " (byte " +
                     std::to_string(begin) + ") " + what);
    };
    std::size_t offset = begin + kFirstCornerOffset;
    for (int corner = 0; corner < 3; ++corner) {
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis, offset += sizeof(float)) {
        point[axis] = stored_number<float>(bytes, offset, ByteOrder::LittleEndian);
        if (!std::isfinite(point[axis])) fail("has a coordinate that is not a finite number");
      }
      soup.corners.push_back(table.find_or_add(point));
    }
    if (soup.points.size() > mesh_limits::kMaxPoints) {
      fail("takes the file over the limit of " + std::to_string(mesh_limits::kMaxPoints) +
           " vertices");
    }
    const std::string fault = close_face(soup);
    if (!fault.empty()) fail(fault);
  }
  return soup;
}

PolygonSoup parse_stl(std::string_view bytes, std::string_view name) {
  if (bytes.empty()) throw BadInput(std::string(name) + ": the file is empty");
  if (has_size_of_binary_stl(bytes)) return parse_binary_stl(bytes, name);
  // A NUL byte this early is the padding of a binary header, and the file a damaged binary one.
  const bool looks_binary = bytes.substr(0, kHeaderBytes).find('\0') != std::string_view::npos;
  TextCursor start(bytes, name, {.comment = '\0'});
  if (!looks_binary && equals_ignoring_case(start.next_word_of_any_line(), "solid")) {
    return parse_text_stl(bytes, name);
  }
  std::string message(name);
  message += ": the file is neither text STL (it does not begin with \"solid\") nor binary STL (";
  if (bytes.size() < kHeaderBytes) {
    message += "its " + std::to_string(bytes.size()) + " bytes are less than a header)";
  } else {
    const std::uint64_t facets = claimed_facets(bytes);
    message += "its header claims " + std::to_string(facets) + " facets, which take " +
               std::to_string(kHeaderBytes + kFacetBytes * facets) + " bytes; the file has " +
               std::to_string(bytes.size()) + ", room for " +
               std::to_string((bytes.size() - kHeaderBytes) / kFacetBytes) + " facets)";
  }
  throw BadInput(message);
}

}  // namespace spoctree
