#include "server/mesh/read_mesh.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "common/base/errors.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/merge_equal_points.hpp"
#include "server/mesh/parse_obj.hpp"
#include "server/mesh/parse_off.hpp"
#include "server/mesh/parse_ply.hpp"
#include "server/mesh/parse_stl.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

namespace {

const char* format_name(MeshFormat format) {
  static constexpr std::array kNames = {"OFF", "OBJ", "STL", "PLY"};
  return kNames[static_cast<std::size_t>(format)];
}

// What the content says of itself, if anything: OBJ files, and OFF files without a keyword, have no
// mark of their own.
std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  if (has_size_of_binary_stl(bytes)) return MeshFormat::Stl;
  const std::string_view word = TextCursor(bytes, "").next_word_of_any_line();
  if (word == "ply") return MeshFormat::Ply;
  if (word == "solid") return MeshFormat::Stl;
  if (parse_off_keyword(word)) return MeshFormat::Off;
  return std::nullopt;
}

/// A pipe or a device has no size to hold the file's counts against.
void require_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) throw BadInput(path.string() + ": cannot open: " + error.message());
  if (!std::filesystem::is_regular_file(status)) {
    throw BadInput(path.string() + ": not a regular file");
  }
}

std::string read_whole_file(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& what) { throw BadInput(path.string() + ": " + what); };
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) fail("cannot open: " + error.message());
  if (size > mesh_limits::kMaxFileBytes) {
    fail("the file has " + std::to_string(size) + " bytes, the limit is " +
         std::to_string(mesh_limits::kMaxFileBytes));
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) fail(std::string("cannot open: ") + std::strerror(errno));
  std::string bytes(size, '\0');
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail("cannot read");
  return bytes;
}

PolygonSoup parse_format(MeshFormat format, std::string_view bytes, std::string_view name) {
  switch (format) {
    case MeshFormat::Off:
      return parse_off(bytes, name);
    case MeshFormat::Obj:
      return parse_obj(bytes, name);
    case MeshFormat::Stl:
      return parse_stl(bytes, name);
    case MeshFormat::Ply:
      break;
  }
  return parse_ply(bytes, name);
}

// Polygons with a point twice, though under different numbers, found by merging.
void reject_pinched_faces(const PolygonSoup& soup, std::string_view name) {
  std::size_t count = 0;
  glm::dvec3 first{};
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    if (soup.face(i).size() == 3) continue;
    const auto vertex = repeated_vertex(soup.face(i));
    if (vertex && count++ == 0) first = soup.points[*vertex];
  }
  if (count == 0) return;
  throw BadInput(std::string(name) + ": " + std::to_string(count) +
                 (count == 1 ? " polygon touches itself" : " polygons touch themselves") +
                 ", first at the point (" + std::to_string(first.x) + ", " +
                 std::to_string(first.y) + ", " + std::to_string(first.z) + ")");
}

void reject_soup_without_faces(const PolygonSoup& soup, std::string_view name) {
  if (soup.face_count() > 0) return;
  throw BadInput(std::string(name) + ": all " + std::to_string(soup.collapsed.count) +
                 " faces have fewer than three different corners");
}

}  // namespace

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".off") return MeshFormat::Off;
  if (extension == ".obj") return MeshFormat::Obj;
  if (extension == ".stl") return MeshFormat::Stl;
  if (extension == ".ply") return MeshFormat::Ply;
  return std::nullopt;
}

PolygonSoup parse_mesh(MeshFormat format, std::string_view bytes, std::string_view name) {
  if (bytes.empty()) throw BadInput(std::string(name) + ": the file is empty");
  if (const auto content = format_of_content(bytes); content && *content != format) {
    throw BadInput(std::string(name) + ": the name says " + format_name(format) +
                   ", the content is " + format_name(*content));
  }
  PolygonSoup soup = parse_format(format, bytes, name);
  // STL has merged its corners while reading.
  if (format != MeshFormat::Stl || soup.collapsed.count > 0) merge_equal_points(soup);
  reject_soup_without_faces(soup, name);
  reject_pinched_faces(soup, name);
  return soup;
}

PolygonSoup read_mesh(const std::filesystem::path& path) {
  const std::string name = path.string();
  require_regular_file(path);
  const auto format = format_of_extension(path);
  if (!format) {
    throw BadInput(name +
                   ": unknown mesh format (the name should end in .off, .obj, .stl or .ply)");
  }
  try {
    return parse_mesh(*format, read_whole_file(path), name);
  } catch (const std::bad_alloc&) {
    throw BadInput(name + ": not enough memory to read the file");
  }
}

}  // namespace spoctree
