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
#include "common/base/file_kind.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/merge_equal_points.hpp"
#include "server/mesh/parse_binary_stl.hpp"
#include "server/mesh/parse_obj.hpp"
#include "server/mesh/parse_off.hpp"
#include "server/mesh/parse_ply.hpp"
#include "server/mesh/parse_stl.hpp"

namespace spoctree {

namespace {

std::string_view extension_of(MeshFormat format) {
  static constexpr std::array<std::string_view, 4> kExtensions = {".off", ".obj", ".stl", ".ply"};
  return kExtensions[static_cast<std::size_t>(format)];
}

// Behind a NUL byte in its header comes what a binary STL file has there.
bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t kHeaderBytes = 84;
  return bytes.substr(0, kHeaderBytes).find('\0') != bytes.npos && looks_like_binary_stl(bytes);
}

// Says what it is: "part.obj: is a STEP file: export it as ...".
[[noreturn]] void fail_as(const FileKind& kind, std::string_view name) {
  std::string message = std::string(name) + ": is " + kind.name;
  if (kind.is_mesh) {
    message.append(": its name should end in ").append(kind.extension);
  } else if (!kind.hint.empty()) {
    message.append(": ").append(kind.hint);
  } else {
    message += ", not a mesh";
  }
  throw BadInput(message);
}

// OBJ files, and OFF files without a keyword, need have no mark of their own.
void reject_other_kinds(MeshFormat format, std::string_view bytes, std::string_view name) {
  std::optional<FileKind> kind = find_file_kind(bytes);
  if (!kind && format != MeshFormat::Stl && is_binary_stl(bytes))
    kind = FileKind{"an STL mesh", "", true, ".stl"};
  if (kind && kind->extension != extension_of(format)) fail_as(*kind, name);
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

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open_file(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw BadInput(path.string() + ": cannot open: " + std::strerror(errno));
  return file;
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
  const File file = open_file(path);
  std::string bytes(size, '\0');
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail("cannot read");
  return bytes;
}

// Of a file that will not be read: what shows its kind.
[[noreturn]] void reject_extension(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::string bytes(mesh_limits::kMaxBytesForKind, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), open_file(path).get()));
  const auto kind = find_file_kind(bytes);
  if (kind && !kind->is_mesh) fail_as(*kind, name);
  std::string message = name + ": unknown mesh format (the name should end in ";
  if (kind)
    throw BadInput(message.append(kind->extension).append(": it is ").append(kind->name) + ")");
  throw BadInput(message + ".off, .obj, .stl or .ply)");
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

// Polygons that are none because they have a point twice, though under different numbers: found by
// merging.
void reject_pinched_faces(const PolygonSoup& soup, std::string_view name) {
  std::size_t count = 0;
  glm::dvec3 first{};
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    if (soup.face(i).size() == 3) continue;
    const auto vertex = wrongly_repeated_vertex(soup.face(i));
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
  reject_other_kinds(format, bytes, name);
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
  if (!format) reject_extension(path);
  try {
    return parse_mesh(*format, read_whole_file(path), name);
  } catch (const std::bad_alloc&) {
    throw BadInput(name + ": not enough memory to read the file");
  }
}

}  // namespace spoctree
