// Meshes that others made, where the folder of them is there (environment variable
// SPOCTREE_MESHES): odd but valid files, files that no reader may accept, and the counts of the
// folder's own table.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "server/mesh/read_mesh.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

struct Counts {
  std::size_t vertices;  // different points that faces use
  std::size_t faces;
};

class MeshCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = meshes_folder();
    if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
    folder_ = folder;
  }

  // Columns "file" (0), "V" (2, before and after merging: "606→136") and "F" (3) of TABLE.md.
  std::map<std::string, Counts> table() const {
    std::map<std::string, Counts> counts;
    std::ifstream file(folder_ / "TABLE.md");
    for (std::string line; std::getline(file, line);) {
      std::istringstream row(line);
      std::string cell, name, vertices, faces;
      std::getline(row, cell, '|');
      std::getline(row, name, '|');
      std::getline(row, cell, '|');
      std::getline(row, vertices, '|');
      std::getline(row, faces, '|');
      const std::size_t arrow = vertices.find("→");
      if (arrow != std::string::npos) vertices.erase(0, arrow + std::string("→").size());
      if (name.find('.') == std::string::npos) continue;
      name = name.substr(1, name.size() - 2);
      counts[name] = {std::strtoul(vertices.c_str(), nullptr, 10),
                      std::strtoul(faces.c_str(), nullptr, 10)};
    }
    return counts;
  }

  std::filesystem::path folder_;
};

TEST_F(MeshCorpus, CleanMeshesHaveTheCountsOfTheTable) {
  const auto expected = table();
  std::size_t files = 0;
  for (const char* sub :
       {"big", "cad", "convex", "high-genus", "multi", "nested", "polygons", "scan", "thin"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / sub)) {
      const std::string name = entry.path().filename();
      ASSERT_TRUE(expected.contains(name)) << name;
      const PolygonSoup soup = read_mesh(entry.path());
      EXPECT_EQ(soup.points.size(), expected.at(name).vertices) << name;
      EXPECT_EQ(soup.face_count(), expected.at(name).faces) << name;
      EXPECT_EQ(broken_promise(soup), "") << name;
      ++files;
    }
  }
  EXPECT_GT(files, 0U);
}

TEST_F(MeshCorpus, OddButValidFilesAreReadRight) {
  const std::map<std::string, Counts> expected = {
      {"obj-unmerged-vertices_hellbot_268f.obj", {136, 268}},
      {"obj_no-final-newline_6f.obj", {8, 6}},
      {"off_4OFF-4D-vertices_6f.off", {8, 6}},
      {"off_COFF-like-vertex-colours_4f.off", {8, 4}},
      {"off_extra-face-lines-and-unused-vertices_7f.off", {8, 7}},  // 3 of its 11 are unused
      {"off_face-colours_6f.off", {8, 6}},
      {"off_no-OFF-keyword_6f.off", {8, 6}},
      {"ply-binary_cube_12f.ply", {8, 12}},
      {"stl-ascii_sphere_320f.stl", {162, 320}},
      {"stl-binary_header-starts-with-solid_46f.stl", {25, 46}},
  };
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "format")) {
    const std::string name = entry.path().filename();
    const PolygonSoup soup = read_mesh(entry.path());
    EXPECT_EQ(broken_promise(soup), "") << name;
    if (!expected.contains(name)) continue;
    EXPECT_EQ(soup.points.size(), expected.at(name).vertices) << name;
    EXPECT_EQ(soup.face_count(), expected.at(name).faces) << name;
  }
}

TEST_F(MeshCorpus, HomogeneousVerticesMakeATrapezoid) {
  const PolygonSoup soup = read_mesh(folder_ / "format/off_4OFF-4D-vertices_6f.off");
  EXPECT_EQ(soup.points[0], glm::dvec3(-1, -1, 1));
  EXPECT_EQ(soup.points[2], glm::dvec3(0.5, 0.5, 0.5));
  EXPECT_EQ(soup.points[7], glm::dvec3(0.5, -0.5, -0.5));
}

TEST_F(MeshCorpus, VertexColoursAreNotTakenForPoints) {
  const PolygonSoup soup = read_mesh(folder_ / "format/off_COFF-like-vertex-colours_4f.off");
  for (const glm::dvec3& point : soup.points) EXPECT_EQ(point.z, 0);
  EXPECT_EQ(faces_of(soup).back(), (std::vector<std::uint32_t>{1, 3, 4, 5, 7}));
}

TEST_F(MeshCorpus, BrokenFilesAreRejectedByNameAndPlace) {
  const std::map<std::string, std::string> expected = {
      {"made_face-count-too-big.off", ":1572: the file ends after 1050 of 1075 faces"},
      {"made_face-index-out-of-range.off", ":532: face 10 uses vertex 524, the file has 519"},
      {"made_inf-coordinate.off", ":10: vertex 7: 'inf'"},
      {"made_nan-coordinate.off", ":103: vertex 100: 'nan'"},
      {"made_negative-index.off", ":532: face 10 uses vertex -1"},
      {"made_truncated-binary.stl", ": the file is neither text STL"},
      {"made_truncated-in-faces.off", ":1166: face 643"},
      {"made_vertex-count-too-small.off", ":519: face 0 begins with"},
      {"parse_empty-face-line.obj", ":23: the face has 0 corners"},
      {"parse_empty-solid.stl", ":4: the file has no facets"},
      {"parse_face-line-over-1024-chars-repeating-vertices_6f.obj", ":24: the face uses vertex 1"},
      {"parse_header-without-edge-count_missing-faces.off", ":6: face 0 has 0 corners"},
      {"parse_index-out-of-range.obj", ":28: the face uses vertex 0, the file has 8"},
      {"parse_invalid-vertex.stl", ":89: facet 12: 'blah'"},
      {"parse_ply-no-faces.ply", ": the PLY header has no element 'face'"},
      {"parse_too-many-vertices.stl", ":91: facet 12 has more than 3 corners"},
      {"parse_unparseable.stl", ":4: facet 0: "},
      {"parse_vertex-count-353535235358.off", ":2: the header claims 353535235358 vertices"},
      {"parse_zero-bytes.off", ": the file is empty"},
  };
  for (const auto& [name, message] : expected) {
    const auto path = folder_ / "broken" / name;
    const std::string text = error_of([&] { read_mesh(path); });
    EXPECT_TRUE(text.starts_with(path.string() + message)) << text;
  }
}

TEST_F(MeshCorpus, FilesWhoseShapeIsBrokenAreStillRead) {
  for (const char* name : {"made_duplicate-face.off", "made_one-face-flipped.off",
                           "made_one-face-missing.off", "open_cube_10f.off",
                           "nonmanifold-edge_back-to-back_10f.stl", "degenerate_sliding_8f.off"}) {
    EXPECT_EQ(broken_promise(read_mesh(folder_ / "broken" / name)), "") << name;
  }
}

TEST_F(MeshCorpus, EveryBrokenFileIsReadOrRejected) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "broken")) {
    try {
      EXPECT_EQ(broken_promise(read_mesh(entry.path())), "") << entry.path();
    } catch (const BadInput& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(entry.path().string())) << error.what();
    }
  }
}

}  // namespace
}  // namespace spoctree
