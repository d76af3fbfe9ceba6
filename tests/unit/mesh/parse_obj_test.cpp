#include "server/mesh/parse_obj.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

PolygonSoup parse(std::string_view bytes) { return parse_obj(bytes, "part.obj"); }
std::string error(std::string_view bytes) {
  return error_of([&] { parse(bytes); });
}
void expect_tetrahedron(std::string_view bytes) {
  const PolygonSoup soup = parse(bytes);
  EXPECT_EQ(soup.points, kTetrahedronPoints);
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
}

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kFaces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST(ReadObj, ReadsAPlainFile) { expect_tetrahedron(kTetrahedronObj); }

TEST(ReadObj, ReadsAllFormsOfCorners) {
  expect_tetrahedron(kPoints +
                     "f 1/1 3/2 2/3\nf 1//1 2//2 4//3\nf 1/1/1 4/2/2 3/3/3\nf 2/ 3/1/ 4//\n");
}

TEST(ReadObj, CountsNegativeNumbersBackFromTheFace) {
  expect_tetrahedron(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf 1 -1 -2\nf -3//-1 3 4\n");
}

TEST(ReadObj, LetsAFaceComeBeforeItsVertices) { expect_tetrahedron(kFaces + kPoints); }

TEST(ReadObj, SkipsEverythingElse) {
  expect_tetrahedron(
      "# comment \\\nmtllib a.mtl\no thing\ng a b\ns off\nvn 0 0 1\nvt 0 0\nvp 1 1\nusemtl m\n"
      "curv2 1 2\nwhatever\n" +
      kPoints + "l 1 2 3\np 1\ns 1\n" + kFaces);
}

TEST(ReadObj, SkipsWeightsAndColoursOfVertices) {
  expect_tetrahedron("v 0 0 0 1.0\nv 1 0 0 255 0 0\nv 0 1 0 # tail\nv 0 0 1 1 0 0 0.5\n" + kFaces);
}

TEST(ReadObj, JoinsLinesThatEndInABackslash) {
  expect_tetrahedron(
      "v 0 \\\n0 0\nv 1 0 0\nv 0 1 0\nv 0 0\\\n 1\nf 1 \\\r\n3 \\\n2\nf 1 2 4\n"
      "vn 0 \\\nf 9 9 9\nf 1 4 3\nf 2 3 4\\");
  EXPECT_EQ(error(kPoints + "f 1 2 \\\n 3x\n"),
            "part.obj:6: the face corner '3x' is not of the form v, v/vt, v//vn or v/vt/vn");
}

TEST(ReadObj, ReadsCarriageReturnsAndNoFinalNewline) {
  std::string windows;
  for (const char c : kTetrahedronObj) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  expect_tetrahedron(windows);
  expect_tetrahedron(std::string_view(kTetrahedronObj).substr(0, kTetrahedronObj.size() - 1));
}

TEST(ReadObj, ReadsVeryLongLines) {
  std::string text, face = "f";
  for (int i = 1; i <= 20000; ++i) {
    text.append("v ").append(std::to_string(i)).append(" 0 0\n");
    face.append(" ").append(std::to_string(i)).append("/1/1");
  }
  EXPECT_EQ(parse(text + face).face(0).size(), 20000U);
}

TEST(ReadObj, RejectsIndicesOutsideTheFile) {
  EXPECT_EQ(error(kPoints + "f 1 2 3\nf 1 2 5\nf 1 2 4\n"),
            "part.obj:6: the face uses vertex 5, the file has 4 vertices");
  EXPECT_EQ(error(kPoints + "f 1 2 0\n"),
            "part.obj:5: the face uses vertex 0, the file has 4 vertices");
  EXPECT_EQ(error(kPoints + "f 1 2 -5\n"),
            "part.obj:5: the face uses vertex -5, the file has 4 vertices up to this line");
  EXPECT_EQ(error(kPoints + "f 1 2 4294967297\n"),
            "part.obj:5: the face uses vertex 4294967297, the file has 4 vertices");
  EXPECT_EQ(error(kPoints + "f 1 2 -9223372036854775808\n"),
            "part.obj:5: the face uses vertex -9223372036854775808, the file has 4 vertices up to "
            "this line");
}

TEST(ReadObj, RejectsMalformedCorners) {
  for (const char* corner : {"x", "1.5", "/1", "1/x", "1/1/1/1", "1//y", "99999999999999999999"}) {
    EXPECT_EQ(error(kPoints + "f 1 2 " + corner + "\n"),
              "part.obj:5: the face corner '" + std::string(corner) +
                  "' is not of the form v, v/vt, v//vn or v/vt/vn");
  }
}

TEST(ReadObj, RejectsFacesThatAreNone) {
  EXPECT_EQ(error(kPoints + "f\n"), "part.obj:5: the face has 0 corners, a face needs 3 or more");
  EXPECT_EQ(error(kPoints + "f 1 2 3 2\n"), "part.obj:5: the face uses vertex 2 more than once");
}

TEST(ReadObj, ReadsLinesThatEndAsOnOldMacs) {
  std::string mac = "# a comment \\\r" + kTetrahedronObj;
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  expect_tetrahedron(mac);
  expect_tetrahedron(mac + "\n");  // by an editor that ends every file so
  EXPECT_EQ(error("v 0 0 0\rv 1 0 0\r\rv 1 0 z\r"), "part.obj:4: vertex 3: 'z' is not a number");
  std::string joined = kPoints + "f 1 \\\n3 \\\n2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  std::replace(joined.begin(), joined.end(), '\n', '\r');
  expect_tetrahedron(joined);
}

TEST(ReadObj, ReadsCapitalsAndTheOldNameOfFaces) {
  std::string capitals = kTetrahedronObj;
  for (char& c : capitals) c = c == 'v' ? 'V' : c == 'f' ? 'F' : c;
  expect_tetrahedron(capitals);
  expect_tetrahedron(kPoints + "fo 1 3 2\nfo 1 2 4\nfo 1 4 3\nfo 2 3 4\n");
}

TEST(ReadObj, LeavesOutFacesOfOneOrTwoCornersButForOneThatIsCutOff) {
  const PolygonSoup soup = parse(kPoints + "f 1 2\n" + kFaces + "f 3\n");
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
  EXPECT_EQ(soup.collapsed.count, 2U);
  EXPECT_EQ(soup.collapsed.first, 0U);
  EXPECT_EQ(error(kPoints + "f 1 3 2\nf 1 2"),
            "part.obj:6: the face has 2 corners, and the file ends with it: it has been cut off");
}

TEST(ReadObj, LetsAFaceComeBackToAVertexByABridge) {
  const std::string points = kPoints + "v 1 1 0\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
  EXPECT_EQ(parse(points + "f 1 2 3 4 1 5 6 7 5\n").face(0).size(), 9U);  // by the edge 1-5
  EXPECT_EQ(parse(points + "f 1 2 3 1 4 5\n").face(0).size(), 6U);        // at a point
  EXPECT_EQ(error(points + "f 1 2 1 2 1 2\n"), "part.obj:9: the face uses vertex 1 more than once");
  EXPECT_EQ(error(points + "f 1 2 3 4 3 2\n"), "part.obj:9: the face uses vertex 3 more than once");
  EXPECT_EQ(error(points + "f 1 2 3 4 1 2 3 4\n"),
            "part.obj:9: the face uses vertex 1 more than once");
}

TEST(ReadObj, RejectsBadCoordinates) {
  EXPECT_EQ(error("v 0 0 0\nv 1 nan 0\n"), "part.obj:2: vertex 2: 'nan' is not a finite number");
  EXPECT_EQ(error("v 0 0 0\nv 1 0\n"),
            "part.obj:2: vertex 2: the line ends where a number should stand");
  EXPECT_EQ(error("v 0 0 0\nv 1 0 z\n"), "part.obj:2: vertex 2: 'z' is not a number");
}

TEST(ReadObj, RejectsAFileWithoutFaces) {
  EXPECT_EQ(error(kPoints), "part.obj:5: the file has no faces");
  EXPECT_EQ(error(""), "part.obj:1: the file has no faces");
}

}  // namespace
}  // namespace spoctree
