// A million rays through unions of boxes on a lattice, straight and sheared: in faces, along edges,
// through edges and vertices, from anywhere. Each answer, at every level, must be that of the ray
// or of one beside it, as the lattice tells in integers.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <set>
#include <string>

#include "common/tree/model_queries.hpp"
#include "server/build/build_octree.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/lattice_solid.hpp"
#include "tests/support/voxels.hpp"

namespace spoctree {
namespace {

/// Where the lattice lies: its steps along the three axes, in model coordinates.
struct Placement {
  const char* name;
  glm::dmat3 steps;
  Vec3 origin;
  double slack = 0;  ///< in times, for the rounding of points

  Vec3 at(double x, double y, double z) const {
    return origin + x * steps[0] + y * steps[1] + z * steps[2];
  }
  /// Unit, across the lattice planes of an axis.
  Vec3 normal(int axis) const {
    return glm::normalize(glm::cross(steps[(axis + 1) % 3], steps[(axis + 2) % 3]));
  }
};

constexpr glm::dmat3 kStraight{1, 0, 0, 0, 1, 0, 0, 0, 1};

std::vector<Placement> placements() {
  const glm::dmat3 turned{0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6};
  return {
      {"straight", kStraight, Vec3(0)},
      {"straight, not of binary fractions", 0.1 * kStraight, {0.7, 1000.3, -0.1}, 1e-11},
      {"sheared by binary fractions", {1, 0, 0, 0.25, 1, 0, 0.5, -0.75, 1}, Vec3(0)},
      {"sheared", {1, 0.21, 0.4, 0.3, 0.9, 0, -0.17, 0, 1.1}, {0.1, 0.2, 0.3}, 1e-13},
      {"turned", 0.7 * turned, {3.3, -2.1, 0.4}, 1e-13},
      {"turned and sheared", turned * glm::dmat3{1, 0, 0, 0.3, 1, 0, 0, -0.7, 1}, Vec3(0), 1e-13},
  };
}

LatticeRay draw_ray(Random& random, int side) {
  LatticeRay ray;
  for (int& o : ray.origin) {
    o = static_cast<int>(random.below(static_cast<std::uint32_t>(4 * side + 9))) - 4;
    if (random.chance(0.5)) o = (o + 4) / 4 * 4 - 4;
  }
  const std::uint32_t kind = random.below(8);
  const auto any_way = [&](int size) { return random.chance(0.5) ? size : -size; };
  const std::size_t axis = random.below(3);
  if (kind < 5) {
    ray.direction[axis] = any_way(1);
  } else if (kind == 5) {
    ray.direction = {any_way(1), any_way(1), any_way(1)};
    ray.direction[axis] = 0;
  } else {
    while (ray.direction == std::array{0, 0, 0}) {
      for (int& d : ray.direction) d = static_cast<int>(random.below(7)) - 3;
    }
  }
  return ray;
}

class RayTrial {
 public:
  RayTrial(const LatticeSolid& solid, const Placement& placement)
      : solid_(solid), placement_(placement), is_straight_(placement.steps[1][0] == 0) {
    for (int axis = 0; axis < 3; ++axis) normals_[axis] = placement.normal(axis);
  }

  /// What the ray and those beside it meet first.
  std::string describe(const LatticeRay& ray) const {
    std::set<std::string> texts;
    for (const auto& way : ways_aside()) texts.insert(text_of(solid_.first_crossing(ray, way)));
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
    return all;
  }

  /// True if the answer is that of the ray or of one beside it.
  bool is_right(const LatticeRay& ray, const RayAnswer& answer) const {
    static const auto kWays = ways_aside();
    for (const auto& way : kWays) {
      if (agrees(answer, solid_.first_crossing(ray, way), ray)) return true;
    }
    if (!is_in_plane(ray) && agrees(answer, solid_.first_crossing(ray), ray)) return true;
    if (is_straight_) return false;
    // Where planes are rounded, a ray that starts on one may start before it.
    for (const auto& way : kWays) {
      if (agrees(answer, solid_.first_crossing(ray, way, true), ray)) return true;
    }
    return false;
  }

  bool agrees(const RayAnswer& answer, const std::optional<LatticeCrossing>& right,
              const LatticeRay& ray) const {
    constexpr double kSlack = 1e-11;
    using Kind = RayAnswer::Kind;
    if (!right) {
      return answer.kind == Kind::Miss || (answer.kind == Kind::Between && std::isinf(answer.last));
    }
    const double time =
        static_cast<double>(right->numerator) / static_cast<double>(right->denominator);
    if (answer.kind == Kind::Miss) return false;
    if (answer.kind == Kind::Between) {
      return answer.first <= time + placement_.slack && time - placement_.slack <= answer.last;
    }
    const int d = ray.direction[static_cast<std::size_t>(right->axis)];
    const Vec3 normal = ((d > 0) == right->enters ? -1.0 : 1.0) * normals_[right->axis];
    return std::abs(answer.first - time) <= kSlack && answer.last == answer.first &&
           glm::length(answer.normal - normal) < 1e-9;
  }

 private:
  static bool is_in_plane(const LatticeRay& ray) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (ray.direction[axis] == 0 && ray.origin[axis] % 4 == 0) return true;
    }
    return false;
  }

  static std::string text_of(const std::optional<LatticeCrossing>& crossing) {
    if (!crossing) return "miss";
    const double time =
        static_cast<double>(crossing->numerator) / static_cast<double>(crossing->denominator);
    return std::to_string(time) + " across " + "xyz"[crossing->axis];
  }

  const LatticeSolid& solid_;
  const Placement& placement_;
  const bool is_straight_;
  Vec3 normals_[3];
};

/// Asks rays at the levels of a tree, and counts.
class RayTrials {
 public:
  /// `in_model(index, origin, direction)` answers a ray.
  template <class Ask>
  void ask(const RayTrial& trial, const Placement& placement,
           const std::vector<QueryIndex>& indices, Random& random, int side, int rays,
           const Ask& ask_one) {
    for (int r = 0; r < rays; ++r) {
      const LatticeRay ray = draw_ray(random, side);
      const auto& o = ray.origin;
      const auto& d = ray.direction;
      const Vec3 origin = placement.at(o[0] * 0.25, o[1] * 0.25, o[2] * 0.25);
      const Vec3 direction = placement.steps * Vec3(d[0], d[1], d[2]);
      ++asked_;
      // Early levels for some: each has few.
      const std::size_t first = r % 4 == 0 ? 0 : indices.size() - 1;
      for (std::size_t level = first; level < indices.size(); ++level) {
        const RayAnswer answer = ask_one(indices[level], origin, direction);
        ++counts_[static_cast<int>(answer.kind)];
        if (trial.is_right(ray, answer)) continue;
        if (++wrong_ > 20) continue;
        ADD_FAILURE() << placement.name << ", level " << level << " of " << indices.size() - 1
                      << ", from " << o[0] << ' ' << o[1] << ' ' << o[2] << " quarters along "
                      << d[0] << ' ' << d[1] << ' ' << d[2] << ": kind "
                      << static_cast<int>(answer.kind) << ' ' << answer.first << ' ' << answer.last
                      << " normal " << answer.normal.x << ' ' << answer.normal.y << ' '
                      << answer.normal.z << "; right: " << trial.describe(ray);
      }
    }
  }

  void expect_none_wrong(std::size_t least) const {
    EXPECT_EQ(wrong_, 0u) << "of " << asked_;
    EXPECT_GE(asked_, least);
    for (const std::size_t count : counts_) EXPECT_GT(count, asked_ / 20);
  }

 private:
  std::size_t asked_ = 0;
  std::size_t wrong_ = 0;
  std::size_t counts_[3] = {0, 0, 0};
};

std::vector<QueryIndex> indices_of(const Octree& tree) {
  std::vector<QueryIndex> indices;
  for (std::uint32_t level = 0; level < tree.levels.size(); ++level) {
    indices.emplace_back(tree, level);
  }
  return indices;
}

Octree tree_of(const LatticeSolid& solid, const Placement& placement) {
  const auto place = [&](int x, int y, int z) { return placement.at(x, y, z); };
  const Solid imported = import_solid(solid.soup(place), placement.name, {});
  return build_octree(imported, SolidQueries(imported), {}).tree;
}

TEST(LatticeRays, AreAnsweredAsTheyOrRaysBesideThemAre) {
  RayTrials trials;
  for (int k = 0; k < 30; ++k) {
    Random random(static_cast<std::uint64_t>(k));
    const int side = 4 + k % 5;
    const LatticeSolid solid(random, side, 2 + k % 7);
    for (const Placement& placement : placements()) {
      SCOPED_TRACE("solid " + std::to_string(k));
      const Octree tree = tree_of(solid, placement);
      trials.ask(RayTrial(solid, placement), placement, indices_of(tree), random, side, 6000,
                 first_hit_in_model);
    }
  }
  trials.expect_none_wrong(1'000'000);
}

// Walls of cells in all faces, and in all planes of the lattice besides.
TEST(LatticeRays, AreAnsweredSoInTreesOfCubesToo) {
  RayTrials trials;
  for (int k = 0; k < 20; ++k) {
    Random random(static_cast<std::uint64_t>(k));
    const LatticeSolid solid(random, 8, 2 + k % 9);
    const Octree tree = tree_of(Voxels{3, [&](int x, int y, int z) { return solid(x, y, z); }});
    const Placement placement{"cells", 0.25 * kStraight, Vec3(-1)};
    trials.ask(RayTrial(solid, placement), placement, indices_of(tree), random, 8, 5000,
               [](const QueryIndex& index, Vec3 origin, Vec3 direction) {
                 return index.first_hit({origin, direction});
               });
  }
  trials.expect_none_wrong(100'000);
}

// Faces across an axis are not rounded, so a ray just beside one is not in it.
TEST(LatticeRays, AreOnTheirOwnSideOfFacesAcrossAnAxis) {
  const Placement placement = placements().front();
  int asked = 0;
  for (int k = 0; k < 20; ++k) {
    Random random(static_cast<std::uint64_t>(k));
    const LatticeSolid solid(random, 6, 5);
    const Octree tree = tree_of(solid, placement);
    const double step = 0x1p-51 * tree.universe.scale();
    const QueryIndex index(tree);
    const RayTrial trial(solid, placement);
    for (int r = 0; r < 3000; ++r) {
      LatticeRay ray;
      for (int& o : ray.origin) o = static_cast<int>(random.below(8)) * 4 - 4;
      const std::size_t axis = random.below(3);
      ray.direction[axis] = random.chance(0.5) ? 1 : -1;
      ray.origin[axis] += 2;
      std::array<int, 3> aside{1, 10, 100};
      Vec3 origin(ray.origin[0] * 0.25, ray.origin[1] * 0.25, ray.origin[2] * 0.25);
      for (std::size_t i = 0; i < 3; ++i) {
        if (random.chance(0.5)) aside[i] = -aside[i];
        if (i != axis) origin[static_cast<int>(i)] += aside[i] > 0 ? step : -step;
      }
      const Vec3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
      const RayAnswer answer = first_hit_in_model(index, origin, direction);
      EXPECT_TRUE(trial.agrees(answer, solid.first_crossing(ray, aside), ray));
      ++asked;
    }
  }
  EXPECT_EQ(asked, 60'000);
}

}  // namespace
}  // namespace spoctree
