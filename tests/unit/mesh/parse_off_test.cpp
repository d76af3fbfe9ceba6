#include "server/mesh/parse_off.hpp"

#include <gtest/gtest.h>

#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

PolygonSoup parse(std::string_view bytes) { return parse_off(bytes, "part.off"); }
std::string error(std::string_view bytes) {
  return error_of([&] { parse(bytes); });
}
void expect_tetrahedron(std::string_view bytes) {
  const PolygonSoup soup = parse(bytes);
  EXPECT_EQ(soup.points, kTetrahedronPoints);
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
}

const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kFaces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(ReadOff, ReadsAPlainFile) { expect_tetrahedron(kTetrahedronOff); }

TEST(ReadOff, ReadsPolygonsOfSeveralSizes) {
  const PolygonSoup soup =
      parse("OFF\n5 2 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n3 0 1 2\n");
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3, 4}, {0, 1, 2}}));
}

TEST(ReadOff, DoesWithoutTheKeyword) { expect_tetrahedron("4 4 6\n" + kPoints + kFaces); }

TEST(ReadOff, DoesWithoutTheEdgeCount) { expect_tetrahedron("OFF\n4 4\n" + kPoints + kFaces); }

TEST(ReadOff, FindsTheCountsOnTheLineOfTheKeyword) {
  expect_tetrahedron("OFF 4 4 6\n" + kPoints + kFaces);
  expect_tetrahedron("OFF4 4 6\n" + kPoints + kFaces);
}

TEST(ReadOff, SkipsCommentsAndEmptyLinesAnywhere) {
  expect_tetrahedron(
      "# a comment\n\nOFF # tail\n\n# counts\n4 4 6#glued\n0 0 0\n\n1 0 0 # red\n# OFF\n0 1 0\n"
      "0 0 1#x\n\n3 0 2 1\n \t\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(ReadOff, ReadsCarriageReturnsAndNoFinalNewline) {
  std::string windows;
  for (const char c : kTetrahedronOff) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  expect_tetrahedron(windows);
  expect_tetrahedron(std::string_view(kTetrahedronOff).substr(0, kTetrahedronOff.size() - 1));
}

TEST(ReadOff, SkipsNormalsColoursAndTextureCoordinates) {
  const std::string decorated =
      "4 4 6\n0 0 0 0 0 1 255 0 0 255 0.5 0.5\n1 0 0 0 0 1 255 0 0 255 0 0\n"
      "0 1 0 0 0 1 0 0 0 0 0 0\n0 0 1 0 0 1 0 0 0 0 0 0\n"
      "3 0 2 1 255 0 0\n3 0 1 3 .5 .5 .5 1.0\n3 0 3 2 7\n3 1 2 3\n";
  for (const char* keyword : {"OFF\n", "COFF\n", "NOFF\n", "CNOFF\n", "STOFF\n", "STCNOFF\n"}) {
    expect_tetrahedron(keyword + decorated);
  }
}

TEST(ReadOff, DividesHomogeneousPointsByTheirWeight) {
  expect_tetrahedron("4OFF\n4 4 6\n0 0 0 1\n2 0 0 2\n0 -0.5 0 -0.5\n0 0 4 4\n" + kFaces);
  EXPECT_EQ(error("4OFF\n4 4 6\n0 0 0 1\n2 0 0 0\n0 1 0 1\n0 0 1 1\n" + kFaces),
            "part.off:4: vertex 1 is at infinity (its w is 0)");
  EXPECT_EQ(error("4OFF\n4 4 6\n0 0 0 1\n2 0 0 1e-320\n0 1 0 1\n0 0 1 1\n" + kFaces),
            "part.off:4: vertex 1 is not finite after division by its w");
  EXPECT_EQ(error("4OFF\n4 4 6\n0 0 0\n2 0 0 1\n0 1 0 1\n0 0 1 1\n" + kFaces),
            "part.off:3: vertex 0: the line ends where a number should stand");
}

TEST(ReadOff, ReadsTheDimensionOfNOff) {
  expect_tetrahedron("nOFF\n3\n4 4 6\n" + kPoints + kFaces);
  expect_tetrahedron("nOFF 3\n4 4 6\n" + kPoints + kFaces);
  EXPECT_NE(error("nOFF\n5\n4 4 6\n" + kPoints + kFaces).find("part.off:2: the dimension is '5'"),
            std::string::npos);
}

TEST(ReadOff, IgnoresWhatFollowsTheCountedFaces) {
  expect_tetrahedron(kTetrahedronOff + "3 0 1 2\nand more\n");
}

TEST(ReadOff, KeepsUnusedVertices) {
  EXPECT_EQ(parse("OFF\n5 4 6\n" + kPoints + "9 9 9\n" + kFaces).points.size(), 5U);
}

TEST(ReadOff, RejectsBinaryOff) {
  EXPECT_EQ(error(std::string("OFF BINARY\n\0\0\0\4", 15)),
            "part.off:1: binary OFF is not supported, save it as text");
}

TEST(ReadOff, RejectsAnEmptyFile) {
  EXPECT_NE(error("").find("the file is empty"), std::string::npos);
  EXPECT_NE(error("# only a comment\n\n").find("the file is empty"), std::string::npos);
}

TEST(ReadOff, RejectsAnotherFirstWord) {
  EXPECT_EQ(error("PLY\n"), "part.off:1: expected OFF or the number of vertices, found 'PLY'");
  EXPECT_EQ(error("OFFICE\n"),
            "part.off:1: expected OFF or the number of vertices, found 'OFFICE'");
}

TEST(ReadOff, RejectsCountsThatAreNotCounts) {
  EXPECT_EQ(error("OFF\n-4 4 6\n" + kPoints + kFaces),
            "part.off:2: the number of vertices '-4' is negative");
  EXPECT_EQ(error("OFF\n4 4.5 6\n" + kPoints + kFaces),
            "part.off:2: the number of faces '4.5' is not a whole number");
  EXPECT_EQ(error("OFF\n4\n" + kPoints + kFaces), "part.off:2: the number of faces is missing");
  EXPECT_EQ(error("OFF\n4 4 6 1\n" + kPoints + kFaces)
                .find("part.off:2: expected the numbers of vertices, faces and edges, found a "
                      "fourth number"),
            0U);
  EXPECT_EQ(error("OFF\n4 4 x\n" + kPoints + kFaces),
            "part.off:2: the number of edges 'x' is not a whole number");
  EXPECT_EQ(error("OFF\n99999999999999999999 4 6\n" + kPoints + kFaces),
            "part.off:2: the number of vertices '99999999999999999999' is too large a number");
  EXPECT_EQ(error("OFF\n"), "part.off:2: the file ends before its counts of vertices and faces");
}

TEST(ReadOff, RejectsCountsThatTheFileCannotHoldBeforeAllocating) {
  for (const char* counts : {"353535235358 6 0", "4 9223372036854775807 0", "9223372036854775807 1",
                             "100000000 4 0", "4 200000000 0"}) {
    const std::string text = error("OFF\n" + std::string(counts) + "\n" + kPoints + kFaces);
    EXPECT_EQ(text.find("part.off:2: the header claims "), 0U) << text;
  }
}

TEST(ReadOff, RejectsAFileWithoutFaces) {
  EXPECT_EQ(error("OFF\n4 0 0\n" + kPoints), "part.off:2: the file has no faces");
}

TEST(ReadOff, RejectsCoordinatesThatAreNotFinite) {
  EXPECT_EQ(error("OFF\n4 4 6\n0 0 0\n1 nan 0\n0 1 0\n0 0 1\n" + kFaces),
            "part.off:4: vertex 1: 'nan' is not a finite number");
  EXPECT_EQ(error("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 -inf\n0 0 1\n" + kFaces),
            "part.off:5: vertex 2: '-inf' is not a finite number");
  EXPECT_EQ(error("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 1e999\n0 0 1\n" + kFaces),
            "part.off:5: vertex 2: '1e999' is too large a number");
  EXPECT_EQ(error("OFF\n4 4 6\n0 0 0\n1 0\n0 1 0\n0 0 1\n" + kFaces),
            "part.off:4: vertex 1: the line ends where a number should stand");
}

TEST(ReadOff, RejectsVertexNumbersOutOfRange) {
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n3 0 1 4\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 uses vertex 4, the file has 4 vertices");
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n3 0 1 -1\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 uses vertex -1, the file has 4 vertices");
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n3 0 1 2.5\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 uses vertex '2.5', which is not a whole number");
}

TEST(ReadOff, RejectsFacesThatAreNone) {
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n0\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 has 0 corners, a face needs 3 or more");
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n4 0 1 0 2\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 uses vertex 0 more than once");
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n4 0 1 3\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 has a line that ends after 3 of its 4 corners");
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n-3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
            "part.off:8: face 1 begins with '-3', which is not a number of corners");
}

TEST(ReadOff, FindsAnEdgeThatALargePolygonUsesTwice) {
  std::string text = "OFF\n100 1 0\n";
  for (int i = 0; i < 100; ++i) text.append(std::to_string(i)).append(" 0 0\n");
  text += "102";
  for (int i = 0; i < 100; ++i) text.append(" ").append(std::to_string(i));
  EXPECT_NE(error(text + " 57 58\n").find("part.off:103: face 0 uses vertex 57 more than once"),
            std::string::npos);
}

TEST(ReadOff, LeavesOutFacesOfOneOrTwoCorners) {
  const PolygonSoup soup =
      parse("OFF\n4 6 6\n" + kPoints + "3 0 2 1\n2 0 1\n3 0 1 3\n3 0 3 2\n1 3\n3 1 2 3\n");
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
  EXPECT_EQ(soup.collapsed.count, 2U);
  EXPECT_EQ(soup.collapsed.first, 1U);
}

// `text` with one more value on every line than `values`, one on each, all on one, and so on.
std::string in_lines_of(const std::string& text, int values) {
  std::string lines;
  int count = 0;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\n';
    lines += is_blank ? (++count % values == 0 ? '\n' : ' ') : c;
  }
  return lines;
}

TEST(ReadOff, ReadsValuesOnAnyLines) {
  for (const int values : {1, 2, 4, 5, 7, 1000}) {
    for (const char* head : {"OFF\n4 4 6\n", "4 4 6\n", "OFF 4 4 6 "}) {
      expect_tetrahedron(head + in_lines_of(kPoints + kFaces, values));
    }
    expect_tetrahedron(in_lines_of("OFF\n4 4 6\n" + kPoints + kFaces, values));
    expect_tetrahedron("OFF\n" + in_lines_of("4 4 6\n" + kPoints, values) + "\n" + kFaces);
    expect_tetrahedron("4OFF\n4 4 6\n" +
                       in_lines_of("0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n" + kFaces, values));
    expect_tetrahedron(
        "NOFF\n4 4 6\n" +
        in_lines_of("0 0 0 9 8 7\n1 0 0 1 2 3\n0 1 0 9 9 9\n0 0 1 9 9 9\n" + kFaces, values));
    // With 7 values a line each vertex of three colours would seem to have a line.
    for (const char* colour : {" .5 .5 .5", " 1 .5 .5 .25"}) {
      if (values == 7) continue;
      std::string points;
      for (const char* point : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"})
        points.append(point).append(colour).append("\n");
      expect_tetrahedron("COFF\n4 4 6\n" + in_lines_of(points, values) + "\n" + kFaces);
    }
  }
}

TEST(ReadOff, ReadsCountsAndFacesOnSeveralLinesBesideColours) {
  expect_tetrahedron("OFF\n4\n4\n6\n" + kPoints + kFaces);
  expect_tetrahedron("OFF\n4 4 6\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 1 1 1\n0 0 1 2 2 2\n" +
                     std::string("3 0\n 2 1 255 0 0\n3\n0 1 3 7\n3 0 3\n2\n3 1 2 3\n"));
}

TEST(ReadOff, DoesWithoutTheEdgeCountOnAnyLinesWhereNoOtherNumberCanBeIt) {
  const std::string points = "-1 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  EXPECT_EQ(parse("OFF\n4 4\n" + in_lines_of(points + kFaces, 1)).points[0], glm::dvec3(-1, 0, 0));
  EXPECT_NE(error("OFF\n4 4\n" + in_lines_of(kPoints + kFaces, 1)), "no error");
  expect_tetrahedron("OFF\n4\n4\n" + kPoints + kFaces);
}

TEST(ReadOff, DoesNotTakeValuesForOthersInDamagedFiles) {
  const std::string file = "OFF\n4 4 6\n" + kPoints + kFaces;
  const std::size_t body = file.size() - kPoints.size() - kFaces.size();
  for (std::size_t i = body; i < file.size(); ++i) {
    if (file[i] == ' ' || file[i] == '\n') continue;
    std::string without = file;
    without.erase(i, 1);
    // "1 2 3" is a face of one corner and something else: it is counted as left out.
    if (error(without) == "no error") {
      EXPECT_EQ(parse(without).collapsed.count, 1U) << without;
    }
    // One to a line, so that lines do not tell. What follows the last face is nobody's.
    const bool is_in_vertices = i < body + kPoints.size();
    const std::string lines = in_lines_of(file, 1);
    std::string lines_without = lines;
    lines_without.erase(i, 2);
    EXPECT_NE(error(lines_without), "no error") << lines_without;
    std::string lines_doubled = lines;
    lines_doubled.insert(i, std::string(1, lines[i]) + "\n");
    if (is_in_vertices) {
      EXPECT_NE(error(lines_doubled), "no error") << lines_doubled;
    }
  }
}

TEST(ReadOff, ReadsTheKeywordInSmallLetters) {
  expect_tetrahedron("off\n4 4 6\n" + kPoints + kFaces);
  expect_tetrahedron("coff 4 4 6\n" + kPoints + kFaces);
  expect_tetrahedron("noff\n4 4 6\n" + kPoints + kFaces);
}

TEST(ReadOff, ReadsLinesThatEndAsOnOldMacs) {
  std::string mac = "# comment\n" + kTetrahedronOff;
  for (char& c : mac) c = c == '\n' ? '\r' : c;
  expect_tetrahedron(mac);
}

TEST(ReadOff, ReadsExponentsOfFortran) {
  expect_tetrahedron("OFF\n4 4 6\n0.D0 0 0\n1.0D+00 0 0\n0 10d-1 0\n0 0 1\n" + kFaces);
}

TEST(ReadOff, RejectsFilesThatEndEarly) {
  EXPECT_EQ(error("OFF\n4 4 6\n" + kPoints + "3 0 2 1\n3 0 1 3\n3 0 3 2\n# the last is missing\n"),
            "part.off:11: the file ends after 3 of 4 faces (its header claims 4 vertices)");
  EXPECT_EQ(error("OFF\n4 1 6\n0 0 0\n1 0 0\n# padding, so that the counts look possible\n"),
            "part.off:6: the file ends after 2 of 4 vertices");
}

TEST(ReadOff, SaysThatTheHeaderMayClaimTooFewVertices) {
  EXPECT_EQ(error("OFF\n3 4 6\n" + kPoints + kFaces),
            "part.off:6: face 0 has 0 corners, a face needs 3 or more (does the file have more "
            "vertices than the 3 that its header claims?)");
  EXPECT_EQ(error("OFF\n3 4 6\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n" + kFaces),
            "part.off:6: face 0 has a line that ends after 2 of its 3 corners (does the file have "
            "more vertices than the 3 that its header claims?)");
}

TEST(ReadOff, RejectsAHeaderThatClaimsTooManyVertices) {
  EXPECT_EQ(error("OFF\n6 4 6\n" + kPoints + "# padding, so that it looks possible\n" + kFaces),
            "part.off:12: the file ends after 2 of 4 faces (its header claims 6 vertices)");
}

TEST(ReadOff, QuotesHostileBytesHarmlessly) {
  EXPECT_EQ(error("\x1b[2J\n"),
            "part.off:1: expected OFF or the number of vertices, found '\\x1b[2J'");
  EXPECT_LT(error(std::string(100000, 'x')).size(), 200U);
}

}  // namespace
}  // namespace spoctree
