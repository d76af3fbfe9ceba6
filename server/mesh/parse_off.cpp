#include "server/mesh/parse_off.hpp"

#include <cmath>
#include <string>

#include "common/base/parse_number.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

constexpr std::uint64_t kMinVertexBytes = 6;  // "0 0 0\n"
constexpr std::uint64_t kMinFaceBytes = 8;    // "3 0 1 2\n"

class OffReader {
 public:
  OffReader(std::string_view bytes, std::string_view name)
      : cursor_(bytes, name), size_bytes_(bytes.size()) {}

  PolygonSoup read() {
    read_header();
    soup_.points.reserve(vertices_);
    soup_.first_corner.reserve(faces_ + 1);
    soup_.corners.reserve(3 * faces_);
    for (std::uint64_t i = 0; i < vertices_; ++i) read_vertex({"vertex", i});
    for (std::uint64_t i = 0; i < faces_; ++i) read_face({"face", i});
    // Quotients are not written with any digits.
    if (!homogeneous_) soup_.precision = digits_.precision();
    return std::move(soup_);
  }

 private:
  void read_header() {
    if (!cursor_.next_line()) cursor_.fail("the file is empty");
    std::string_view word = cursor_.next_word();
    if (const auto keyword = parse_off_keyword(word)) {
      homogeneous_ = keyword->homogeneous;
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
    vertices_ = count(first_word, "vertices");
    faces_ = count(cursor_.next_word(), "faces");
    const std::string_view edges = cursor_.next_word();
    if (!edges.empty() && parse_integer(edges).fault != nullptr) {
      cursor_.fail("the number of edges " + quoted(edges) + " is not a whole number");
    }
    if (!cursor_.next_word().empty()) {
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

  void read_vertex(Item vertex) {
    if (!cursor_.next_line()) {
      cursor_.fail("the file ends after " + std::to_string(vertex.number) + " of " +
                   std::to_string(vertices_) + " vertices");
    }
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = cursor_.read_coordinate(vertex, axis, digits_);
    }
    if (homogeneous_) {
      const double w = cursor_.read_real(vertex);
      if (w == 0) cursor_.fail(to_string(vertex) + " is at infinity (its w is 0)");
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] /= w;
        if (!std::isfinite(point[axis])) {
          cursor_.fail(to_string(vertex) + " is not finite after division by its w");
        }
      }
    }
    soup_.points.push_back(point);
  }

  void read_face(Item face) {
    if (!cursor_.next_line()) {
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
  bool homogeneous_ = false;
  PolygonSoup soup_;
  DigitRecord digits_;
};

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<OffKeyword> parse_off_keyword(std::string_view word) {
  OffKeyword keyword;
  take_prefix(word, "ST");
  take_prefix(word, "C");
  take_prefix(word, "N");
  keyword.homogeneous = take_prefix(word, "4");
  keyword.has_dimension = take_prefix(word, "n");
  if (!take_prefix(word, "OFF")) return std::nullopt;
  // Some collections have files that begin "OFF490 518 0"; anything else is another word.
  if (word.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  keyword.rest = word;
  return keyword;
}

PolygonSoup parse_off(std::string_view bytes, std::string_view name) {
  return OffReader(bytes, name).read();
}

}  // namespace spoctree
