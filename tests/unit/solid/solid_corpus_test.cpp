// Meshes that others made, where the folder of them is there (environment variable
// SPOCTREE_MESHES): the clean ones import with the planes that the folder's table counts, the
// broken ones are refused for what their names say.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "common/base/errors.hpp"
#include "server/mesh/read_mesh.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;
namespace fs = std::filesystem;

class SolidCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = meshes_folder();
    if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
    folder_ = folder;
  }

  // Column "planes 1e-9/1e-6" (13) of TABLE.md, before the slash.
  std::map<std::string, std::size_t> plane_counts() const {
    std::map<std::string, std::size_t> counts;
    std::ifstream file(folder_ / "TABLE.md");
    for (std::string line; std::getline(file, line);) {
      std::istringstream row(line);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
      if (cells.size() < 15 || cells[1].find('.') == std::string::npos) continue;
      const std::size_t planes = std::strtoul(cells[14].c_str(), nullptr, 10);
      if (planes > 0) counts[cells[1].substr(1, cells[1].size() - 2)] = planes;
    }
    return counts;
  }

  std::vector<fs::path> files(const std::string& subfolder) const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder_ / subfolder)) {
      all.push_back(entry.path());
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  // What reading and importing say of a file; empty if they say nothing.
  static std::string error_of(const fs::path& path) {
    try {
      import_solid(read_mesh(path), path.filename().string(), {});
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(SolidCorpus, CleanMeshesAreSound) {
  std::size_t count = 0;
  for (const char* subfolder :
       {"convex", "cad", "high-genus", "multi", "nested", "thin", "polygons"}) {
    for (const fs::path& path : files(subfolder)) {
      SCOPED_TRACE(path.string());
      const PolygonSoup soup = read_mesh(path);
      if (soup.face_count() > 5000) continue;  // rational arithmetic is slow
      expect_sound(import_solid(soup, path.string(), {}));
      ++count;
    }
  }
  EXPECT_GT(count, 40u);
}

TEST_F(SolidCorpus, PlanesAreAsManyAsTheTableSays) {
  const auto expected = plane_counts();
  std::size_t count = 0;
  for (const char* subfolder : {"convex", "cad", "scan", "high-genus", "multi", "nested", "thin"}) {
    for (const fs::path& path : files(subfolder)) {
      const auto entry = expected.find(path.filename().string());
      if (entry == expected.end()) continue;
      SCOPED_TRACE(path.string());
      const Solid solid = import_solid(read_mesh(path), path.string(), {1e-9});
      // Which triangles near the tolerance are merged depends on where one begins.
      const double table = static_cast<double>(entry->second);
      EXPECT_NEAR(static_cast<double>(solid.planes.size()), table, 1 + 0.05 * table);
      ++count;
    }
  }
  EXPECT_GT(count, 70u);
}

TEST_F(SolidCorpus, KnownPlanesOfKnownShapes) {
  const auto planes = [&](const char* name) {
    return import_solid(read_mesh(folder_ / name), name, {}).planes.size();
  };
  EXPECT_EQ(planes("convex/cube_6planes_1728tri.off"), 6u);
  EXPECT_EQ(planes("convex/cube_6quads.off"), 6u);
  EXPECT_EQ(planes("convex/cylinder_360sides_1440f.stl"), 362u);
  EXPECT_EQ(planes("convex/cone_256planes-through-apex_510f.stl"), 257u);
  EXPECT_EQ(planes("convex/octahedron_8f.off"), 8u);
}

TEST_F(SolidCorpus, BrokenMeshesAreRefusedForWhatTheirNamesSay) {
  const std::map<std::string, std::string> fault_of_name = {
      {"open_", "not closed: "},
      {"nonmanifold-edge", "with more than two faces"},
      {"nonmanifold-vertex", "more than one fan"},
      {"orientation_", "not consistently oriented: "},
      {"selfint_", " of triangles meet, "},
      {"degenerate_", "degenerate: "},
      {"made_duplicate-face", "with more than two faces"},
      {"made_one-face-flipped", "not consistently oriented: 3 edges"},
      {"made_one-face-missing", "not closed: 3 border edges"}};
  std::size_t count = 0;
  for (const fs::path& path : files("broken")) {
    const std::string name = path.filename().string();
    SCOPED_TRACE(name);
    for (const auto& [prefix, fault] : fault_of_name) {
      if (name.rfind(prefix, 0) != 0) continue;
      const std::string error = error_of(path);
      EXPECT_EQ(error.rfind(name + ": ", 0), 0u) << error;
      // This one has triangles without area, too, which are looked for first.
      const bool is_degenerate = name.find("back-to-back") != std::string::npos;
      EXPECT_NE(error.find(is_degenerate ? "degenerate: " : fault), std::string::npos) << error;
      ++count;
    }
    if (name.rfind("inward_", 0) == 0) {
      const Solid solid = import_solid(read_mesh(path), name, {});
      EXPECT_TRUE(solid.report.was_turned);
      EXPECT_GT(solid.volume, 0);
      ++count;
    } else if (name.rfind("collapsed-faces_", 0) == 0) {
      // Its six faces without three different corners are left out; the rest is closed.
      const PolygonSoup soup = read_mesh(path);
      EXPECT_EQ(soup.collapsed.count, 6u);
      EXPECT_EQ(soup.collapsed.first, 3976u);
      const Solid solid = import_solid(soup, name, {});
      EXPECT_EQ(solid.vertices.size(), 3132u);
      EXPECT_EQ(solid.triangles.size(), 6508u);
      ++count;
    } else if (name == "made_zero-count.stl" || name == "made_count-4294967295.stl") {
      // The header's count alone is wrong: all facets are there.
      EXPECT_EQ(import_solid(read_mesh(path), name, {}).triangles.size(), 620u);
      ++count;
    } else {
      EXPECT_NE(error_of(path), "");
    }
  }
  EXPECT_GT(count, 25u);
}

TEST_F(SolidCorpus, DefectsAreCountedAsTheTableCountsThem) {
  const std::map<std::string, std::string> expected = {
      {"open_stanford-bunny-original_69451f.ply", "not closed: 223 border edges"},
      {"open_elephant-with-holes_4463f.off", "not closed: 1353 border edges"},
      {"open_mech-holes-shark_10192f.off", "not closed: 304 border edges"},
      {"orientation_boeing_2564f.off", "978 edges whose two faces disagree"},
      {"orientation_cube-shuffled_12f.off", "9 edges whose two faces disagree"},
      {"nonmanifold-edge_trimaker_19852f.stl", "312 edges with more than two faces"},
      {"nonmanifold-vertex_artillery_15494f.stl", "around 1 vertex form"},
      {"selfint_bones_26comp_4204f.off", "366 pairs of triangles"},
      {"selfint_man_34986f.off", "848 pairs of triangles"},
      {"selfint_bunny-glmark2_69666f.obj", "2 pairs of triangles"},
      {"selfint_tardis_3636f.stl", "6 pairs of triangles"},
      {"degenerate_circuit_900f.stl", "2 faces without area"}};
  for (const auto& [name, fault] : expected) {
    SCOPED_TRACE(name);
    const std::string error = error_of(folder_ / "broken" / name);
    EXPECT_NE(error.find(fault), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace spoctree
