// Octrees from silhouettes, judged by projecting every cell: shares no code with how they are made.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/base/errors.hpp"
#include "common/program/threads.hpp"
#include "common/tree/validate.hpp"
#include "server/silhouettes/build_from_silhouettes.hpp"
#include "server/silhouettes/render_silhouette.hpp"
#include "server/silhouettes/state_levels.hpp"
#include "server/silhouettes/views.hpp"
#include "tests/support/cell_colours.hpp"
#include "tests/support/random.hpp"

namespace spoctree {
namespace {

using test::cell_colours;
using Cells = std::vector<std::uint8_t>;

constexpr Universe kCube{{0, 0, 0}, 0, 1};  // [-1, 1]^3

/// A convex body: the hull of some points, as triangles between all of them.
struct Body {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Body hull_of(std::vector<glm::dvec3> points) {
  Body body;
  body.points = std::move(points);
  const auto count = static_cast<std::uint32_t>(body.points.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = a + 1; b < count; ++b) {
      for (std::uint32_t c = b + 1; c < count; ++c) body.triangles.push_back({a, b, c});
    }
  }
  return body;
}

Body random_body(Random& random, std::size_t corners = 6) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < corners; ++i) {
    points.emplace_back(random.between(-0.9, 0.9), random.between(-0.9, 0.9),
                        random.between(-0.9, 0.9));
  }
  return hull_of(points);
}

Body tetrahedron() { return hull_of({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}); }

Body box(double half) {
  std::vector<glm::dvec3> points;
  for (int octant = 0; octant < 8; ++octant)
    points.push_back(half * glm::dvec3(towards_octant(octant)));
  return hull_of(points);
}

std::vector<Silhouette> silhouettes_of(const Body& body, int size) {
  std::vector<Silhouette> silhouettes;
  for (std::size_t view = 0; view < kViewCount; ++view) {
    silhouettes.push_back(
        {view, render_silhouette(all_views()[view], body.points, body.triangles, size, size)});
  }
  return silhouettes;
}

/// Every pixel black or white by chance, in blocks, so that all that happens happens often.
std::vector<Silhouette> random_silhouettes(Random& random, int size) {
  std::vector<Silhouette> silhouettes;
  for (std::size_t view = 0; view < kViewCount; ++view) {
    Silhouette silhouette{view, Mask(size, size)};
    silhouette.mask.pixels.assign(silhouette.mask.pixels.size(), 1);
    for (int hole = 0; hole < 6; ++hole) {
      const auto side = static_cast<std::uint32_t>(size);
      const int left = static_cast<int>(random.below(side));
      const int top = static_cast<int>(random.below(side));
      const int width = 1 + static_cast<int>(random.below(side / 4));
      for (int y = top; y < std::min(top + width, size); ++y) {
        for (int x = left; x < std::min(left + width, size); ++x) silhouette.mask.at(x, y) = 0;
      }
    }
    silhouettes.push_back(silhouette);
  }
  return silhouettes;
}

Octree tree_of(std::span<const Silhouette> silhouettes, SilhouetteOptions options = {},
               int depth = -1) {
  options.rules.max_depth = depth >= 0 ? depth : depth_of_pixels(silhouettes);
  return build_from_silhouettes(kCube, silhouettes, options).front();
}

std::vector<std::vector<NodeKind>> kinds_of(const Octree& tree) {
  std::vector<std::vector<NodeKind>> kinds;
  for (const Level& level : tree.levels) kinds.push_back(level.kinds);
  return kinds;
}

double volume_of(const Octree& tree) {
  double volume = 0;
  double cell = 8;
  for (const Level& level : tree.levels) {
    volume += cell * level.count_kinds()[static_cast<std::size_t>(NodeKind::Black)];
    cell /= 8;
  }
  return volume;
}

/// Where a mask is looked at directly: unit vectors of the picture, by name, written anew.
struct Picture {
  glm::dvec3 right;
  glm::dvec3 up;
  double half_width;
  double half_height;
};

Picture picture_of(std::string_view name) {
  const double s = 1 / std::numbers::sqrt2;
  if (name == "face-x") return {{0, 1, 0}, {0, 0, 1}, 1, 1};
  if (name == "face-y") return {{-1, 0, 0}, {0, 0, 1}, 1, 1};
  if (name == "face-z") return {{0, 1, 0}, {-1, 0, 0}, 1, 1};
  if (name == "edge-37") return {{-s, s, 0}, {0, 0, 1}, 1 / s, 1};
  if (name == "edge-15") return {{s, s, 0}, {0, 0, 1}, 1 / s, 1};
  if (name == "edge-57") return {{s, 0, -s}, {0, 1, 0}, 1 / s, 1};
  if (name == "edge-46") return {{s, 0, s}, {0, 1, 0}, 1 / s, 1};
  if (name == "edge-67") return {{0, -s, s}, {1, 0, 0}, 1 / s, 1};
  if (name == "edge-45") return {{0, -s, -s}, {1, 0, 0}, 1 / s, 1};
  const glm::dvec3 viewer(name == "corner-7" || name == "corner-5" ? 1 : -1,
                          name == "corner-7" || name == "corner-6" ? 1 : -1, 1);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), viewer));
  return {right, glm::normalize(glm::cross(viewer, right)), std::sqrt(2.0), std::sqrt(8.0 / 3)};
}

enum class Verdict { Out, In, Unsure };

/// What the pixels say on which the cell's eight corners' box in the picture lies, by more than
/// rounding, and those within `margin` pixels around.
Verdict look_up(const Silhouette& silhouette, const glm::dvec3& middle, double half,
                double margin) {
  const Picture picture = picture_of(all_views()[silhouette.view].name);
  const Mask& mask = silhouette.mask;
  double left = 1e9;
  double right = -1e9;
  double top = 1e9;
  double bottom = -1e9;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(middle.x + ((corner & 1) != 0 ? half : -half),
                       middle.y + ((corner & 2) != 0 ? half : -half),
                       middle.z + ((corner & 4) != 0 ? half : -half));
    const double x = (glm::dot(picture.right, p) / picture.half_width + 1) / 2 * mask.width;
    const double y = (1 - glm::dot(picture.up, p) / picture.half_height) / 2 * mask.height;
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  const auto first = [](double place) {
    return std::max(static_cast<int>(std::floor(place + 1e-9)), 0);
  };
  const auto last = [](double place, int size) {
    return std::min(static_cast<int>(std::ceil(place - 1e-9)) - 1, size - 1);
  };
  bool some = false;
  bool all = true;
  for (int y = first(top - margin); y <= last(bottom + margin, mask.height); ++y) {
    for (int x = first(left - margin); x <= last(right + margin, mask.width); ++x) {
      some = some || mask.at(x, y) != 0;
      all = all && mask.at(x, y) != 0;
    }
  }
  return all ? Verdict::In : some ? Verdict::Unsure : Verdict::Out;
}

/// Cells of which the direct test is sure, against the tree. Face and edge views leave no doubt at
/// the pixels' depth: a cell is black if any pixel that it projects onto is.
void expect_agreement(std::span<const Silhouette> silhouettes, int depth) {
  const Cells cells = cell_colours(tree_of(silhouettes, {}, depth), depth);
  const int side = 1 << depth;
  const double half = 1.0 / side;
  std::size_t sure = 0;
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const glm::dvec3 middle(2 * half * (x + 0.5) - 1, 2 * half * (y + 0.5) - 1,
                                2 * half * (z + 0.5) - 1);
        Verdict verdict = Verdict::In;
        for (const Silhouette& silhouette : silhouettes) {
          const bool is_corner = all_views()[silhouette.view].kind == ViewKind::Corner;
          Verdict one = look_up(silhouette, middle, half, is_corner ? 1 : 0);
          if (one == Verdict::Unsure && !is_corner) one = Verdict::In;
          if (one == Verdict::Out) verdict = one;
          if (one == Verdict::Unsure && verdict == Verdict::In) verdict = one;
        }
        if (verdict == Verdict::Unsure) continue;
        ++sure;
        const auto index = static_cast<std::size_t>(x + side * (y + side * z));
        ASSERT_EQ(cells[index] == 1, verdict == Verdict::In)
            << "cell " << x << " " << y << " " << z << " of " << side;
      }
    }
  }
  EXPECT_GT(sure, cells.size() / 2);
}

TEST(SilhouetteOctree, IsThatOfADirectTestInEveryView) {
  Random random(11);
  for (int round = 0; round < 4; ++round) {
    const std::vector<Silhouette> silhouettes =
        round % 2 == 0 ? silhouettes_of(random_body(random), 32) : random_silhouettes(random, 32);
    for (const Silhouette& silhouette : silhouettes) expect_agreement(std::span(&silhouette, 1), 5);
  }
}

TEST(SilhouetteOctree, IsThatOfADirectTestForAllViewsTogether) {
  Random random(12);
  for (int round = 0; round < 3; ++round)
    expect_agreement(silhouettes_of(random_body(random, 7), 64), 6);
}

TEST(SilhouetteOctree, HasNoSiblingsOfOneColour) {
  Random random(13);
  for (int round = 0; round < 6; ++round) {
    const Octree tree = tree_of(random_silhouettes(random, 32));
    EXPECT_EQ(validate(tree), std::vector<std::string>{});
    for (std::size_t k = 1; k < tree.levels.size(); ++k) {
      const std::vector<NodeKind>& kinds = tree.levels[k].kinds;
      for (std::size_t i = 0; i < kinds.size(); i += 8) {
        const bool same =
            std::all_of(&kinds[i], &kinds[i] + 8, [&](NodeKind kind) { return kind == kinds[i]; });
        EXPECT_FALSE(same && kinds[i] != NodeKind::Grey);
      }
    }
  }
}

TEST(SilhouetteOctree, DoesNotDependOnTheOrderOfViews) {
  Random random(14);
  for (int round = 0; round < 4; ++round) {
    std::vector<Silhouette> silhouettes = random_silhouettes(random, 32);
    const auto kinds = kinds_of(tree_of(silhouettes));
    for (std::size_t i = silhouettes.size(); i > 1; --i)
      std::swap(silhouettes[i - 1], silhouettes[random.below(static_cast<std::uint32_t>(i))]);
    EXPECT_EQ(kinds_of(tree_of(silhouettes)), kinds);
  }
}

TEST(SilhouetteOctree, DoesNotDependOnTheNumberOfThreads) {
  Random random(15);
  const std::vector<Silhouette> silhouettes = silhouettes_of(random_body(random), 64);
  const auto kinds = kinds_of(tree_of(silhouettes));
  const ThreadLimit limit(1);
  EXPECT_EQ(kinds_of(tree_of(silhouettes)), kinds);
}

TEST(SilhouetteOctree, LosesVolumeWithMoreViewsAndNeverGains) {
  Random random(16);
  for (int round = 0; round < 4; ++round) {
    const std::vector<Silhouette> silhouettes = silhouettes_of(random_body(random), 32);
    SilhouetteOptions options;
    options.rules.max_depth = 5;
    for (std::size_t i = 1; i <= kViewCount; ++i) options.stages.push_back(i);
    const std::vector<Octree> trees = build_from_silhouettes(kCube, silhouettes, options);
    const std::vector<double> shares = volumes_from_silhouettes(silhouettes, options);
    ASSERT_EQ(trees.size(), kViewCount);
    Cells before(32 * 32 * 32, 1);
    for (std::size_t i = 0; i < trees.size(); ++i) {
      const Cells cells = cell_colours(trees[i], 5);
      for (std::size_t c = 0; c < cells.size(); ++c) ASSERT_LE(cells[c], before[c]);
      before = cells;
      EXPECT_EQ(8 * shares[i], volume_of(trees[i]));
    }
  }
}

TEST(SilhouetteOctree, ContainsTheObjectWhenSilhouettesAreGrown) {
  Random random(17);
  for (int round = 0; round < 10; ++round) {
    const Body body = random_body(random);
    const std::vector<Silhouette> silhouettes = silhouettes_of(body, 32);
    SilhouetteOptions grow;
    grow.grow = true;
    const Cells grown = cell_colours(tree_of(silhouettes, grow), 5);
    const Cells seen = cell_colours(tree_of(silhouettes), 5);
    for (int sample = 0; sample < 2000; ++sample) {
      glm::dvec3 point(0);
      double sum = 0;
      for (const glm::dvec3& corner : body.points) {
        const double weight = random.unit() * random.unit() * random.unit();
        point += weight * corner;
        sum += weight;
      }
      point /= sum;
      std::array<int, 3> cell{};
      for (int axis = 0; axis < 3; ++axis)
        cell[static_cast<std::size_t>(axis)] = static_cast<int>((point[axis] + 1) * 16);
      const auto index = static_cast<std::size_t>(cell[0] + 32 * (cell[1] + 32 * cell[2]));
      ASSERT_EQ(grown[index], 1);
      // Not grown, a neighbour has it: that is what digitisation costs.
      bool is_near = false;
      for (int n = 0; n < 27; ++n) {
        const int x = cell[0] + n % 3 - 1;
        const int y = cell[1] + n / 3 % 3 - 1;
        const int z = cell[2] + n / 9 - 1;
        if (std::min({x, y, z}) < 0 || std::max({x, y, z}) > 31) continue;
        is_near = is_near || seen[static_cast<std::size_t>(x + 32 * (y + 32 * z))] == 1;
      }
      ASSERT_TRUE(is_near);
    }
  }
}

TEST(SilhouetteOctree, OfACubeIsTheCube) {
  for (const int size : {1, 16, 100}) {
    const Octree whole = tree_of(silhouettes_of(box(1), size));
    ASSERT_EQ(whole.levels.size(), 1u) << size;
    EXPECT_EQ(whole.levels[0].kinds[0], NodeKind::Black) << size;
  }
  // Its silhouettes end where pixels do, but for those of corner views, of which a cell needs more
  // than a quarter.
  const std::vector<Silhouette> half = silhouettes_of(box(0.5), 64);
  EXPECT_EQ(volume_of(tree_of(std::span(half).first(9))), 1);
  EXPECT_NEAR(volume_of(tree_of(half)), 1, 0.02);
}

TEST(SilhouetteOctree, OfATetrahedronOnTheCubesCornersIsTheCubeAfterThreeViews) {
  const std::vector<Silhouette> silhouettes = silhouettes_of(tetrahedron(), 128);
  EXPECT_EQ(volume_of(tree_of(std::span(silhouettes).first(3))), 8);
  // Two edge views see it from where it is a triangle: the paper's 100 %.
  EXPECT_NEAR(volume_of(tree_of(silhouettes)), 8.0 / 3, 0.05);
}

TEST(SilhouetteOctree, OfASphereHasTheVolumeOfTheCylindersAroundIt) {
  std::vector<Silhouette> silhouettes;
  for (std::size_t view = 0; view < 3; ++view) {
    Silhouette silhouette{view, Mask(256, 256)};
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 256; ++x) {
        const double dx = x - 127.5;
        const double dy = y - 127.5;
        silhouette.mask.at(x, y) = dx * dx + dy * dy <= 128 * 128;
      }
    }
    silhouettes.push_back(silhouette);
  }
  // Three cylinders of radius 1 that cross: 16 - 8 sqrt(2).
  EXPECT_NEAR(volume_of(tree_of(silhouettes)), 16 - 8 * std::sqrt(2.0), 0.02);
}

TEST(SilhouetteOctree, IsEmptyIfOneSilhouetteIs) {
  Random random(18);
  std::vector<Silhouette> silhouettes = silhouettes_of(random_body(random), 16);
  silhouettes[7].mask = Mask(16, 16);
  Octree tree = tree_of(silhouettes);
  ASSERT_EQ(tree.levels.size(), 1u);
  EXPECT_EQ(tree.levels[0].kinds[0], NodeKind::White);
  state_levels_of_cubes(tree);
  EXPECT_EQ(tree.levels[0].statement, LevelStatement{});
}

TEST(SilhouetteOctree, OfNoiseIsRefusedAtALimit) {
  Random random(20);
  std::vector<Silhouette> silhouettes;
  for (std::size_t view = 0; view < 3; ++view) {
    silhouettes.push_back({view, Mask(1024, 1024)});
    for (std::uint8_t& pixel : silhouettes.back().mask.pixels) pixel = random.chance(0.5);
  }
  EXPECT_THROW(tree_of(std::span(silhouettes).first(1)), BadInput);
  EXPECT_THROW(tree_of(silhouettes), BadInput);
  EXPECT_EQ(validate(tree_of(silhouettes, {}, 6)), std::vector<std::string>{});
}

TEST(SilhouetteStatement, HoldsForEveryCornerOfEveryLevelsCells) {
  Random random(19);
  for (int round = 0; round < 5; ++round) {
    Octree tree = tree_of(random_silhouettes(random, 16));
    state_levels_of_cubes(tree);
    EXPECT_EQ(validate(tree), std::vector<std::string>{});
    const Cells last = cell_colours(tree, 4);
    std::vector<glm::ivec3> black;
    for (int i = 0; i < 4096; ++i) {
      if (last[static_cast<std::size_t>(i)] == 1) black.emplace_back(i % 16, i / 16 % 16, i / 256);
    }
    const double total = static_cast<double>(black.size()) / 512;  // of 8
    for (std::size_t k = 0; k < tree.levels.size(); ++k) {
      const LevelStatement& statement = tree.levels[k].statement;
      const Cells cells = cell_colours(tree, static_cast<int>(k));
      const auto count = std::count(cells.begin(), cells.end(), 1);
      EXPECT_DOUBLE_EQ(statement.outer_volume,
                       8 * static_cast<double>(count) / static_cast<double>(cells.size()));
      EXPECT_LE(statement.inner_volume, total);
      const int side = 1 << k;
      double farthest = 0;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c] == 0) continue;
        for (int corner = 0; corner < 8; ++corner) {
          const int n = static_cast<int>(c);
          const glm::ivec3 p((n % side + (corner & 1)) * 16 / side,
                             (n / side % side + (corner >> 1 & 1)) * 16 / side,
                             (n / side / side + (corner >> 2)) * 16 / side);
          double nearest = 1e9;
          for (const glm::ivec3& cube : black) {
            double squares = 0;
            for (int axis = 0; axis < 3; ++axis) {
              const int gap = std::max({cube[axis] - p[axis], p[axis] - cube[axis] - 1, 0});
              squares += gap * gap;
            }
            nearest = std::min(nearest, squares);
          }
          farthest = std::max(farthest, std::sqrt(nearest) / 8);
        }
      }
      EXPECT_GE(statement.error_bound, farthest * (1 - 1e-12));
    }
    EXPECT_EQ(tree.levels.back().statement.error_bound, 0);
    EXPECT_DOUBLE_EQ(tree.levels.back().statement.inner_volume, total);
  }
}

}  // namespace
}  // namespace spoctree
