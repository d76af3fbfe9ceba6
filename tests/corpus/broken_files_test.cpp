// The broken and the odd files that others made (environment variable SPOCTREE_MESHES), one by one
// through the program: the right solid, or one line that says what is wrong, within the time and
// memory that a file may cost; and the same with --repair. Volumes are from the files' uncorrupted
// originals and from a few lines of a script that shares nothing with this program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/meshes_folder.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

/// What the program answers: the volume of a solid (with so many digits right), or a message.
struct Answer {
  double volume = 0;
  const char* says = "";
  double tolerance = 1e-5;  // of the volume; six digits are printed
};

struct Case {
  const char* file;
  Answer plain;
  Answer repaired;  // nothing: as without
};

Answer solid(double volume, const char* says = "", double tolerance = 1e-5) {
  return {volume, says, tolerance};
}
Answer refused(const char* says) { return {0, says, 0}; }
const Answer kSame{};

constexpr double kAnchor = 0.14342795641980505;  // cad/anchor_1050f.off
constexpr double kHexNut = 46.790176810953355;   // cad/hex-nut-M3_620f.stl

const Case kCases[] = {
    {"broken/collapsed-faces_kp3s_6514f.stl",
     solid(2348432.13,
           "dropped: 6 faces with fewer than three different corners, the first is "
           "face 3976"),
     kSame},
    {"broken/degenerate_circuit_900f.stl", refused("degenerate: 2 faces without area, at ("),
     solid(1059.0719759, "resolved: 26 pairs of triangles in which the surface met itself")},
    {"broken/degenerate_sliding_8f.off", refused("degenerate: 4 faces without area, first at ("),
     refused("after repair: not closed: 6 border edges")},
    {"broken/degenerate_zero-area_14f.stl",
     refused("degenerate: 1 face without area, at (0, 0, 0)–(0, 0, 5)–(0, 0, 10)"),
     solid(1000, "dropped: 1 triangle without area, at (0, 0, 0)–(0, 0, 5)–(0, 0, 10)")},
    {"broken/inward_cone_40f.off", solid(0.25751392, "turned: all faces pointed inwards"), kSame},
    {"broken/inward_ellipe_3108f.off", solid(1.4740223, "turned: all faces"), kSame},
    {"broken/inward_tetrahedron_4f.off", solid(1.0 / 6, "turned: all faces"), kSame},
    // Wrong counts alone: all 620 facets are there.
    {"broken/made_count-4294967295.stl",
     solid(kHexNut, "the header's count is wrong: it claims 4294967295 facets, the file has 620"),
     kSame},
    {"broken/made_duplicate-face.off", refused("3 edges with more than two faces, at ("),
     solid(kAnchor, "dropped: 1 copy of a face, at (")},
    {"broken/made_face-count-too-big.off", refused("ends after 1050 of 1075 faces"), kSame},
    {"broken/made_face-index-out-of-range.off", refused(":532: face 10 uses vertex 524"), kSame},
    {"broken/made_inf-coordinate.off", refused(":10: vertex 7: 'inf'"), kSame},
    {"broken/made_nan-coordinate.off", refused(":103: vertex 100: 'nan'"), kSame},
    {"broken/made_negative-index.off", refused(":532: face 10 uses vertex -1"), kSame},
    {"broken/made_one-face-flipped.off", refused("3 edges whose two faces disagree, at ("),
     solid(kAnchor, "turned: 1 face that disagreed")},
    {"broken/made_one-face-missing.off", refused("3 border edges, at ("),
     solid(kAnchor, "filled: 1 hole with 1 face, at (")},
    {"broken/made_truncated-binary.stl", refused("claims 620 facets"), kSame},
    {"broken/made_truncated-in-faces.off", refused(":1166: face 643"), kSame},
    {"broken/made_vertex-count-too-small.off", refused(":519: face 0"), kSame},
    {"broken/made_zero-count.stl",
     solid(kHexNut, "the header's count is wrong: it claims 0 facets, the file has 620"), kSame},
    {"broken/nonmanifold-edge+selfint_diplodocus_47960f.off",
     refused("2 edges with more than two faces, at ("),
     solid(0.0291735361, "resolved: 67 pairs of triangles in which the surface met itself")},
    {"broken/nonmanifold-edge_back-to-back_10f.stl", refused("degenerate: 2 faces without area"),
     solid(32.0 / 3, "dropped: 1 face between two parts")},
    {"broken/nonmanifold-edge_kingroon_10164f.stl",
     refused("18 edges with more than two faces, first at ("),
     solid(1518788.808, "resolved: 18 edges with more than two faces")},
    {"broken/nonmanifold-edge_trimaker_19852f.stl",
     refused("312 edges with more than two faces, first at ("),
     solid(615505.31233, "resolved: 312 edges with more than two faces")},
    {"broken/nonmanifold-vertex_artillery_15494f.stl", refused("the faces around 1 vertex"),
     solid(16098011.97, "15494 faces")},
    // The open one's part of the volume, and a large quadrilateral.
    {"broken/open_blob_270f.off", refused("4 border edges, first at ("),
     solid(2.5, "filled: 1 hole with 2 faces", 0.1)},
    {"broken/open_cube_10f.off", refused("4 border edges, first at ("),
     solid(1e6, "filled: 1 hole with 2 faces")},
    {"broken/open_elephant-with-holes_4463f.off", refused("1353 border edges, first at ("),
     solid(0.0462012347, "filled: 171 holes with", 1e-3)},  // scan/elephant_5558f.off
    {"broken/open_mech-holes-shark_10192f.off", refused("304 border edges, first at ("),
     refused("3 holes neither flat nor within 25 % of the diagonal in size left open")},
    {"broken/open_single-triangle_1f.off", refused("3 border edges, at (0, 0, 0)–(1, 0, 0), "),
     refused("3 border edges")},
    {"broken/open_stanford-bunny-original_69451f.ply", refused("223 border edges, first at ("),
     solid(0.000754572, "filled: 5 holes with", 1e-3)},  // scan/stanford-bunny-filled_70320f.off
    {"broken/orientation_boeing_2564f.off", refused("978 edges whose two faces disagree"),
     solid(210.5693118, "faces that disagreed")},
    {"broken/orientation_cube-shuffled_12f.off", refused("9 edges whose two faces disagree"),
     solid(8, "turned: 5 faces that disagreed")},
    {"broken/orientation_unitcube_6f.off", refused("4 edges whose two faces disagree"),
     solid(1, "turned: 1 face that disagreed")},
    {"broken/parse_empty-face-line.obj", refused(":23: the face has 0 corners"), kSame},
    {"broken/parse_empty-solid.stl", refused("the file has no facets"), kSame},
    {"broken/parse_face-line-over-1024-chars-repeating-vertices_6f.obj",
     refused(":24: the face uses vertex 1 more than once"), kSame},
    {"broken/parse_header-without-edge-count_missing-faces.off",
     refused(":6: face 0 has 0 corners"), kSame},
    {"broken/parse_index-out-of-range.obj", refused(":28: the face uses vertex 0"), kSame},
    {"broken/parse_invalid-vertex.stl", refused(":89: facet 12: 'blah' is not a number"), kSame},
    {"broken/parse_ply-no-faces.ply", refused("no element 'face'"), kSame},
    {"broken/parse_too-many-vertices.stl", refused(":91: facet 12 has more than 3 corners"), kSame},
    {"broken/parse_unparseable.stl", refused(":4: facet 0: "), kSame},
    {"broken/parse_vertex-count-353535235358.off", refused("claims 353535235358 vertices"), kSame},
    {"broken/parse_zero-bytes.off", refused("the file is empty"), kSame},
    // Sums over the file's own triangles, which count what is wound around twice as often.
    {"broken/selfint_bones_26comp_4204f.off",
     refused("closed parts touch or overlap: 366 pairs of triangles meet, of 21 of 26 parts"),
     solid(18.66, "united: 21 of 26 closed parts, which touched or overlapped in 366 pairs", 5e-3)},
    {"broken/selfint_bunny-glmark2_69666f.obj", refused("2 pairs of triangles meet"),
     solid(1.5998146, "resolved: 2 pairs of triangles in which the surface met itself")},
    {"broken/selfint_elk_3290f.off", refused("7 pairs of triangles meet"),
     solid(421700.57536, "resolved: 7 pairs of triangles in which the surface met itself")},
    {"broken/selfint_man_34986f.off", refused("848 pairs of triangles meet"),
     solid(0.012537506, "resolved: 848 pairs of triangles in which the surface met itself", 1e-3)},
    {"broken/selfint_pcbvicebar_260f.stl", refused("4 pairs of triangles meet"),
     solid(11700.609253, "resolved: 4 pairs of triangles in which the surface met itself")},
    {"broken/selfint_tardis_3636f.stl", refused("6 pairs of triangles meet"),
     solid(19761.507669, "resolved: 6 pairs of triangles in which the surface met itself")},
    {"format/obj-unmerged-vertices_hellbot_268f.obj", solid(196356.4465, "268 faces"), kSame},
    {"format/obj_no-final-newline_6f.obj", solid(1, "6 faces, 6 planes"), kSame},
    // A frustum between squares of side 2 and 1, 1.5 high, its corners given with a weight.
    {"format/off_4OFF-4D-vertices_6f.off", solid(3.5, "6 faces, 6 planes"), kSame},
    // Four coloured faces in a plane: read right, but no solid.
    {"format/off_COFF-like-vertex-colours_4f.off", refused("8 border edges, first at ("), kSame},
    {"format/off_extra-face-lines-and-unused-vertices_7f.off", solid(8, "7 faces, 6 planes"),
     kSame},
    {"format/off_face-colours_6f.off", solid(8, "6 faces, 6 planes"), kSame},
    {"format/off_no-OFF-keyword_6f.off", solid(8, "6 faces, 6 planes"), kSame},
    {"format/ply-binary_cube_12f.ply", solid(1, "12 faces, 6 planes"), kSame},
    {"format/stl-ascii_sphere_320f.stl", solid(0.505952148, "320 faces, 320 planes"), kSame},
    {"format/stl-binary_header-starts-with-solid_46f.stl", solid(2.8710737, "46 faces"), kSame},
};

class BrokenFiles : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const char* folder = meshes_folder();
    if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
    path_ = fs::path(folder) / GetParam().file;
  }

  void expect_answer(const Answer& answer, bool is_repaired) const {
    const fs::path output =
        fs::path(testing::TempDir()) / ("broken-" + std::to_string(::getpid()) + ".spo");
    std::vector<std::string> words = {SPOCTREE_SERVER_PROGRAM, "build", path_.string(), "-o",
                                      output.string()};
    if (is_repaired) words.emplace_back("--repair");
    const WatchedRun run = run_watched(words);
    const bool is_solid = answer.tolerance > 0;
    EXPECT_EQ(run.code, is_solid ? 0 : 3) << run.out << run.err;
    EXPECT_LE(run.peak_bytes, kMostBytes);
    EXPECT_EQ(fs::exists(output), is_solid);
    fs::remove(output);
    const std::string& text = is_solid ? run.out : run.err;
    EXPECT_NE(text.find(answer.says), std::string::npos) << text;
    if (is_solid) {
      const std::size_t volume = text.find("volume ");
      ASSERT_NE(volume, std::string::npos) << text;
      if (answer.volume > 0) {
        EXPECT_NEAR(std::stod(text.substr(volume + 7)) / answer.volume, 1, answer.tolerance);
      }
    } else {
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
      EXPECT_EQ(text.find("spoctree-server: " + path_.string()), 0u) << text;
    }
  }

  fs::path path_;
};

TEST_P(BrokenFiles, GiveASolidOrOneClearLine) { expect_answer(GetParam().plain, false); }

TEST_P(BrokenFiles, AreRepairedOrRefused) {
  const Answer& repaired = GetParam().repaired;
  const bool is_same = repaired.says[0] == '\0';
  expect_answer(is_same ? GetParam().plain : repaired, true);
}

std::string name_of(const testing::TestParamInfo<Case>& tested) {
  std::string name = fs::path(tested.param.file).filename().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenFiles, testing::ValuesIn(kCases), name_of);

TEST(BrokenFilesTable, HasEveryFile) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  std::size_t files = 0;
  for (const char* sub : {"broken", "format"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / sub)) {
      const std::string name = std::string(sub) + "/" + entry.path().filename().string();
      EXPECT_TRUE(std::any_of(std::begin(kCases), std::end(kCases), [&](const Case& c) {
        return name == c.file;
      })) << name;
      ++files;
    }
  }
  EXPECT_EQ(files, std::size(kCases));
}

// What a corruption of one face needs is known: the original, exactly.
TEST(RepairedFiles, HaveTheVolumeOfTheOriginal) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  const fs::path meshes = folder;
  const Solid original = import_solid(read_mesh(meshes / "cad/anchor_1050f.off"), "anchor", {0});
  EXPECT_NEAR(original.volume, kAnchor, 1e-14);
  for (const char* name :
       {"made_duplicate-face.off", "made_one-face-flipped.off", "made_one-face-missing.off"}) {
    const PolygonSoup soup = read_mesh(meshes / "broken" / name);
    const Solid repaired = import_solid(repair(soup).soup, name, {0});
    EXPECT_DOUBLE_EQ(repaired.volume, original.volume) << name;
    EXPECT_EQ(repaired.triangles.size(), 1050u) << name;
    EXPECT_EQ(repaired.planes.size(), original.planes.size()) << name;
  }
}

}  // namespace
}  // namespace spoctree
