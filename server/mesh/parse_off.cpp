#include "server/mesh/parse_off.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/base/ascii_case.hpp"
#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "server/mesh/closed_surface.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

constexpr std::uint64_t kMinVertexBytes = 6;  // "0 0 0\n"
constexpr std::uint64_t kMinFaceBytes = 4;    // "1 0\n"

/// Where the values stand.
struct OffLayout {
  enum class Rows { Lines, AnyLines, AnyLinesToAnEnd };

  bool has_counts_on_a_line = true;
  bool has_edge_count = true;        ///< where the counts are on any lines
  Rows vertices = Rows::Lines;       ///< Lines: one on each, what else is on it is skipped
  std::size_t values_of_vertex = 0;  ///< to be skipped, where vertices are on any lines
  Rows faces = Rows::Lines;          ///< AnyLinesToAnEnd: skipped is what is on the last of them
};

/// What the first reading has found out for the next one.
struct OffFindings {
  OffKeyword keyword;
  bool has_edge_count = false;  ///< on the line of the other counts
  bool has_vertices = false;    ///< the first one, at least, was read
};

class OffReader {
 public:
  OffReader(std::string_view bytes, std::string_view name, const OffLayout& layout)
      : cursor_(bytes, name), size_bytes_(bytes.size()), layout_(layout) {}

  PolygonSoup read() {
    read_header();
    soup_.points.reserve(vertices_);
    soup_.first_corner.reserve(faces_ + 1);
    soup_.corners.reserve(std::min<std::uint64_t>(3 * faces_, size_bytes_ / 2));
    for (std::uint64_t i = 0; i < vertices_; ++i) read_vertex({"vertex", i});
    if (layout_.vertices == Rows::Lines) cursor_.skip_line();
    for (std::uint64_t i = 0; i < faces_; ++i) read_face({"face", i});
    // Quotients are not written with any digits.
    if (!keyword_.homogeneous) soup_.precision = digits_.precision();
    return std::move(soup_);
  }

  OffFindings findings() const { return {keyword_, has_edge_count_, !soup_.points.empty()}; }

 private:
  using Rows = OffLayout::Rows;

  void read_header() {
    if (!cursor_.next_line()) cursor_.fail("the file is empty");
    std::string_view word = cursor_.next_word();
    if (const auto keyword = parse_off_keyword(word)) {
      keyword_ = *keyword;
      word = keyword->rest;
      if (keyword->has_dimension) read_dimension(word);
      if (word.empty()) word = cursor_.next_word();
      if (word == "BINARY") cursor_.fail("binary OFF is not supported, save it as text");
      if (word.empty() && cursor_.next_line()) word = cursor_.next_word();
      if (word.empty()) cursor_.fail("the file ends before its counts of vertices and faces");
    } else if (parse_integer(word).fault != nullptr) {
      cursor_.fail("expected OFF or the number of vertices, found " + quoted(word));
    }
    read_counts(word);
  }

  // Leaves `word` empty: counts stand on the line after the dimension, or behind it.
  void read_dimension(std::string_view& word) {
    if (word.empty() && (word = cursor_.next_word_of_any_line()).empty()) {
      cursor_.fail("the file ends before its dimension");
    }
    const ParsedInteger dimension = parse_integer(word);
    if (dimension.fault != nullptr || dimension.value != 3) {
      cursor_.fail("the dimension is " + quoted(word) + ", only 3 is supported");
    }
    word = {};
  }

  void read_counts(std::string_view first_word) {
    const auto next = [this] {
      return layout_.has_counts_on_a_line ? cursor_.next_word() : cursor_.next_word_of_any_line();
    };
    vertices_ = count(first_word, "vertices");
    faces_ = count(next(), "faces");
    has_edge_count_ = !cursor_.is_at_line_end();
    if (layout_.has_counts_on_a_line || layout_.has_edge_count) {
      const std::string_view edges = next();
      if (!edges.empty() && parse_integer(edges).fault != nullptr) {
        cursor_.fail("the number of edges " + quoted(edges) + " is not a whole number");
      }
    }
    // Else it could make up for a lost value of a vertex.
    const ParsedInteger next_number = parse_integer(cursor_.peek_word());
    if (layout_.vertices != Rows::Lines && !layout_.has_edge_count &&
        next_number.fault == nullptr && next_number.value >= 0) {
      cursor_.fail("the next number may be that of edges, or belong to a vertex");
    }
    if (layout_.vertices == Rows::Lines && !cursor_.is_at_line_end()) {
      cursor_.fail("expected the numbers of vertices, faces and edges, found a fourth number");
    }
    if (vertices_ > mesh_limits::kMaxPoints || faces_ > mesh_limits::kMaxFaces ||
        vertices_ * kMinVertexBytes + faces_ * kMinFaceBytes > size_bytes_ + 1) {
      cursor_.fail("the header claims " + std::to_string(vertices_) + " vertices and " +
                   std::to_string(faces_) + " faces, more than a file of " +
                   std::to_string(size_bytes_) + " bytes can hold");
    }
    if (faces_ == 0) cursor_.fail("the file has no faces");
  }

  std::uint64_t count(std::string_view word, const char* what) const {
    if (word.empty()) cursor_.fail(std::string("the number of ") + what + " is missing");
    const ParsedInteger parsed = parse_integer(word);
    if (parsed.fault != nullptr || parsed.value < 0) {
      cursor_.fail(std::string("the number of ") + what + " " + quoted(word) + " " +
                   (parsed.fault != nullptr ? parsed.fault : "is negative"));
    }
    return static_cast<std::uint64_t>(parsed.value);
  }

  // Goes to where the next row begins; false at the end of the file.
  bool begin_row(Rows rows) {
    if (rows == Rows::Lines) return cursor_.next_line();
    cursor_.go_to_next_word();
    return !cursor_.is_at_line_end();
  }

  void go_to_value(Rows rows) {
    if (rows != Rows::Lines) cursor_.go_to_next_word();
  }

  double read_value(Item vertex) {
    go_to_value(layout_.vertices);
    return cursor_.read_real(vertex);
  }

  void read_vertex(Item vertex) {
    if (!begin_row(layout_.vertices)) {
      cursor_.fail("the file ends after " + std::to_string(vertex.number) + " of " +
                   std::to_string(vertices_) + " vertices");
    }
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      go_to_value(layout_.vertices);
      point[axis] = cursor_.read_coordinate(vertex, axis, digits_);
    }
    if (keyword_.homogeneous) {
      const double w = read_value(vertex);
      if (w == 0) cursor_.fail(to_string(vertex) + " is at infinity (its w is 0)");
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] /= w;
        if (!std::isfinite(point[axis])) {
          cursor_.fail(to_string(vertex) + " is not finite after division by its w");
        }
      }
    }
    for (std::size_t i = 0; i < layout_.values_of_vertex; ++i) read_value(vertex);
    soup_.points.push_back(point);
  }

  void read_face(Item face) {
    if (!begin_row(layout_.faces)) {
      cursor_.fail("the file ends after " + std::to_string(face.number) + " of " +
                   std::to_string(faces_) + " faces (its header claims " +
                   std::to_string(vertices_) + " vertices)");
    }
    const std::string_view word = cursor_.next_word();
    const ParsedInteger corners = parse_integer(word);
    if (corners.fault != nullptr || corners.value < 0) {
      fail_face(face, "begins with " + quoted(word) + ", which is not a number of corners");
    }
    for (std::int64_t i = 0; i < corners.value; ++i) {
      go_to_value(layout_.faces);
      const std::string_view corner = cursor_.next_word();
      if (corner.empty()) {
        fail_face(face, "has a line that ends after " + std::to_string(i) + " of its " +
                            std::to_string(corners.value) + " corners");
      }
      const ParsedInteger index = parse_integer(corner);
      if (index.fault != nullptr) {
        fail_face(face, "uses vertex " + quoted(corner) + ", which " + index.fault);
      }
      if (index.value < 0 || static_cast<std::uint64_t>(index.value) >= vertices_) {
        fail_face(face, "uses vertex " + std::to_string(index.value) + ", the file has " +
                            std::to_string(vertices_) + " vertices");
      }
      soup_.corners.push_back(static_cast<std::uint32_t>(index.value));
    }
    const std::string fault = close_face(soup_);
    if (!fault.empty()) fail_face(face, fault);
    if (layout_.faces == Rows::AnyLinesToAnEnd) cursor_.skip_line();
  }

  // Where the header claims too few vertices, the first vertex left over is read as the first
  // face. Three coordinates never make a face, so that this is where it shows.
  [[noreturn]] void fail_face(Item face, const std::string& what) const {
    std::string message = to_string(face) + " " + what;
    if (face.number == 0) {
      message += " (does the file have more vertices than the " + std::to_string(vertices_) +
                 " that its header claims?)";
    }
    cursor_.fail(message);
  }

  TextCursor cursor_;
  std::uint64_t size_bytes_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  OffLayout layout_;
  OffKeyword keyword_;
  bool has_edge_count_ = false;
  PolygonSoup soup_;
  DigitRecord digits_;
};

// How many values to skip behind the coordinates of a vertex.
std::vector<std::size_t> possible_values_of_vertex(const OffKeyword& keyword) {
  const std::size_t others =
      (keyword.has_normals ? std::size_t{3} : 0) + (keyword.has_texture ? std::size_t{2} : 0);
  if (!keyword.has_colours) return {others};
  return {others + 4, others + 3};
}

// The layouts that are no line for each row, the likely ones first.
std::vector<OffLayout> free_layouts(const OffFindings& findings) {
  using enum OffLayout::Rows;
  std::vector<OffLayout> layouts;
  for (const bool has_edge_count : {true, false}) {
    if (!has_edge_count && findings.has_edge_count) continue;
    for (const auto faces : {AnyLines, AnyLinesToAnEnd}) {
      for (const std::size_t values : possible_values_of_vertex(findings.keyword))
        layouts.push_back({false, has_edge_count, AnyLines, values, faces});
      layouts.push_back({false, has_edge_count, Lines, 0, faces});
    }
  }
  return layouts;
}

// Any layout may be found in a damaged file by taking values for others, which only the faces tell.
std::optional<PolygonSoup> read_freely(std::string_view bytes, std::string_view name,
                                       const OffFindings& findings, bool& is_read) {
  for (const OffLayout& layout : free_layouts(findings)) {
    try {
      PolygonSoup soup = OffReader(bytes, name, layout).read();
      is_read = true;
      if (is_closed_surface(soup)) return soup;
    } catch (const BadInput&) {
    }
  }
  return std::nullopt;
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<OffKeyword> parse_off_keyword(std::string_view word) {
  OffKeyword keyword;
  std::string capitals;
  if (word.starts_with("off") || word.starts_with("st") || word.starts_with("c") ||
      word.starts_with("noff") || word.starts_with("4off")) {
    for (const char c : word) capitals += to_upper_case(c);
  }
  std::string_view left = capitals.empty() ? word : capitals;
  keyword.has_texture = take_prefix(left, "ST");
  keyword.has_colours = take_prefix(left, "C");
  keyword.has_normals = take_prefix(left, "N");
  keyword.homogeneous = take_prefix(left, "4");
  keyword.has_dimension = take_prefix(left, "n");
  if (!take_prefix(left, "OFF")) return std::nullopt;
  // Some collections have files that begin "OFF490 518 0"; anything else is another word.
  if (left.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  keyword.rest = word.substr(word.size() - left.size());
  return keyword;
}

PolygonSoup parse_off(std::string_view bytes, std::string_view name) {
  OffReader by_lines(bytes, name, {});
  try {
    return by_lines.read();
  } catch (const BadInput& error) {
    bool is_read = false;
    if (auto soup = read_freely(bytes, name, by_lines.findings(), is_read)) return std::move(*soup);
    if (!is_read || by_lines.findings().has_vertices) throw;
    throw BadInput(std::string(error.what()) +
                   " (and read without regard to lines, its faces do not close)");
  }
}

}  // namespace spoctree
