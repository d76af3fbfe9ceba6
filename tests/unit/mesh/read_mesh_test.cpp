#include "server/mesh/read_mesh.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "server/mesh/limits.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace spoctree {
namespace {

using namespace mesh_test;

class ReadMesh : public ::testing::Test {
 protected:
  ReadMesh() {
    folder_ = std::filesystem::temp_directory_path() /
              ("spoctree-read-mesh-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~ReadMesh() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

std::string error(const std::filesystem::path& path) {
  return error_of([&] { read_mesh(path); });
}

TEST_F(ReadMesh, TakesTheFormatFromTheExtensionInAnyCase) {
  EXPECT_EQ(read_mesh(write("a.off", kTetrahedronOff)).face_count(), 4U);
  EXPECT_EQ(read_mesh(write("a.OBJ", kTetrahedronObj)).face_count(), 4U);
  EXPECT_EQ(read_mesh(write("a.Stl", kTetrahedronTextStl)).face_count(), 4U);
  EXPECT_EQ(read_mesh(write("b.stl", tetrahedron_binary_stl())).face_count(), 4U);
  EXPECT_EQ(read_mesh(write("a.ply", kTetrahedronTextPly)).face_count(), 4U);
  EXPECT_EQ(read_mesh(write("b.ply", tetrahedron_binary_ply(ByteOrder::BigEndian))).face_count(),
            4U);
}

TEST_F(ReadMesh, SkipsAByteOrderMark) {
  // Taken for part of the first word it would cost an OBJ file its first vertex.
  const std::string mark = "\xef\xbb\xbf";
  const std::pair<const char*, std::string> files[] = {
      {"a.off", kTetrahedronOff},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"},
      {"a.stl", kTetrahedronTextStl},
      {"a.ply", kTetrahedronTextPly},
      {"b.ply", tetrahedron_binary_ply(ByteOrder::BigEndian)}};
  for (const auto& [name, bytes] : files) {
    const PolygonSoup plain = read_mesh(write(name, bytes));
    const PolygonSoup marked = read_mesh(write(name, mark + bytes));
    EXPECT_EQ(marked.points, plain.points) << name;
    EXPECT_EQ(marked.corners, plain.corners) << name;
    EXPECT_EQ(marked.points.size(), 4U) << name;
  }
}

TEST_F(ReadMesh, RejectsUnknownExtensions) {
  for (const char* name : {"a.step", "a", "a.off.gz", ".off"}) {
    const auto path = write(name, "what is this?");
    EXPECT_EQ(error(path), path.string() +
                               ": unknown mesh format (the name should end in .off, .obj, .stl or "
                               ".ply)");
    EXPECT_EQ(error(write(name, kTetrahedronOff)),
              path.string() +
                  ": unknown mesh format (the name should end in .off: it is an OFF "
                  "mesh)");
  }
}

TEST_F(ReadMesh, RejectsContentOfAnotherFormat) {
  const std::pair<std::string, std::string> contents[] = {
      {"an OFF mesh: its name should end in .off", kTetrahedronOff},
      {"an OBJ mesh: its name should end in .obj", kTetrahedronObj},
      {"an STL mesh: its name should end in .stl", kTetrahedronTextStl},
      {"an STL mesh: its name should end in .stl", tetrahedron_binary_stl()},
      {"an STL mesh: its name should end in .stl", tetrahedron_binary_stl() + "more"},
      {"a PLY mesh: its name should end in .ply", kTetrahedronTextPly}};
  for (const auto& [content, bytes] : contents) {
    for (const char* name : {"a.off", "a.obj", "a.stl", "a.ply"}) {
      if (content.ends_with(std::string(name).substr(1))) continue;
      const auto path = write(name, bytes);
      EXPECT_EQ(error(path), path.string() + ": is " + content);
    }
  }
  for (const char* name : {"a.off", "a.stl", "a.ply"}) {
    EXPECT_NE(error(write(name, kTetrahedronObj)), "no error");
  }
}

TEST_F(ReadMesh, MergesPointsAndRemovesUnusedOnes) {
  const PolygonSoup soup =
      read_mesh(write("a.off",
                      "OFF\n8 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n9 9 9\n-0 0 0\n1 0 0\n0 1 0\n"
                      "3 0 2 1\n3 5 6 3\n3 5 3 7\n3 6 7 3\n"));
  EXPECT_EQ(soup.points, kTetrahedronPoints);
  EXPECT_EQ(faces_of(soup), kTetrahedronFaces);
}

TEST_F(ReadMesh, LeavesOutFacesThatCollapseWhenPointsAreMergedAndWhatOnlyTheyUse) {
  const PolygonSoup soup = read_mesh(
      write("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nf 2 3 4\nf 1 3 5\nf 2 4 4\n"));
  EXPECT_EQ(soup.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
  EXPECT_EQ(soup.collapsed.count, 2U);
  EXPECT_EQ(soup.collapsed.first, 1U);
}

TEST_F(ReadMesh, LeavesOutCornersThatRepeatTheOneBefore) {
  const PolygonSoup soup = read_mesh(
      write("a.off", "OFF 6 1 0\n0 0 0\n1 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n6 0 1 2 3 4 5\n"));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}}));
  EXPECT_EQ(soup.collapsed.count, 0U);
}

TEST_F(ReadMesh, RejectsPolygonsThatTouchThemselvesAtAPoint) {
  const auto path = write("a.off", "OFF 5 1 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n5 0 1 2 3 4\n");
  EXPECT_EQ(error(path), path.string() +
                             ": 1 polygon touches itself, first at the point "
                             "(1.000000, 0.000000, 0.000000)");
}

TEST_F(ReadMesh, LetsPolygonsTouchThemselvesByABridgeThatMergingFinds) {
  // A square with a square hole; the ends of the bridge stand twice, under numbers of their own.
  const PolygonSoup soup =
      read_mesh(write("a.off",
                      "OFF 10 1 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 0\n1 1 0\n1 2 0\n2 2 0\n2 1 0\n"
                      "1 1 0\n10 0 1 2 3 4 5 6 7 8 9\n"));
  EXPECT_EQ(soup.points.size(), 8U);
  EXPECT_EQ(soup.face(0).size(), 10U);
}

TEST_F(ReadMesh, RejectsOtherKindsOfFilesByName) {
  for (const char* name : {"a.obj", "a.stl", "a.ply", "a.off", "a.step", "a"}) {
    const auto path = write(name, "ISO-10303-21;\nHEADER;\n");
    EXPECT_EQ(error(path),
              path.string() + ": is a STEP file: export it as an STL, OBJ, OFF or PLY mesh");
  }
}

TEST_F(ReadMesh, RejectsFilesOfCollapsedFacesOnly) {
  const auto path = write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\nf 1 1 1\nf 2 1\n");
  EXPECT_EQ(error(path), path.string() + ": all 3 faces have fewer than three different corners");
}

TEST_F(ReadMesh, RejectsEmptyFiles) {
  for (const char* name : {"a.off", "a.obj", "a.stl", "a.ply"}) {
    const auto path = write(name, "");
    EXPECT_EQ(error(path), path.string() + ": the file is empty");
  }
}

TEST_F(ReadMesh, RejectsWhatIsNoReadableFile) {
  EXPECT_EQ(error(folder_ / "absent.off"),
            (folder_ / "absent.off").string() + ": cannot open: No such file or directory");
  std::filesystem::create_directory(folder_ / "folder.off");
  EXPECT_EQ(error(folder_ / "folder.off"),
            (folder_ / "folder.off").string() + ": not a regular file");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.off").c_str(), 0600), 0);
  EXPECT_EQ(error(folder_ / "pipe.off"), (folder_ / "pipe.off").string() + ": not a regular file");
}

TEST_F(ReadMesh, RejectsFilesOverTheSizeLimitWithoutReadingThem) {
  const auto path = write("huge.stl", "");
  std::filesystem::resize_file(path, mesh_limits::kMaxFileBytes + 1);  // sparse
  EXPECT_EQ(error(path),
            path.string() + ": the file has 4294967297 bytes, the limit is 4294967296");
}

TEST_F(ReadMesh, NamesFileAndLine) {
  const auto path = write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n");
  EXPECT_EQ(error(path), path.string() + ":5: vertex 2: 'x' is not a number");
}

}  // namespace
}  // namespace spoctree
