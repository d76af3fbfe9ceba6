// Kinds of files by their first bytes, as their programs write them.
#include "common/base/file_kind.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

using namespace std::string_literals;

std::string name_of(const std::string& bytes) {
  const auto kind = find_file_kind(bytes);
  return kind ? kind->name : "";
}

std::string utf16(const std::string& text, bool is_big_endian) {
  std::string wide;
  for (const char c : text) wide += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return wide;
}

// The local header of a file in a zip archive (APPNOTE.TXT, 4.3.7), without its data.
std::string zip_with(const std::string& name) {
  std::string bytes = "PK\x03\x04"s + std::string(22, '\0');
  bytes += static_cast<char>(name.size());
  return bytes + std::string(3, '\0') + name;
}

TEST(FileKind, IsKnownByTheFirstBytes) {
  const std::pair<std::string, std::string> cases[] = {
      {"ISO-10303-21;\nHEADER;\n", "a STEP file"},
      {"\xef\xbb\xbf\r\n ISO-10303-21;\r\nHEADER;\r\n", "a STEP file"},
      {std::string(72, ' ') + "S      1\n", "an IGES file"},
      {"{\"asset\":{\"version\":\"2.0\"}}", "a glTF file"},
      {"{\n  \"scene\": 0, \"accessors\": []}", "a glTF file"},
      {"{ \"a\": 1 }", "a JSON file"},
      {"glTF\x02\0\0\0"s, "a glTF binary file (GLB)"},
      {zip_with("3D/3dmodel.model"), "a 3MF file"},
      {zip_with("[Content_Types].xml") + zip_with("3D/3dmodel.model"), "a 3MF file"},
      {zip_with("part.stl"), "a zip archive"},
      {"PK\x05\x06"s + std::string(18, '\0'), "a zip archive"},
      {"\x1f\x8b\x08\0\0"s, "a gzip archive"},
      {"BZh91AY&SY", "a bzip2 archive"},
      {"\xfd"
       "7zXZ\0\0"s,
       "an xz archive"},
      {"\xff\xfe"s + utf16("solid a", false), "UTF-16 text"},
      {"\xfe\xff"s + utf16("solid a", true), "UTF-16 text"},
      {utf16("solid name of it", false), "UTF-16 text"},
      {utf16("v 0 0 0\r\nv 1 0 0", true), "UTF-16 text"},
      {"<!DOCTYPE html>\n<html>", "an HTML page"},
      {"\n<HTML><head>", "an HTML page"},
      {"<?xml version=\"1.0\"?>\n<!DOCTYPE html PUBLIC \"\">", "an HTML page"},
      {"<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">", "a COLLADA file"},
      {"<?xml version=\"1.0\"?>\n<amf unit=\"inch\">", "an AMF file"},
      {"<?xml version=\"1.0\"?>\n<note/>", "an XML file"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n",
       "a Git LFS pointer, not the file itself"},
      {"%PDF-1.7\n", "a PDF document"},
      {"\x89PNG\r\n\x1a\n", "a PNG picture"},
      {"\xff\xd8\xff\xe0", "a JPEG picture"},
      {"#VRML V2.0 utf8\n", "a VRML file"},
      {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "a DXF file"},
      {"Kaydara FBX Binary  \0"s, "an FBX file"},
      {"# vtk DataFile Version 3.0\n", "a VTK file"},
      {"newmtl red\nKd 1 0 0\n", "a file of OBJ materials (MTL)"},
      {"solid part\nfacet normal", "an STL mesh"},
      {"# by me\nSOLID part\n", "an STL mesh"},
      {std::string(80, ' ') + "\1\0\0\0"s + std::string(50, '\0'), "an STL mesh"},
      {"ply\nformat ascii 1.0\n", "a PLY mesh"},
      {"# c\nSTCN4OFF\n1 1 0\n", "an OFF mesh"},
      {"OFF8 6 12\n", "an OFF mesh"},
      {"# Blender\nmtllib a.mtl\no Cube\nv 1 1 1\n", "an OBJ mesh"},
      {"SPO\x01\x10\0\0\0"s, "a .spo file"},
  };
  for (const auto& [bytes, name] : cases) EXPECT_EQ(name_of(bytes), name) << bytes;
}

TEST(FileKind, IsLeftOpenWhereNothingSaysIt) {
  for (const char* bytes : {"", " ", "\n", "hello", "8 6 12\n0 0 0\n", "# v 0 0 0\n", "vertex", "<",
                            "{", "f 1 2 3\n", "solids are these", "OFFICE", "P", "0\n"}) {
    EXPECT_EQ(name_of(bytes), "") << bytes;
  }
}

TEST(FileKind, IsFoundInAnyBeginningWithoutHarm) {
  for (const std::string& bytes :
       {std::string(200, '#'), std::string(5000, '<'), std::string(5000, '\n'),
        zip_with("3D/3dmodel.model"), "\xff\xfe"s + utf16("solid", false), "{\"asset\""s}) {
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
      const std::string exact = bytes.substr(0, size);
      find_file_kind({exact.data(), exact.size()});
    }
  }
}

}  // namespace
}  // namespace spoctree
