#include "server/mesh/parse_obj.hpp"

#include <string>

#include "common/base/parse_number.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::string_view name)
      : cursor_(bytes, name, {.backslash_joins_lines = true}) {}

  PolygonSoup read() {
    while (cursor_.next_line()) {
      const std::string_view keyword = cursor_.next_word();
      if (keyword == "v" || keyword == "V") read_vertex();
      if (is_face(keyword)) read_face();
    }
    if (highest_index_ > soup_.points.size()) {
      fail_outside(highest_index_line_, std::to_string(highest_index_));
    }
    if (soup_.face_count() + soup_.collapsed.count == 0) cursor_.fail("the file has no faces");
    soup_.precision = digits_.precision();
    return std::move(soup_);
  }

 private:
  // "fo" is what it was called when a face was an outline.
  static bool is_face(std::string_view word) {
    return word == "f" || word == "F" || word == "fo" || word == "FO";
  }

  void read_vertex() {
    const Item vertex{"vertex", soup_.points.size() + 1};
    if (soup_.points.size() == mesh_limits::kMaxPoints) {
      cursor_.fail("the file has more than " + std::to_string(mesh_limits::kMaxPoints) +
                   " vertices");
    }
    glm::dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = cursor_.read_coordinate(vertex, axis, digits_);
    }
    soup_.points.push_back(point);
  }

  void read_face() {
    const std::size_t line = cursor_.line();
    for (std::string_view word; !(word = cursor_.next_word()).empty();) {
      soup_.corners.push_back(vertex_of_corner(word));
    }
    const std::size_t corners = soup_.corners.size() - soup_.first_corner.back();
    if (corners < 3 && corners > 0 && cursor_.rest().empty()) {
      cursor_.fail_at(line, "the face has " + std::to_string(corners) +
                                (corners == 1 ? " corner" : " corners") +
                                ", and the file ends with it: it has been cut off");
    }
    const std::string fault = close_face(soup_, 1);
    if (!fault.empty()) cursor_.fail_at(line, "the face " + fault);
  }

  // "7", "7/1", "7//2" and "7/1/2", counted from 1, into 6.
  std::uint32_t vertex_of_corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    const std::string_view first = word.substr(0, slash);
    const ParsedInteger index = parse_integer(first);
    if (index.fault != nullptr || !has_valid_attributes(word, slash)) {
      cursor_.fail("the face corner " + quoted(word) +
                   " is not of the form v, v/vt, v//vn or v/vt/vn");
    }
    const auto known = static_cast<std::int64_t>(soup_.points.size());
    const std::int64_t absolute = index.value < 0 ? known + index.value + 1 : index.value;
    if (absolute < 1 || absolute > static_cast<std::int64_t>(mesh_limits::kMaxPoints)) {
      fail_outside(cursor_.line(), std::string(first));
    }
    const auto number = static_cast<std::uint32_t>(absolute);
    // The vertex may come later; whether it came is known at the end of the file.
    if (number > highest_index_) {
      highest_index_ = number;
      highest_index_line_ = cursor_.line();
    }
    return number - 1;
  }

  // Texture and normal numbers are not used, but "1/x" is more likely damage than decoration.
  static bool has_valid_attributes(std::string_view word, std::size_t slash) {
    for (int attribute = 0; slash != std::string_view::npos; ++attribute) {
      word.remove_prefix(slash + 1);
      slash = word.find('/');
      const std::string_view number = word.substr(0, slash);
      if (attribute == 2 || (!number.empty() && parse_integer(number).fault != nullptr)) {
        return false;
      }
    }
    return true;
  }

  [[noreturn]] void fail_outside(std::size_t line, const std::string& index) const {
    cursor_.fail_at(line, "the face uses vertex " + index + ", the file has " +
                              std::to_string(soup_.points.size()) + " vertices" +
                              (index.starts_with('-') ? " up to this line" : ""));
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  DigitRecord digits_;
  std::uint32_t highest_index_ = 0;
  std::size_t highest_index_line_ = 0;
};

}  // namespace

PolygonSoup parse_obj(std::string_view bytes, std::string_view name) {
  return ObjReader(bytes, name).read();
}

}  // namespace spoctree
