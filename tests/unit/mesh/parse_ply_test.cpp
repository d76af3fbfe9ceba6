#include "server/mesh/parse_ply.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "server/mesh/limits.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

PolygonSoup parse(std::string_view bytes) { return parse_ply(bytes, "part.ply"); }
std::string error(std::string_view bytes) {
  return error_of([&] { parse(bytes); });
}
void expect_tetrahedron(std::string_view bytes) {
  const PolygonSoup soup = parse(bytes);
  EXPECT_EQ(soup.points, kTetrahedronPoints);
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
}

const std::string kVertexElement =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaceElement = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kHeader = kAscii + kVertexElement + kFaceElement + "end_header\n";  // 9 lines
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(ReadPly, ReadsText) { expect_tetrahedron(kTetrahedronTextPly); }

TEST(ReadPly, ReadsBinaryOfBothByteOrders) {
  expect_tetrahedron(tetrahedron_binary_ply(ByteOrder::LittleEndian));
  expect_tetrahedron(tetrahedron_binary_ply(ByteOrder::BigEndian));
}

TEST(ReadPly, ReadsTextInFullPrecision) {
  const PolygonSoup soup = parse(kHeader + "0.1 0 0\n1 0 0\n0 1 0\n0 0 1\n" + kFaces);
  EXPECT_EQ(soup.points[0].x, 0.1);
}

TEST(ReadPly, SkipsCommentsInTheHeader) {
  expect_tetrahedron(kAscii + "comment element vertex 9\nobj_info whatever\n" + kVertexElement +
                     "comment\n" + kFaceElement + "end_header\n" + kPoints + kFaces);
}

TEST(ReadPly, ReadsCarriageReturns) {
  std::string windows;
  for (const char c : kTetrahedronTextPly) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  expect_tetrahedron(windows);
  std::string binary = tetrahedron_binary_ply(ByteOrder::LittleEndian);
  const std::size_t body = binary.find("end_header\n") + 11;
  std::string header;
  for (const char c : binary.substr(0, body)) {
    if (c == '\n') header += '\r';
    header += c;
  }
  expect_tetrahedron(header + binary.substr(body));
}

TEST(ReadPly, ReadsABinaryBodyThatBeginsWithBlanksAndLineEnds) {
  // The float whose bytes are 0a 0d 20 0a is an ordinary small number.
  std::string bytes = tetrahedron_binary_ply(ByteOrder::LittleEndian);
  bytes.replace(bytes.find("end_header\n") + 11, 4, "\x0a\x0d\x20\x0a");
  EXPECT_EQ(parse(bytes).points[0].x, static_cast<double>(std::bit_cast<float>(0x0a200d0aU)));
}

TEST(ReadPly, TakesElementsAndPropertiesInAnyOrder) {
  expect_tetrahedron(kAscii +
                     "element edge 2\nproperty int a\nproperty int b\n"
                     "element face 4\nproperty uchar red\nproperty list int float weights\n"
                     "property list ushort uint vertex_index\nproperty double area\n"
                     "element camera 0\nproperty float f\n"
                     "element vertex 4\nproperty list uchar uchar tags\nproperty double z\n"
                     "property float quality\nproperty int y\nproperty short x\nend_header\n"
                     "7 7\n8 8\n"
                     "255 0 3 0 2 1 .5\n255 2 .5 nan 3 0 1 3 .5\n255 1 0 3 0 3 2 1e999\n"
                     "255 0 3 1 2 3 x\n"
                     "0 0 .5 0 0\n1 9 0 .5 0 1\n0 0 .5 1 0\n2 9 9 1 .5 0 0\n");
}

// The same with every type in a binary file.
void expect_every_type(ByteOrder order) {
  std::string bytes = "ply\nformat binary_";
  bytes += order == ByteOrder::LittleEndian ? "little" : "big";
  bytes +=
      "_endian 1.0\n"
      "element face 4\nproperty int8 a\nproperty list uint16 float64 skipped\n"
      "property list int32 uint8 vertex_index\nproperty uint32 b\n"
      "element vertex 4\nproperty int16 x\nproperty list char float32 l\nproperty double y\n"
      "property uint8 z\nend_header\n";
  for (const auto& face : kTetrahedronFaces) {
    append(bytes, std::int8_t{-1}, order);
    append(bytes, std::uint16_t{2}, order);
    append(bytes, std::numeric_limits<double>::quiet_NaN(), order);
    append(bytes, 1.0, order);
    append(bytes, std::int32_t{3}, order);
    for (const std::uint32_t corner : face) append(bytes, static_cast<std::uint8_t>(corner), order);
    append(bytes, 0xffffffffU, order);
  }
  for (const glm::dvec3& point : kTetrahedronPoints) {
    append(bytes, static_cast<std::int16_t>(-2 * point.x), order);
    append(bytes, std::int8_t{1}, order);
    append(bytes, 5.0F, order);
    append(bytes, point.y + 0.1, order);
    append(bytes, static_cast<std::uint8_t>(255 * point.z), order);
  }
  const PolygonSoup soup = parse(bytes);
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
  EXPECT_EQ(soup.points,
            (std::vector<glm::dvec3>{{0, 0.1, 0}, {-2, 0.1, 0}, {0, 1.1, 0}, {0, 0.1, 255}}));
}

TEST(ReadPly, ReadsEveryTypeInBinary) {
  expect_every_type(ByteOrder::LittleEndian);
  expect_every_type(ByteOrder::BigEndian);
}

TEST(ReadPly, RejectsMalformedHeadersByLine) {
  const std::pair<std::string, std::string> cases[] = {
      {"plx\n", "part.ply:1: expected ply, found 'plx'"},
      {"ply\n" + kVertexElement, "part.ply:2: expected format, found 'element'"},
      {"ply\nformat ascii 2.0\n", "part.ply:2: PLY version '2.0' is not 1.0"},
      {"ply\nformat utf8 1.0\n", "part.ply:2: unknown PLY format 'utf8'"},
      {"ply\nformat\n", "part.ply:2: the line ends before the format"},
      {kAscii + "element vertex\n", "part.ply:3: the line ends before the element's count"},
      {kAscii + "element vertex -4\n", "part.ply:3: the count '-4' is negative"},
      {kAscii + "element vertex 4x\n", "part.ply:3: the count '4x' is not a whole number"},
      {kAscii + "property float x\n", "part.ply:3: a property before the first element"},
      {kAscii + "elements vertex 4\n", "part.ply:3: unknown PLY header line 'elements'"},
      {kAscii + "element vertex 4\nproperty real x\n", "part.ply:4: unknown PLY type 'real'"},
      {kAscii + "element vertex 4\nproperty float\n",
       "part.ply:4: the line ends before the property's name"},
      {kAscii + "element vertex 4\nproperty float x\nproperty int x\n",
       "part.ply:5: a second property 'x' of one element"},
      {kAscii + kVertexElement + kVertexElement, "part.ply:7: a second element 'vertex'"},
      {kAscii + "element face 1\nproperty list float int vertex_indices\n",
       "part.ply:4: the length of a list is an integer"},
      {kAscii + "element face 1\nproperty list uchar int a b\n",
       "part.ply:4: unexpected 'b' at the end of the line"},
      {kAscii + kVertexElement, "part.ply:7: the file ends before end_header"},
      {kAscii + kVertexElement + "end_header x\n", "part.ply:7: unexpected 'x' in the line"},
  };
  for (const auto& [bytes, message] : cases) EXPECT_EQ(error(bytes), message);
}

TEST(ReadPly, RejectsHeadersWithoutAMesh) {
  EXPECT_EQ(error(kAscii + kVertexElement + "end_header\n" + kPoints),
            "part.ply: the PLY header has no element 'face'");
  EXPECT_EQ(error(kAscii + kFaceElement + "end_header\n" + kFaces),
            "part.ply: the PLY header has no element 'vertex'");
  EXPECT_EQ(error(kAscii + "element vertex 4\nproperty float x\nproperty float y\n" + kFaceElement +
                  "end_header\n" + kPoints + kFaces),
            "part.ply: the element 'vertex' needs the numbers x, y and z");
  EXPECT_EQ(
      error(kAscii + kVertexElement + "element face 0\nproperty list uchar int vertex_indices\n" +
            "end_header\n" + kPoints),
      "part.ply: the file has no faces");
  for (const char* property :
       {"list uchar float vertex_indices", "int vertex_indices", "list uchar int corners",
        "list uchar int vertex_indices\nproperty int vertex_index"}) {
    EXPECT_EQ(error(kAscii + kVertexElement + "element face 4\nproperty " + property +
                    "\nend_header\n" + kPoints + kFaces),
              "part.ply: the element 'face' needs one list of integers 'vertex_indices' (or "
              "'vertex_index')");
  }
}

TEST(ReadPly, RejectsCountsThatTheFileCannotHoldBeforeAllocating) {
  for (const char* count : {"9223372036854775807", "4294967296", "1000"}) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
      const std::string text =
          error("ply\nformat " + std::string(format) + " 1.0\nelement vertex " + count +
                "\nproperty float x\nproperty float y\nproperty float z\n" + kFaceElement +
                "end_header\n" + kPoints + kFaces);
      EXPECT_NE(text.find("the header claims " + std::string(count)), std::string::npos) << text;
    }
  }
}

TEST(ReadPly, RejectsHeadersOverTheLimits) {
  std::string elements = kAscii, properties = kAscii + "element vertex 4\n";
  for (std::size_t i = 0; i <= mesh_limits::kMaxPlyElements; ++i) {
    elements += "element e" + std::to_string(i) + " 0\nproperty int a\n";
  }
  for (std::size_t i = 0; i <= mesh_limits::kMaxPlyProperties; ++i) {
    properties += "property int p" + std::to_string(i) + "\n";
  }
  EXPECT_NE(error(elements).find("more than 64 elements"), std::string::npos);
  EXPECT_NE(error(properties).find("more than 1024 properties"), std::string::npos);
  EXPECT_NE(error(kAscii + "comment " + std::string(mesh_limits::kMaxPlyHeaderBytes, 'x'))
                .find("no end_header in the first 1048576 bytes"),
            std::string::npos);
}

TEST(ReadPly, NamesTheLineOfABadTextRow) {
  const std::pair<std::string, std::string> cases[] = {
      {"0 0 0\n1 nan 0\n0 1 0\n0 0 1\n" + kFaces,
       "part.ply:11: vertex 1: 'nan' is not a finite number"},
      {"0 0 0\n1 0\n0 1 0\n0 0 1\n" + kFaces,
       "part.ply:11: vertex 1: the line ends where a number should stand"},
      {"0 0 0\n1 0 0 0\n0 1 0\n0 0 1\n" + kFaces,
       "part.ply:11: vertex 1 has more values than its line should have, from '0' on"},
      {kPoints + "3 0 2 1\n3 0 1 4\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1 uses vertex 4, the file has 4 vertices"},
      {kPoints + "3 0 2 1\n3 0 1 -1\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1 uses vertex -1, the file has 4 vertices"},
      {kPoints + "3 0 2 1\n4 0 1 3 1\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1 uses vertex 1 more than once"},
      {kPoints + "3 0 2 1\n0\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1 has 0 corners, a face needs 3 or more"},
      {kPoints + "3 0 2 1\n-3 0 1 2\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1 has a list of negative length"},
      {kPoints + "3 0 2 1\n3 0 1\n3 0 3 2\n3 1 2 3\n",
       "part.ply:15: face 1: the line ends where a number should stand"},
      {kPoints + "3 0 2 1\n3 0 1 3\n3 0 3 2        \n", "part.ply:17: the file ends before face 3"},
      {kPoints + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 0 3 1\n3 1 2 3\n",
       "part.ply:18: a line after the last one that the header counts"},
  };
  for (const auto& [body, message] : cases) EXPECT_EQ(error(kHeader + body), message);
}

TEST(ReadPly, NamesTheByteOfABadBinaryRow) {
  const std::string good = tetrahedron_binary_ply(ByteOrder::LittleEndian);
  const std::size_t body = good.find("end_header\n") + 11;
  const std::size_t faces = body + 4 * 12;
  const auto at = [](std::size_t byte) { return "part.ply: byte " + std::to_string(byte) + ": "; };

  std::string bad = good;
  bad.replace(body + 12, 4, std::string("\0\0\xc0\x7f", 4));
  EXPECT_EQ(error(bad), at(body + 16) + "vertex 1 has a coordinate that is not a finite number");
  bad = good;
  bad[faces + 13 + 1] = 4;
  EXPECT_EQ(error(bad), at(faces + 18) + "face 1 uses vertex 4, the file has 4 vertices");
  bad = good;
  bad.replace(faces + 13 + 1, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(error(bad), at(faces + 18) + "face 1 uses vertex -1, the file has 4 vertices");
  bad = good;
  bad[faces + 13] = 0;
  EXPECT_EQ(error(bad), at(faces + 14) + "face 1 has 0 corners, a face needs 3 or more");
  bad = good;
  bad[faces + 13 + 1] = 2;  // turned inside out, and there is more behind
  EXPECT_EQ(error(bad + "x"), at(good.size()) + "the file has 1 bytes more than its header counts");
  EXPECT_EQ(error(std::string_view(good).substr(0, good.size() - 1)),
            at(good.size() - 1) + "the file ends inside face 3");
}

TEST(ReadPly, RejectsASkippedListThatLeavesTheFile) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + kVertexElement +
                      "element face 1\nproperty list uint double skipped\n"
                      "property list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 12; ++i) append(bytes, 0.0F);
  append(bytes, 0xffffffffU);
  EXPECT_NE(error(bytes + std::string(20, 'x')).find("the file ends inside face 0"),
            std::string::npos);
}

TEST(ReadPly, ReadsValuesOnAnyLines) {
  for (const char* separator : {"\n", " ", "\n\n"}) {
    std::string body;
    for (const char c : kPoints + kFaces) {
      if (c == ' ' || c == '\n') {
        body += separator;
      } else {
        body += c;
      }
    }
    expect_tetrahedron(kHeader + body);
  }
  expect_tetrahedron(kHeader + "0 0 0 1\n0 0 0 1\n0 0 0 1\n" + kFaces);
}

TEST(ReadPly, DoesNotTakeValuesForOthersInDamagedFiles) {
  for (std::size_t i = 0; i < kPoints.size() + kFaces.size(); ++i) {
    std::string body = kPoints + kFaces;
    if (body[i] == ' ' || body[i] == '\n') continue;
    body.erase(i, 1);
    EXPECT_NE(error(kHeader + body), "no error") << body;
    for (char& c : body) c = c == ' ' ? '\n' : c;
    EXPECT_NE(error(kHeader + body), "no error") << body;
  }
}

TEST(ReadPly, IgnoresAndRemarksWhatFollowsAWholeFile) {
  const std::string binary = tetrahedron_binary_ply(ByteOrder::LittleEndian);
  expect_tetrahedron(binary + "x");
  EXPECT_EQ(parse(binary + "x").remarks,
            std::vector<std::string>{"ignored: 1 byte behind the last row that the header counts"});
  expect_tetrahedron(kTetrahedronTextPly + "and so on\n");
  EXPECT_EQ(
      parse(kTetrahedronTextPly + "\nand so on\n").remarks,
      std::vector<std::string>{"ignored: 10 bytes behind the last row that the header counts"});
  EXPECT_TRUE(parse(kTetrahedronTextPly + "\n\n \x1a").remarks.empty());
}

TEST(ReadPly, ReadsWordsInCapitals) {
  std::string capitals;
  for (const char c : kTetrahedronTextPly)
    capitals += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  expect_tetrahedron(capitals);
  expect_tetrahedron(
      "ply\nformat Ascii 1.0\nelement Vertex 4\nproperty Float X\n"
      "property Float Y\nproperty Float Z\nelement Face 4\n"
      "property list UChar Int Vertex_Indices\nend_header\n" +
      kPoints + kFaces);
}

TEST(ReadPly, PassesOverElementsWithoutProperties) {
  expect_tetrahedron(kAscii + "element nothing 3\n" + kVertexElement +
                     "element more 9000000000000000000\n" + kFaceElement + "end_header\n" +
                     kPoints + kFaces);
  std::string binary = tetrahedron_binary_ply(ByteOrder::BigEndian);
  binary.insert(binary.find("element face"), "element nothing 7\n");
  expect_tetrahedron(binary);
  EXPECT_EQ(error(kAscii + "element vertex 9000000000000000000\n" + kFaceElement + "end_header\n" +
                  kPoints + kFaces)
                .find("part.ply: the PLY header claims"),
            0U);
}

TEST(ReadPly, LeavesOutFacesOfOneOrTwoCorners) {
  const PolygonSoup soup =
      parse(kAscii + kVertexElement + "element face 6\nproperty list uchar int vertex_indices\n" +
            "end_header\n" + kPoints + "2 0 1\n" + kFaces + "1 3\n");
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
  EXPECT_EQ(soup.collapsed.count, 2U);
}

TEST(ReadPly, ReadsLinesThatEndAsOnOldMacs) {
  std::string mac = kTetrahedronTextPly;
  for (char& c : mac) c = c == '\n' ? '\r' : c;
  expect_tetrahedron(mac);
  // The first byte of the data is a line feed: it belongs to the data.
  std::string binary = tetrahedron_binary_ply(ByteOrder::LittleEndian);
  const std::size_t body = binary.find("end_header\n") + 11;
  for (std::size_t i = 0; i < body; ++i) binary[i] = binary[i] == '\n' ? '\r' : binary[i];
  expect_tetrahedron(binary);
  binary[body] = '\n';
  EXPECT_EQ(parse(binary).points[0].x, static_cast<double>(std::bit_cast<float>(0x0000000aU)));
}

TEST(ReadPly, RejectsAnEmptyFile) { EXPECT_EQ(error(""), "part.ply: the file is empty"); }

}  // namespace
}  // namespace spoctree
