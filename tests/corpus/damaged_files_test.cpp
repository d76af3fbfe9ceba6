// Files cut short and files with a byte changed, some of them of every kind: with and without
// repair, none crashes the server or costs more than a file may. All of them: damage_campaign.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/damage.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;
using namespace mesh_test;

// A ball of triangles in every format.
class BallFile {
 public:
  BallFile() : ball_(model::make_model("sphere", 6)) {}

  std::string off() const { return model::to_off(ball_); }

  std::string obj() const {
    std::string text;
    for (const glm::dvec3& p : ball_.points) text.append("v ").append(numbers(p)).append("\n");
    for (const auto& t : triangles()) {
      text += "f";
      for (const std::uint32_t corner : t)
        text.append(" ").append(std::to_string(corner + 1)).append("/1");
      text += "\n";
    }
    return text;
  }

  std::string text_stl() const {
    std::string text = "solid ball\n";
    for (const auto& t : triangles()) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const std::uint32_t corner : t)
        text.append("vertex ").append(numbers(ball_.points[corner])).append("\n");
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
  }

  std::string binary_stl_file() const {
    std::vector<std::vector<glm::dvec3>> facets;
    for (const auto& t : triangles()) {
      facets.emplace_back();
      for (const std::uint32_t corner : t) facets.back().push_back(ball_.points[corner]);
    }
    return binary_stl("", facets);
  }

  std::string text_ply() const {
    std::string text = ply_header("ascii");
    for (const glm::dvec3& p : ball_.points) text += numbers(p) + "\n";
    for (const auto& t : triangles()) {
      text += "3";
      for (const std::uint32_t corner : t) text.append(" ").append(std::to_string(corner));
      text += "\n";
    }
    return text;
  }

  std::string binary_ply() const {
    std::string bytes = ply_header("binary_little_endian");
    for (const glm::dvec3& p : ball_.points) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, p[axis]);
    }
    for (const auto& t : triangles()) {
      append(bytes, std::uint8_t{3});
      for (const std::uint32_t corner : t) append(bytes, static_cast<std::int32_t>(corner));
    }
    return bytes;
  }

 private:
  static std::string numbers(const glm::dvec3& p) {
    std::string text = std::to_string(p.x);
    for (const double value : {p.y, p.z}) text.append(" ").append(std::to_string(value));
    return text;
  }

  std::vector<std::vector<std::uint32_t>> triangles() const {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (const model::Loop& face : ball_.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        triangles.push_back({face[0], face[i], face[i + 1]});
      }
    }
    return triangles;
  }

  std::string ply_header(const std::string& encoding) const {
    return "ply\nformat " + encoding + " 1.0\nelement vertex " +
           std::to_string(ball_.points.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
           std::to_string(triangles().size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  }

  model::PolygonMesh ball_;
};

void expect_harmless(const std::string& name, MeshFormat format, const std::string& bytes,
                     std::size_t cases, DamageReport& sum) {
  // A prime near it, so that the places fall on all parts of rows and numbers.
  std::size_t step = std::max<std::size_t>(1, 2 * bytes.size() / cases);
  if (step > 1) step |= 1;
  std::vector<Damage> damages = every_damage(bytes.size(), step);
  damages.push_back({});
  DamageOptions options;
  options.build_every = 10;
  for (const bool is_repaired : {false, true}) {
    options.repair = is_repaired;
    const DamageReport report = judge_damaged(name, format, bytes, damages, options);
    for (const std::string& failure : report.failures) ADD_FAILURE() << failure;
    EXPECT_EQ(report.files, damages.size());
    sum += report;
  }
}

TEST(DamagedFiles, OfAnyFormatAreHarmless) {
  const BallFile ball;
  DamageReport sum;
  expect_harmless("ball.off", MeshFormat::Off, ball.off(), 2000, sum);
  expect_harmless("ball.obj", MeshFormat::Obj, ball.obj(), 2000, sum);
  expect_harmless("text.stl", MeshFormat::Stl, ball.text_stl(), 2000, sum);
  expect_harmless("binary.stl", MeshFormat::Stl, ball.binary_stl_file(), 2000, sum);
  expect_harmless("text.ply", MeshFormat::Ply, ball.text_ply(), 2000, sum);
  expect_harmless("binary.ply", MeshFormat::Ply, ball.binary_ply(), 2000, sum);
  // The undamaged files are solids, and a changed digit makes another one.
  EXPECT_GT(sum.solids, 100u);
  EXPECT_GT(sum.built, 10u);
  EXPECT_LT(sum.solids, sum.files);
}

TEST(DamagedFiles, OfRealMeshesAreHarmless) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  constexpr std::uintmax_t kLargestFile = 100'000;
  std::vector<fs::path> paths;
  for (const char* sub : {"broken", "format"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / sub)) {
      if (entry.file_size() <= kLargestFile) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  EXPECT_GT(paths.size(), 40u);
  DamageReport sum;
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    expect_harmless(path.filename(), *format_of_extension(path), bytes, 120, sum);
  }
  EXPECT_GT(sum.solids, 100u);
}

}  // namespace
}  // namespace spoctree
