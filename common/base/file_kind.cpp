#include "common/base/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "common/base/ascii_case.hpp"
#include "common/base/parse_number.hpp"

namespace spoctree {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t kMostLookedAt = 4096;

constexpr const char* kExport = "export it as an STL, OBJ, OFF or PLY mesh";
constexpr const char* kConvert = "convert it to STL, OBJ, OFF or PLY";
constexpr const char* kUnpack = "unpack it first";
constexpr const char* kNoMesh = "";

/// A format that begins with certain bytes.
struct Mark {
  std::string_view bytes;
  const char* name;
  const char* hint;
};

// Of marks with a common beginning the longer one is first.
constexpr Mark kMarks[] = {
    {"glTF"sv, "a glTF binary file (GLB)", kConvert},
    {"\x1f\x8b"sv, "a gzip archive", kUnpack},
    {"BZh"sv, "a bzip2 archive", kUnpack},
    {"\xfd"
     "7zXZ\0"sv,
     "an xz archive", kUnpack},
    {"\x28\xb5\x2f\xfd"sv, "a zstd archive", kUnpack},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive", kUnpack},
    {"Rar!\x1a\x07"sv, "a RAR archive", kUnpack},
    {"%PDF-"sv, "a PDF document", kNoMesh},
    {"%!PS"sv, "a PostScript document", kNoMesh},
    {"\x89PNG\r\n"sv, "a PNG picture", kNoMesh},
    {"\xff\xd8\xff"sv, "a JPEG picture", kNoMesh},
    {"GIF87a"sv, "a GIF picture", kNoMesh},
    {"GIF89a"sv, "a GIF picture", kNoMesh},
    {"II*\0"sv, "a TIFF picture", kNoMesh},
    {"MM\0*"sv, "a TIFF picture", kNoMesh},
    {"Kaydara FBX Binary"sv, "an FBX file", kConvert},
    {"; FBX "sv, "an FBX file", kConvert},
    {"BLENDER"sv, "a Blender file", kExport},
    {"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h"sv, "a SketchUp file", kExport},
    {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, "an OLE file (of SolidWorks, Inventor or an office)",
     kExport},
    {"3D Geometry File Format"sv, "a Rhino file (3DM)", kExport},
    {"AutoCAD Binary DXF"sv, "a DXF file", kExport},
    {"AC10"sv, "a DWG file", kExport},
    {"DBRep_DrawableShape"sv, "an OpenCASCADE file (BREP)", kExport},
    {"CASCADE Topology"sv, "an OpenCASCADE file (BREP)", kExport},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, "a Parasolid file", kExport},
    {"#VRML"sv, "a VRML file", kConvert},
    {"#X3D"sv, "an X3D file", kConvert},
    {"#usda"sv, "a USD file", kConvert},
    {"PXR-USDC"sv, "a USD file", kConvert},
    {"# vtk DataFile"sv, "a VTK file", kConvert},
    {"$MeshFormat"sv, "a Gmsh file", kConvert},
    {"OCTM"sv, "an OpenCTM file", kConvert},
    {"DRACO"sv, "a Draco file", kConvert},
    {"\x7f"
     "ELF"sv,
     "a program (ELF)", kNoMesh},
    {"version https://git-lfs.github.com/spec/"sv, "a Git LFS pointer, not the file itself",
     "fetch that with git lfs pull"},
};

/// A document whose first tag it is, or one of the first.
struct Tag {
  std::string_view word;  // in lower case
  const char* name;
  const char* hint;
};
constexpr Tag kTags[] = {
    {"<!doctype html", "an HTML page", "perhaps it came in place of the file that was asked for"},
    {"<html", "an HTML page", "perhaps it came in place of the file that was asked for"},
    {"<collada", "a COLLADA file", kConvert},
    {"<x3d", "an X3D file", kConvert},
    {"<amf", "an AMF file", kConvert},
    {"<vtkfile", "a VTK file", kConvert},
    {"<svg", "an SVG drawing", kNoMesh},
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\v\f");
  return begin == text.npos ? std::string_view() : text.substr(begin);
}

std::string_view line_at(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return number;
}

FileKind mesh_kind(const char* name, std::string_view extension) {
  return {name, "", true, extension};
}

std::optional<FileKind> find_utf16(std::string_view head) {
  const FileKind kind{"UTF-16 text", "save it as plain text (UTF-8)"};
  if (head.starts_with("\xff\xfe\0\0"sv) || head.starts_with("\0\0\xfe\xff"sv))
    return FileKind{"UTF-32 text", "save it as plain text (UTF-8)"};
  if (head.starts_with("\xff\xfe"sv) || head.starts_with("\xfe\xff"sv)) return kind;
  // Without a byte order mark: printable ASCII in every second byte, NUL in all others.
  constexpr std::size_t kPairs = 8;
  if (head.size() < 2 * kPairs) return std::nullopt;
  for (const std::size_t zero : {std::size_t{0}, std::size_t{1}}) {
    bool is_text = true;
    for (std::size_t i = 0; i < kPairs; ++i) {
      const char c = head[2 * i + 1 - zero];
      const bool is_printable = (c >= ' ' && c < '\x7f') || c == '\r' || c == '\n' || c == '\t';
      is_text = is_text && head[2 * i + zero] == '\0' && is_printable;
    }
    if (is_text) return kind;
  }
  return std::nullopt;
}

std::optional<FileKind> find_zip(std::string_view bytes) {
  if (!bytes.starts_with("PK\x03\x04"sv) && !bytes.starts_with("PK\x05\x06"sv)) return std::nullopt;
  const auto has = [bytes](std::string_view name) { return bytes.find(name) != bytes.npos; };
  if (has("3D/3dmodel.model") || has("/3dmodel.model")) return FileKind{"a 3MF file", kExport};
  if (has("Document.xml") && has("GuiDocument.xml")) return FileKind{"a FreeCAD file", kExport};
  return FileKind{"a zip archive", kUnpack};
}

// The 73rd column of an IGES file names the section that a line is of.
bool is_iges(std::string_view head) {
  const std::string_view line = line_at(head, 0);
  if (line.size() != 80 || line[72] != 'S') return false;
  return without_blanks(line.substr(73)).find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<FileKind> find_markup(std::string_view text) {
  if (!text.starts_with('<')) return std::nullopt;
  for (const Tag& tag : kTags) {
    const bool is_xml = starts_in_any_case(text, "<?xml") || text.starts_with("<!--");
    if (starts_in_any_case(text, tag.word) || (is_xml && contains_in_any_case(text, tag.word)))
      return FileKind{tag.name, tag.hint};
  }
  if (starts_in_any_case(text, "<?xml")) return FileKind{"an XML file", kNoMesh};
  return std::nullopt;
}

std::optional<FileKind> find_json(std::string_view text) {
  if (!text.starts_with('{')) return std::nullopt;
  const std::string_view next = without_blanks(text.substr(1));
  if (!next.starts_with('"') && !next.starts_with('}')) return std::nullopt;
  constexpr std::array kOfGltf = {"\"asset\""sv, "\"accessors\""sv, "\"bufferViews\""sv,
                                  "\"buffers\""sv};
  const bool is_gltf = std::any_of(kOfGltf.begin(), kOfGltf.end(), [text](std::string_view name) {
    return text.find(name) != text.npos;
  });
  return is_gltf ? FileKind{"a glTF file", kConvert} : FileKind{"a JSON file", kNoMesh};
}

bool is_dxf(std::string_view text) {
  if (line_at(text, 0) != "0" && !text.starts_with("999")) return false;
  return text.substr(0, 200).find("SECTION") != std::string_view::npos;
}

// The first lines are statements of OBJ, and one of them is a vertex.
std::optional<FileKind> find_obj(std::string_view text) {
  constexpr std::array kStatements = {"v"sv, "vn"sv,     "vt"sv,     "vp"sv, "f"sv, "g"sv,
                                      "o"sv, "mtllib"sv, "usemtl"sv, "s"sv,  "l"sv, "newmtl"sv};
  bool has_vertex = false;
  std::size_t begin = 0;
  for (int lines = 0; lines < 20 && begin < text.size(); ++lines) {
    const std::string_view line = without_blanks(line_at(text, begin));
    begin = text.find_first_of("\r\n", begin);
    begin = begin == text.npos ? text.size() : begin + 1;
    if (line.empty() || line.starts_with('#')) continue;
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    if (word == "newmtl") return FileKind{"a file of OBJ materials (MTL)", kNoMesh};
    if (std::find(kStatements.begin(), kStatements.end(), word) == kStatements.end())
      return std::nullopt;
    has_vertex = has_vertex || word == "v";
  }
  if (!has_vertex) return std::nullopt;
  return mesh_kind("an OBJ mesh", ".obj");
}

bool is_off_keyword(std::string_view word) {
  const std::size_t off = word.find("OFF");
  return off != word.npos && off <= 5 && word.find_first_not_of("STCN4n") >= off &&
         word.substr(off + 3).find_first_not_of("0123456789") == word.npos;
}

std::optional<FileKind> find_text(std::string_view text) {
  if (text.starts_with("ISO-10303-21") || text.starts_with("ISO10303-21"))
    return FileKind{"a STEP file", kExport};
  if (is_dxf(text)) return FileKind{"a DXF file", kExport};
  for (const auto find : {find_markup, find_json, find_obj}) {
    if (auto kind = find(text)) return kind;
  }
  std::string_view statement = text;
  while (statement.starts_with('#')) {
    statement = without_blanks(statement.substr(line_at(statement, 0).size()));
  }
  const std::string_view word = statement.substr(0, statement.find_first_of(" \t\r\n"));
  if (equals_in_any_case(word, "solid")) return mesh_kind("an STL mesh", ".stl");
  if (equals_in_any_case(word, "ply")) return mesh_kind("a PLY mesh", ".ply");
  if (is_off_keyword(word)) return mesh_kind("an OFF mesh", ".off");
  return std::nullopt;
}

// Facets of 50 bytes after a header of 84, which ends with their number.
bool has_size_of_facets(std::string_view bytes) {
  return bytes.size() >= 134 && bytes.size() - 84 == std::uint64_t{50} * number_at(bytes, 80);
}

}  // namespace

std::optional<FileKind> find_file_kind(std::string_view bytes) {
  if (has_size_of_facets(bytes)) return mesh_kind("an STL mesh", ".stl");
  const std::string_view head = bytes.substr(0, kMostLookedAt);
  for (const Mark& mark : kMarks) {
    if (head.starts_with(mark.bytes)) return FileKind{mark.name, mark.hint};
  }
  if (head.starts_with("SPO") && head.size() > 3 && head[3] > 0 && head[3] < ' ')
    return FileKind{"a .spo file", "it is built already", false, ".spo"};
  if (head.starts_with("RIFF") && head.substr(8, 4) == "WEBP")
    return FileKind{"a WebP picture", kNoMesh};
  if (head.size() > 262 && head.substr(257, 5) == "ustar")
    return FileKind{"a tar archive", kUnpack};
  if (head.starts_with("MM") && bytes.size() >= 6 && number_at(bytes, 2) == bytes.size())
    return FileKind{"a 3DS file", kConvert};
  if (head.starts_with("BM") && bytes.size() >= 54 && number_at(bytes, 2) == bytes.size())
    return FileKind{"a BMP picture", kNoMesh};
  if (auto kind = find_zip(bytes)) return kind;
  if (auto kind = find_utf16(head)) return kind;
  if (is_iges(head)) return FileKind{"an IGES file", kExport};
  const std::string_view text = head.starts_with("\xef\xbb\xbf") ? head.substr(3) : head;
  return find_text(without_blanks(text));
}

}  // namespace spoctree
