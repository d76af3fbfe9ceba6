#include "server/mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "common/base/ascii_case.hpp"
#include "common/base/parse_number.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

std::optional<PlyScalar> scalar_named(const std::string& name) {
  using enum PlyScalar;
  static constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> kNames = {{
      {"char", Int8},
      {"int8", Int8},
      {"uchar", UInt8},
      {"uint8", UInt8},
      {"short", Int16},
      {"int16", Int16},
      {"ushort", UInt16},
      {"uint16", UInt16},
      {"int", Int32},
      {"int32", Int32},
      {"uint", UInt32},
      {"uint32", UInt32},
      {"float", Float32},
      {"float32", Float32},
      {"double", Float64},
      {"float64", Float64},
  }};
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  return std::nullopt;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view bytes, std::string_view name)
      : size_bytes_(bytes.size()),
        cursor_(bytes.substr(0, mesh_limits::kMaxPlyHeaderBytes), name, {.comments = ""}) {}

  PlyHeader read() {
    if (!cursor_.next_line()) cursor_.fail("the file is empty");
    const std::string_view magic = cursor_.next_word();
    if (!equals_in_any_case(magic, "ply")) cursor_.fail("expected ply, found " + quoted(magic));
    end_line();
    read_format();
    for (;;) {
      const std::string keyword = next_statement();
      if (keyword == "end_header") break;
      if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        cursor_.fail("unknown PLY header line " + quoted(keyword));
      }
    }
    header_.body_offset = cursor_.step_over_line_end();
    header_.body_line = cursor_.line();
    check_size();
    return std::move(header_);
  }

 private:
  // The first word of the next header line that means something. Words may be in capitals.
  std::string next_statement() {
    while (cursor_.next_line()) {
      std::string keyword = to_lower_case(cursor_.next_word());
      if (keyword != "comment" && keyword != "obj_info") return keyword;
    }
    cursor_.fail(size_bytes_ > mesh_limits::kMaxPlyHeaderBytes
                     ? "no end_header in the first " +
                           std::to_string(mesh_limits::kMaxPlyHeaderBytes) + " bytes"
                     : "the file ends before end_header");
  }

  std::string word(const char* what) {
    const std::string_view found = cursor_.next_word();
    if (found.empty()) cursor_.fail(std::string("the line ends before the ") + what);
    return to_lower_case(found);
  }

  void end_line() {
    const std::string_view found = cursor_.next_word();
    if (!found.empty()) cursor_.fail("unexpected " + quoted(found) + " at the end of the line");
  }

  void read_format() {
    if (const auto keyword = next_statement(); keyword != "format") {
      cursor_.fail("expected format, found " + quoted(keyword));
    }
    const std::string encoding = word("format");
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::BinaryLittleEndian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::BinaryBigEndian;
    } else {
      cursor_.fail("unknown PLY format " + quoted(encoding));
    }
    const std::string version = word("version");
    if (version != "1.0") cursor_.fail("PLY version " + quoted(version) + " is not 1.0");
    end_line();
  }

  void read_element() {
    PlyElement element;
    element.name = word("element's name");
    const std::string count = word("element's count");
    const ParsedInteger parsed = parse_integer(count);
    if (parsed.fault != nullptr || parsed.value < 0) {
      cursor_.fail("the count " + quoted(count) + " " +
                   (parsed.fault != nullptr ? parsed.fault : "is negative"));
    }
    element.count = static_cast<std::uint64_t>(parsed.value);
    end_line();
    if (header_.find(element.name) != nullptr) {
      cursor_.fail("a second element " + quoted(element.name));
    }
    if (header_.elements.size() == mesh_limits::kMaxPlyElements) {
      cursor_.fail("more than " + std::to_string(mesh_limits::kMaxPlyElements) + " elements");
    }
    header_.elements.push_back(std::move(element));
  }

  PlyScalar scalar(const char* what) {
    const std::string name = word(what);
    const auto type = scalar_named(name);
    if (!type) cursor_.fail("unknown PLY type " + quoted(name));
    return *type;
  }

  void read_property() {
    if (header_.elements.empty()) cursor_.fail("a property before the first element");
    PlyProperty property;
    const std::string first = word("property's type");
    if (first == "list") {
      property.is_list = true;
      property.count_type = scalar("type of the list's length");
      if (!is_integer(property.count_type)) cursor_.fail("the length of a list is an integer");
      property.type = scalar("type of the list's items");
    } else if (const auto type = scalar_named(first)) {
      property.type = *type;
    } else {
      cursor_.fail("unknown PLY type " + quoted(first));
    }
    property.name = word("property's name");
    end_line();
    auto& siblings = header_.elements.back().properties;
    if (std::any_of(siblings.begin(), siblings.end(),
                    [&](const PlyProperty& other) { return other.name == property.name; })) {
      cursor_.fail("a second property " + quoted(property.name) + " of one element");
    }
    if (++properties_ > mesh_limits::kMaxPlyProperties) {
      cursor_.fail("more than " + std::to_string(mesh_limits::kMaxPlyProperties) + " properties");
    }
    siblings.push_back(std::move(property));
  }

  // The least that one row takes. In text a digit and a blank or line end for each value, and the
  // last line of the file may lack its end.
  std::uint64_t min_row_bytes(const PlyElement& element) const {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      bytes += header_.encoding == PlyEncoding::Ascii
                   ? 2
                   : byte_size(property.is_list ? property.count_type : property.type);
    }
    return bytes;
  }

  void check_size() const {
    std::uint64_t left = size_bytes_ - header_.body_offset;
    if (header_.encoding == PlyEncoding::Ascii) ++left;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      const std::uint64_t row = min_row_bytes(element);
      if (element.count > left / row) {
        cursor_.fail("the header claims " + std::to_string(element.count) + " of the element " +
                     quoted(element.name) + ", more than a file of " + std::to_string(size_bytes_) +
                     " bytes can hold");
      }
      left -= element.count * row;
    }
  }

  std::size_t size_bytes_;
  TextCursor cursor_;
  PlyHeader header_;
  std::size_t properties_ = 0;
};

}  // namespace

std::size_t byte_size(PlyScalar type) {
  switch (type) {
    case PlyScalar::Int8:
    case PlyScalar::UInt8:
      return 1;
    case PlyScalar::Int16:
    case PlyScalar::UInt16:
      return 2;
    case PlyScalar::Int32:
    case PlyScalar::UInt32:
    case PlyScalar::Float32:
      return 4;
    case PlyScalar::Float64:
      break;
  }
  return 8;
}

bool is_integer(PlyScalar type) { return type < PlyScalar::Float32; }

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& e) { return e.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader parse_ply_header(std::string_view bytes, std::string_view name) {
  return PlyHeaderReader(bytes, name).read();
}

}  // namespace spoctree
