// Every model that the generator makes comes out of the chain as it went in, and every level on the
// way contains it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "client/rebuild/polygon_mesh.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/grid_planes.hpp"
#include "tests/support/hand_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

struct Case {
  std::string name;
  std::optional<int> size;
};

std::string title_of(const Case& tested) {
  std::string title = tested.name;
  if (tested.size) title.append(1, ' ').append(std::to_string(*tested.size));
  return title;
}

void PrintTo(const Case& tested, std::ostream* out) { *out << title_of(tested); }

/// All models by name, those of a range in several sizes.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& info : model::models()) {
    if (info.sizes.highest == 0) {
      all.push_back({std::string(info.name), {}});
      continue;
    }
    for (const int size : {info.sizes.lowest, info.sizes.lowest + 1, info.sizes.usual, 47}) {
      all.push_back({std::string(info.name), size});
    }
  }
  return all;
}

class Exactness : public testing::TestWithParam<Case> {};

TEST_P(Exactness, TheModelComesOutAsItWentInAndEveryLevelContainsIt) {
  const Case& tested = GetParam();
  const auto made = model::make_model(tested.name, tested.size);
  const PlainMesh mesh = parse_off_text(model::to_off(made));
  ChainOptions options;
  options.count_vertices = true;
  judge_chain(title_of(tested), to_soup(mesh), options);
}

// No coordinate is simple any more, nothing is parallel to an axis, and faces are as even as
// doubles can say.
TEST_P(Exactness, SoItIsTurnedScaledAndFarFromTheOrigin) {
  const Case& tested = GetParam();
  const auto made = model::make_model(tested.name, tested.size);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Random random(seed);
    const Vec3 x = random_direction(random);
    const Vec3 y = glm::normalize(glm::cross(x, random_direction(random)));
    const Vec3 z = glm::cross(x, y);
    const double scale = std::pow(10, random.between(-8, 8));
    const Vec3 shift = random_vector(random, scale * (seed % 2 == 0 ? 100 : 1e5));
    PlainMesh mesh = parse_off_text(model::to_off(made));
    for (Vec3& p : mesh.points) p = (x * p.x + y * p.y + z * p.z) * scale + shift;
    ChainOptions options;
    options.points = 500;
    options.surface_samples = 500;
    options.rebuild_levels_up_to = 500;
    options.count_vertices = true;
    judge_chain(title_of(tested) + " turned, seed " + std::to_string(seed), to_soup(mesh), options);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Exactness, testing::ValuesIn(cases()), [](const auto& tested) {
  std::string name = title_of(tested.param);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  return name;
});

/// The solid's tree under these rules, every level of it rebuilt.
void expect_rebuilt(const Solid& solid, const SpRules& rules, bool count_vertices) {
  const SolidQueries queries(solid);
  BuildOptions options;
  options.rules = rules;
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  PlainMesh input;
  input.points = solid.vertices;
  for (const SolidTriangle& t : solid.triangles) {
    input.faces.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
  }
  const Octree& tree = built.tree;
  for (std::uint32_t k = 0; k < tree.levels.size(); ++k) {
    const PlainMesh mesh =
        parse_off_text(to_off(make_polygon_mesh(rebuild_surface(tree, k), tree.universe)));
    const bool is_last = k + 1 == tree.levels.size();
    EXPECT_EQ(why_not_closed(mesh, is_last), "") << "level " << k;
    EXPECT_NEAR(volume_of(mesh), tree.levels[k].statement.outer_volume, 1e-9) << "level " << k;
    if (!is_last) continue;
    EXPECT_NEAR(volume_of(mesh), volume_of(input), 1e-9);
    EXPECT_NEAR(area_of(mesh), area_of(input), 1e-9);
    if (count_vertices) {
      EXPECT_EQ(mesh.points.size(), count_corners(input));
    }
  }
}

TEST(ExactnessOfDegenerateSolids, TheyAreRebuiltLevelByLevel) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Solid voxels = voxel_solid(random_voxels(seed % 8 == 0 ? 3 : 2, random));
    const Solid steep =
        height_field_solid(random_height_field(4, Vec3(-1), 0.5, -0.75, 0.25, 8, random));
    const Solid fine =
        height_field_solid(random_height_field(6, Vec3(-0.75), 0.25, -0.5, 0.0625, 20, random));
    for (const SpRules& rules : {SpRules{}, kPaperRules, SpRules{6, kMaxDepth}, SpRules{0, 1}}) {
      expect_rebuilt(voxels, rules, true);
      expect_rebuilt(steep, rules, true);
      expect_rebuilt(fine, rules, true);
    }
    // Nearly in one plane: what is a corner there is a matter of taste.
    const double unit = std::ldexp(1.0, -20 - static_cast<int>(seed) % 32);
    expect_rebuilt(height_field_solid(random_height_field(4, Vec3(-1), 0.5, 0.25, unit, 4, random)),
                   kPaperRules, false);
  }
}

}  // namespace
}  // namespace spoctree
