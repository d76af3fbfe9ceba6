// Closed parts that overlap, touch in faces, edges and points, or lie within each other: what
// repair makes of random heaps of them, judged point by point by exact winding numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <set>
#include <string>
#include <tuple>

#include "common/base/errors.hpp"
#include "common/tree/query_index.hpp"
#include "server/build/build_octree.hpp"
#include "server/mesh/merge_equal_points.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"
#include "server/solid/solid_queries.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/winding_judge.hpp"

namespace spoctree {
namespace {

void add_triangle(PlainMesh& mesh, Vec3 a, Vec3 b, Vec3 c) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {a, b, c});
  mesh.faces.push_back({first, first + 1, first + 2});
}

void add_box(PlainMesh& mesh, Vec3 lower, Vec3 upper) {
  const auto corner = [&](unsigned i) {
    return Vec3{i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
  };
  constexpr unsigned kQuads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  for (const auto& [a, b, c, d] : kQuads) {
    add_triangle(mesh, corner(a), corner(b), corner(c));
    add_triangle(mesh, corner(a), corner(c), corner(d));
  }
}

/// False if the corners are in one plane.
bool add_tetrahedron(PlainMesh& mesh, std::array<Vec3, 4> p) {
  const double volume = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  if (volume == 0) return false;
  if (volume < 0) std::swap(p[2], p[3]);
  add_triangle(mesh, p[0], p[2], p[1]);
  add_triangle(mesh, p[0], p[1], p[3]);
  add_triangle(mesh, p[1], p[2], p[3]);
  add_triangle(mesh, p[2], p[0], p[3]);
  return true;
}

/// A prism along z over a triangle; false if that has no area.
bool add_prism(PlainMesh& mesh, std::array<Vec3, 3> p, double bottom, double top) {
  const double area = glm::cross(p[1] - p[0], p[2] - p[0]).z;
  if (area == 0) return false;
  if (area < 0) std::swap(p[1], p[2]);
  const auto at = [&](std::size_t i, double z) { return Vec3{p[i].x, p[i].y, z}; };
  add_triangle(mesh, at(0, bottom), at(2, bottom), at(1, bottom));
  add_triangle(mesh, at(0, top), at(1, top), at(2, top));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    add_triangle(mesh, at(i, bottom), at(j, bottom), at(j, top));
    add_triangle(mesh, at(i, bottom), at(j, top), at(i, top));
  }
  return true;
}

void add_ball(PlainMesh& mesh, Vec3 centre, double radius, int rings) {
  const auto at = [&](int ring, int step) {
    const double down = 3.14159265358979 * ring / rings;
    const double around = 3.14159265358979 * (step % (2 * rings)) / rings;
    const double flat = ring == 0 || ring == rings ? 0 : std::sin(down);
    return centre + radius * Vec3{flat * std::cos(around), flat * std::sin(around), std::cos(down)};
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int step = 0; step < 2 * rings; ++step) {
      if (ring > 0) add_triangle(mesh, at(ring, step), at(ring + 1, step), at(ring, step + 1));
      if (ring + 1 < rings) {
        add_triangle(mesh, at(ring, step + 1), at(ring + 1, step), at(ring + 1, step + 1));
      }
    }
  }
}

Vec3 lattice_point(Random& random, std::uint32_t size) {
  const auto next = [&] { return static_cast<double>(random.below(size + 1)); };
  const double x = next();
  const double y = next();
  return {x, y, next()};
}

void add_lattice_box(PlainMesh& mesh, Random& random, std::uint32_t size) {
  for (;;) {
    const Vec3 a = lattice_point(random, size);
    const Vec3 b = lattice_point(random, size);
    if (a.x == b.x || a.y == b.y || a.z == b.z) continue;
    add_box(mesh, glm::min(a, b), glm::max(a, b));
    return;
  }
}

glm::dmat3 random_turn(Random& random) {
  const double a = random.between(0, 7);
  const double b = random.between(0, 7);
  const glm::dmat3 z{std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1};
  const glm::dmat3 x{1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b)};
  return x * z;
}

struct Figures {
  std::size_t points = 0;
  std::size_t wrong = 0;
  std::size_t unknown = 0;
};

/// Of the solid that repair makes of the heap; 0 if it makes none.
std::size_t count_planes(const PlainMesh& heap) {
  PolygonSoup soup = to_soup(heap);
  merge_equal_points(soup);
  ImportOptions options;
  options.turn_shells = true;
  options.may_touch_itself = true;
  try {
    return import_solid(repair(soup).soup, "heap", options).planes.size();
  } catch (const BadInput& error) {
    ADD_FAILURE() << error.what();
    return 0;
  }
}

/// Repairs and builds the heap, and asks every level about points anywhere, on a lattice of
/// `step`, and beside the surface.
void judge_heap(const PlainMesh& heap, double step, Random& random, Figures& figures) {
  PolygonSoup soup = to_soup(heap);
  merge_equal_points(soup);
  const WindingJudge judge(heap);
  const MeshJudge surface(heap);
  struct Question {
    Vec3 point;
    std::int64_t winding;
  };
  std::vector<Question> questions;
  const Vec3 size = surface.upper() - surface.lower();
  for (int i = 0; i < 200; ++i) {
    Vec3 point = surface.lower() + size * Vec3(random.between(-0.1, 1.1), random.between(-0.1, 1.1),
                                               random.between(-0.1, 1.1));
    if (i % 4 == 1) point = step * (glm::round(point / step) + 0.5);
    if (i % 4 == 2) {
      const auto sample = surface.sample_triangle(random);
      const double off = std::pow(10.0, random.between(-5.6, -1)) * surface.diagonal();
      point = sample.point + (random.chance(0.5) ? off : -off) * sample.normal;
    }
    if (surface.distance(point) < 2e-6 * surface.diagonal()) continue;
    questions.push_back({point, judge.winding(point, random)});
  }
  const Repair repaired = repair(soup);
  ImportOptions options;
  options.turn_shells = true;
  options.may_touch_itself = true;
  try {
    const Solid solid = import_solid(repaired.soup, "heap", options);
    const SolidQueries queries(solid);
    const BuiltOctree built = build_octree(solid, queries, {});
    for (std::uint32_t k = 0; k < built.tree.levels.size(); ++k) {
      const QueryIndex index(built.tree, k);
      for (const Question& question : questions) {
        const bool is_in = question.winding > 0;
        const PointClass now = index.classify(built.tree.universe.to_universe(question.point));
        if (now == PointClass::Unknown) {
          figures.unknown += k + 1 == built.tree.levels.size();
        } else {
          figures.wrong += now != (is_in ? PointClass::In : PointClass::Out);
        }
      }
    }
  } catch (const BadInput& error) {
    ADD_FAILURE() << error.what();
  }
  figures.points += questions.size();
}

constexpr int kHeaps = 60;

template <class Make>
void judge_heaps(std::uint64_t seed, double step, const Make& make) {
  for (int i = 0; i < kHeaps; ++i) {
    Random random(seed + static_cast<std::uint64_t>(i));
    PlainMesh heap;
    make(heap, random);
    Figures figures;
    judge_heap(heap, step, random, figures);
    EXPECT_GT(figures.points, 100u) << "heap " << i;
    EXPECT_EQ(figures.wrong, 0u) << "heap " << i;
    EXPECT_EQ(figures.unknown, 0u) << "heap " << i;
  }
}

TEST(RepairedHeaps, OfBoxesOnALatticeAreWhatTheyWindAround) {
  judge_heaps(1000, 1, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(6); ++i) {
      add_lattice_box(heap, random, 4);
    }
  });
}

TEST(RepairedHeaps, OfShearedBoxesAreWhatTheyWindAround) {
  judge_heaps(2000, 1, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(6); ++i) {
      add_lattice_box(heap, random, 4);
    }
    const glm::dmat3 shear{1, 0.5, 0.25, -0.125, 1, 0.75, 0.5, 0.375, 1};
    for (Vec3& p : heap.points) p = shear * p;
  });
}

TEST(RepairedHeaps, OfTurnedBoxesAreWhatTheyWindAround) {
  judge_heaps(3000, 1, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(6); ++i) {
      add_lattice_box(heap, random, 3);
    }
    const glm::dmat3 turn = random_turn(random);
    const bool is_single = random.chance(0.5);
    for (Vec3& p : heap.points) {
      p = turn * p;
      if (is_single) p = Vec3(glm::vec3(p));
    }
  });
}

/// Of boxes along the axes: planes that are the same and face the same way count once.
std::size_t count_box_planes(const PlainMesh& heap) {
  constexpr std::size_t kPointsPerBox = 36;
  std::set<std::tuple<int, bool, double>> planes;
  for (std::size_t begin = 0; begin < heap.points.size(); begin += kPointsPerBox) {
    for (int axis = 0; axis < 3; ++axis) {
      double lower = heap.points[begin][axis];
      double upper = lower;
      for (std::size_t i = begin; i < begin + kPointsPerBox; ++i) {
        lower = std::min(lower, heap.points[i][axis]);
        upper = std::max(upper, heap.points[i][axis]);
      }
      planes.insert({axis, false, lower});
      planes.insert({axis, true, upper});
    }
  }
  return planes.size();
}

// Turning leaves of faces in one plane faces that miss it by some 2^-53: no plane may come of that.
TEST(RepairedHeaps, OfTurnedBoxesHaveNoMorePlanesThanTheBoxes) {
  for (std::uint32_t i = 0; i < kHeaps; ++i) {
    Random random(7000 + i);
    PlainMesh heap;
    const bool is_large = i % 10 == 0;
    const std::uint32_t boxes = 2 + random.below(is_large ? 20 : 6);
    for (std::uint32_t k = 0; k < boxes; ++k) add_lattice_box(heap, random, is_large ? 8 : 3);
    const std::size_t most = count_box_planes(heap);
    const glm::dmat3 turn = random_turn(random);
    for (Vec3& p : heap.points) p = turn * p;
    const std::size_t planes = count_planes(heap);
    EXPECT_GE(planes, 6u) << "heap " << i;
    EXPECT_LE(planes, most) << "heap " << i;
  }
}

TEST(RepairedHeaps, OfTurnedThinPlatesAreWhatTheyWindAround) {
  judge_heaps(8000, 0.5, [](PlainMesh& heap, Random& random) {
    constexpr double kSizes[] = {0.05, 0.5, 1, 2, 3};
    const std::uint32_t boxes = 2 + random.below(5);
    for (std::uint32_t i = 0; i < boxes; ++i) {
      const Vec3 lower = 0.5 * lattice_point(random, 3);
      const Vec3 size{kSizes[random.below(5)], kSizes[random.below(5)], kSizes[random.below(5)]};
      add_box(heap, lower, lower + size);
    }
    const glm::dmat3 turn = random_turn(random);
    for (Vec3& p : heap.points) p = turn * p;
  });
}

TEST(RepairedHeaps, OfTetrahedraOnALatticeAreWhatTheyWindAround) {
  judge_heaps(4000, 1, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(5); ++i) {
      while (!add_tetrahedron(heap, {lattice_point(random, 3), lattice_point(random, 3),
                                     lattice_point(random, 3), lattice_point(random, 3)})) {
      }
    }
  });
}

TEST(RepairedHeaps, OfPrismsAndBoxesOnALatticeAreWhatTheyWindAround) {
  judge_heaps(5000, 1, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(5); ++i) {
      if (random.chance(0.4)) add_lattice_box(heap, random, 3);
      const std::uint32_t bottom = random.below(3);
      while (!add_prism(
          heap, {lattice_point(random, 3), lattice_point(random, 3), lattice_point(random, 3)},
          bottom, bottom + 1 + random.below(2))) {
      }
    }
  });
}

TEST(RepairedHeaps, OfBallsAreWhatTheyWindAround) {
  judge_heaps(6000, 0.25, [](PlainMesh& heap, Random& random) {
    for (std::uint32_t i = 0; i < 2 + random.below(4); ++i) {
      const Vec3 centre{random.unit(), random.unit(), random.unit()};
      add_ball(heap, centre, random.between(0.2, 0.8), 4 + static_cast<int>(random.below(8)));
    }
  });
}

}  // namespace
}  // namespace spoctree
