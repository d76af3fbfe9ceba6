#include "server/mesh/parse_stl.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

PolygonSoup parse(std::string_view bytes) { return parse_stl(bytes, "part.stl"); }
std::string error(std::string_view bytes) {
  return error_of([&] { parse(bytes); });
}

// STL numbers the vertices as they come: of the tetrahedron's corners, 0 2 1 and then 3.
void expect_tetrahedron(std::string_view bytes) {
  const PolygonSoup soup = parse(bytes);
  EXPECT_EQ(soup.points, (std::vector<glm::dvec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(faces_of(soup),
            (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}));
}

std::string text_facet(const std::string& vertices) {
  return "facet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\n";
}
const std::string kFacet = text_facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n");

TEST(ReadStl, ReadsATextFile) { expect_tetrahedron(kTetrahedronTextStl); }

TEST(ReadStl, ReadsABinaryFile) { expect_tetrahedron(tetrahedron_binary_stl()); }

TEST(ReadStl, ReadsABinaryFileWhoseHeaderBeginsWithSolid) {
  expect_tetrahedron(tetrahedron_binary_stl("solid tetrahedron"));
}

TEST(ReadStl, ReadsTextInAnyCaseAndLayout) {
  std::string upper;
  for (const char c : kTetrahedronTextStl) {
    upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  expect_tetrahedron(upper);
  std::string one_line = kTetrahedronTextStl;
  for (std::size_t i = one_line.find('\n') + 1; i < one_line.size(); ++i) {
    if (one_line[i] == '\n') one_line[i] = ' ';
  }
  expect_tetrahedron(one_line);
  expect_tetrahedron("\n  " + kTetrahedronTextStl.substr(0, kTetrahedronTextStl.size() - 1));
}

TEST(ReadStl, ReadsSeveralSolidsOfOneTextFile) {
  const PolygonSoup soup =
      parse("solid a\n" + kFacet + "endsolid a\n\nsolid\n" +
            text_facet("vertex 0 0 5\nvertex 1 0 0\nvertex 0 1 0\n") + "endsolid\n");
  EXPECT_EQ(soup.face_count(), 2U);
  EXPECT_EQ(soup.points.size(), 4U);
}

TEST(ReadStl, SkipsNormalsThatAreNotANumber) {
  EXPECT_EQ(parse("solid\nfacet normal nan -nan(ind) x\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")
                .face_count(),
            1U);
  std::string bytes = tetrahedron_binary_stl();
  bytes.replace(84, 4, "\xff\xff\xff\xff");
  expect_tetrahedron(bytes);
}

TEST(ReadStl, MergesNegativeZeroWithZero) {
  const PolygonSoup soup =
      parse("solid\n" + kFacet + text_facet("vertex -0 0 -0.0\nvertex 0 1 0\nvertex 0 0 1\n") +
            "endsolid\n");
  EXPECT_EQ(soup.points.size(), 4U);
}

TEST(ReadStl, DoesNotMergeNeighbouringDoubles) {
  const PolygonSoup soup =
      parse("solid\n" + kFacet +
            text_facet("vertex 5e-324 0 0\nvertex 1.0000000000000002 0 0\nvertex 0 1 0\n") +
            "endsolid\n");
  EXPECT_EQ(soup.points.size(), 5U);
}

TEST(ReadStl, WidensBinaryCoordinatesExactly) {
  const PolygonSoup soup = parse(binary_stl("", {{{0.1F, 0, 0}, {1, 0, 0}, {0, 1e-40F, 0}}}));
  EXPECT_EQ(soup.points[0].x, static_cast<double>(0.1F));
  EXPECT_EQ(soup.points[2].y, static_cast<double>(1e-40F));
}

std::string with_count(std::string bytes, std::uint32_t count) {
  std::string four;
  append(four, count);
  return bytes.replace(80, 4, four);
}

TEST(ReadStl, ReadsBinaryFilesWhoseCountIsWrongIfTheFacetsCloseAndSaysSo) {
  for (const std::uint32_t count : {0U, 3U, 5U, 0xffffffffU}) {
    const std::string bytes = with_count(tetrahedron_binary_stl(), count);
    expect_tetrahedron(bytes);
    EXPECT_EQ(
        parse(bytes).remarks,
        std::vector<std::string>{"the header's count is wrong: it claims " + std::to_string(count) +
                                 " facets, the file has 4, which close"});
  }
}

TEST(ReadStl, RejectsBinaryCountsThatDisagreeWithTheSizeIfTheFacetsDoNotClose) {
  for (const std::uint32_t count : {0U, 2U, 4U, 0xffffffffU}) {
    const std::string text =
        error(with_count(tetrahedron_binary_stl().substr(0, 84 + 3 * 50), count));
    EXPECT_NE(text.find("part.stl: the file is neither text STL"), std::string::npos) << text;
    EXPECT_NE(text.find("claims " + std::to_string(count) + " facets"), std::string::npos) << text;
    EXPECT_NE(text.find("the file has 234"), std::string::npos) << text;
  }
}

TEST(ReadStl, IgnoresAndRemarksBytesBehindTheLastBinaryFacet) {
  for (const char* header : {"", "solid"}) {
    for (const std::size_t more : {1, 13, 49, 51, 512}) {
      const std::string bytes = tetrahedron_binary_stl(header) + std::string(more, 'x');
      expect_tetrahedron(bytes);
      EXPECT_EQ(parse(bytes).remarks,
                std::vector<std::string>{"ignored: " + std::to_string(more) +
                                         (more == 1 ? " byte" : " bytes") +
                                         " behind the last of the 4 facets that the header "
                                         "counts"});
    }
  }
  expect_tetrahedron(tetrahedron_binary_stl() + std::string(100, '\0'));
}

TEST(ReadStl, ReadsWhatOtherProgramsWriteAsText) {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
    return text;
  };
  const std::string& plain = kTetrahedronTextStl;
  for (const std::string& text : {
           replaced(plain, "endloop", "end loop"),
           replaced(plain, "endfacet", "End Facet"),
           replaced(plain, "endsolid", "end solid"),
           replaced(plain, "endsolid ", "endsolid"),
           replaced(plain, "endsolid ", "ENDSOLID"),
           replaced(plain, "solid tetrahedron\nf", "solidTetrahedron\nf"),
           replaced(plain, "facet normal", "# a comment\n; another\n// a third\nfacet normal"),
           replaced(plain, "outer", "color 0.5 0.5 1\nouter"),
           replaced(plain, "outer", "COLOR 1 0 0 1 outer"),
           replaced(plain, "endfacet\n", "endfacet # done\ncolour red\n"),
           replaced(plain, "\n", "\r"),
           replaced(plain, "\n", "\r\n"),
           replaced(plain, "\n", "\r\r\n"),
           replaced(plain, "vertex 1 0 0", "vertex 1.0D0 0.d+00 0e0"),
           replaced(plain, "vertex 1 0 0", "vertex\n1\n0\n0"),
           replaced(plain, "facet normal 0 0 -1", "facet"),
           replaced(plain, " ", "\t"),
           "\xef\xbb\xbf# exported\n" + plain,
           plain + "\n",
       }) {
    expect_tetrahedron(text);
    EXPECT_TRUE(parse(text).remarks.empty()) << text;
  }
}

TEST(ReadStl, RemarksWhatIsOddButEvident) {
  const std::string& plain = kTetrahedronTextStl;
  const std::size_t end = plain.find("endsolid");
  const std::size_t first = plain.find("facet");
  const std::pair<std::string, std::string> cases[] = {
      {plain.substr(0, end), "the file ends without endsolid, behind facet 3 (counted from 0)"},
      {plain.substr(first), "the file begins without solid"},
      {"made by hand\n" + plain, "ignored: 1 line before the first solid"},
      {"solid\nby me\non Monday\n" + plain.substr(first),
       "ignored: 2 lines between solid and first facet"},
      {plain + "bye\n", "ignored: 4 bytes behind the last solid"},
      {plain + std::string(3, '\0'), "ignored: 3 bytes behind the last solid"},
  };
  for (const auto& [text, remark] : cases) {
    expect_tetrahedron(text);
    EXPECT_EQ(parse(text).remarks, std::vector<std::string>{remark}) << text;
  }
}

TEST(ReadStl, RejectsABinaryFileWithoutFacets) {
  EXPECT_EQ(error(binary_stl("", {})), "part.stl: the file has no facets");
}

TEST(ReadStl, RejectsBinaryCoordinatesThatAreNotFinite) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(error(binary_stl(
                  "", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, bad, 0}, {0, 1, 0}}})),
              "part.stl: facet 1 (byte 134) has a coordinate that is not a finite number");
  }
}

TEST(ReadStl, LeavesOutFacetsWithTwoEqualCornersAndCountsThem) {
  const PolygonSoup binary = parse(binary_stl("", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                   {{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}},
                                                   {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}}));
  EXPECT_EQ(faces_of(binary), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
  EXPECT_EQ(binary.collapsed.count, 2U);
  EXPECT_EQ(binary.collapsed.first, 1U);
  const PolygonSoup text = parse(
      "solid\n" + text_facet("vertex 1 2 3\nvertex 1 2 3\nvertex 0 0 0\n") + kFacet + "endsolid\n");
  EXPECT_EQ(text.face_count(), 1U);
  EXPECT_EQ(text.collapsed.count, 1U);
  EXPECT_EQ(text.collapsed.first, 0U);
}

TEST(ReadStl, NamesTheLineOfABadTextFacet) {
  EXPECT_EQ(error("solid\n" + text_facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 inf 0\n")),
            "part.stl:6: facet 0: 'inf' is not a finite number");
  EXPECT_EQ(error("solid\n" + text_facet("vertex 0 0 0\nvertex 1 0\nvertex 0 1 0\n")),
            "part.stl:5: facet 0: the line ends where a number should stand");
  EXPECT_EQ(error("solid\n" + text_facet("vertex 0 0 0\nvertex 1 0 0\n")),
            "part.stl:6: facet 0: expected vertex, found 'endloop'");
  EXPECT_EQ(
      error("solid\n" + text_facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n")),
      "part.stl:7: facet 0 has more than 3 corners");
  EXPECT_EQ(error("solid\n" + kFacet + "vertex 0 0 0\n"),
            "part.stl:9: facet 1: expected facet or endsolid, found 'vertex'");
  EXPECT_EQ(error("solid\nfacet normal 0 0\nouter loop\n"),
            "part.stl:2: facet 0: the normal is cut short");
  EXPECT_EQ(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop foo\nendfacet\nendsolid\n"),
            "part.stl:7: facet 0: expected endfacet, found 'foo'");
}

TEST(ReadStl, RejectsTextThatEndsInsideAFacetOrBeforeTheFirst) {
  EXPECT_EQ(error("solid x"),
            "part.stl:1: facet 0: expected facet or endsolid, found the end of the file");
  const std::string& plain = kTetrahedronTextStl;
  for (std::size_t size = 1; size < plain.find("endsolid"); ++size) {
    const std::string text = plain.substr(0, size);
    if (text.ends_with("endfacet") || text.ends_with("endfacet\n")) continue;
    EXPECT_NE(error(text), "no error") << text;
  }
}

TEST(ReadStl, RejectsTextBehindTheLastSolid) {
  EXPECT_EQ(error("solid\n" + kFacet + "endsolid\n" + kFacet),
            "part.stl:10: facet 1: expected solid, found 'facet'");
}

TEST(ReadStl, RejectsEmptyFilesAndEmptySolids) {
  EXPECT_EQ(error(""), "part.stl: the file is empty");
  EXPECT_EQ(error("solid a\nendsolid a\n"), "part.stl:3: the file has no facets");
}

TEST(ReadStl, RejectsWhatIsNoStl) {
  EXPECT_EQ(error("v 0 0 0\n"),
            "part.stl: the file is neither text STL (it does not begin with \"solid\") nor binary "
            "STL (its 8 bytes are less than a header)");
}

}  // namespace
}  // namespace spoctree
