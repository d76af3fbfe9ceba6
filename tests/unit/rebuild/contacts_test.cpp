#include "client/rebuild/contacts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

/// Vertices in the plane z = 0.
struct Scene {
  explicit Scene(double tolerance) : welder(tolerance) {
    tree.planes = {{{0, 0, 1}, 0}, {{1, 0, 0}, 0}};
    carriers = Carriers(tree);
  }
  std::uint32_t vertex(double x, double y) { return welder.weld({x, y, 0}); }
  /// For carrier 0, and the other way for carrier 1: the sum over both is zero.
  void add(std::uint32_t from, std::uint32_t to) {
    chain.push_back(directed_edge(from, to, 0, 1));
    chain.push_back(directed_edge(from, to, 1, -1));
  }
  void resolve() {
    normalize(chain, welder.vertices().size());
    resolve_contacts(chain, carriers, welder);
  }
  std::int32_t largest_count() const {
    std::int32_t largest = 0;
    for (const ChainEdge& edge : chain) largest = std::max(largest, std::abs(edge.count));
    return largest;
  }

  Octree tree;
  Carriers carriers;
  VertexWelder welder;
  Chain chain;
};

TEST(ResolveContacts, CutsAnEdgeAtTheVertexOnIt) {
  Scene scene(1e-10);
  const std::uint32_t a = scene.vertex(0, 0);
  const std::uint32_t b = scene.vertex(0.5, 0);
  const std::uint32_t c = scene.vertex(0.25, 0.5e-10);
  const std::uint32_t d = scene.vertex(0.25, 0.5);
  for (const auto& [from, to] : {std::array{a, b}, {b, d}, {d, a}, {c, d}, {d, c}}) {
    scene.add(from, to);
  }
  scene.add(c, d);
  scene.resolve();
  for (const ChainEdge& edge : scene.chain) EXPECT_FALSE(edge.a == a && edge.b == b);
  EXPECT_EQ(scene.largest_count(), 1);
}

TEST(ResolveContacts, LeavesATriangleAsLargeAsItsToleranceAsItIs) {
  // Every corner is within the tolerance of the middle of the edge across, but going there is no
  // way from one end of it to the other: each edge would become the other two, again and again.
  Scene scene(1e-10);
  const double side = 1.1e-10;
  const std::uint32_t a = scene.vertex(0, 0);
  const std::uint32_t b = scene.vertex(side, 0);
  const std::uint32_t c = scene.vertex(side / 2, side * std::sqrt(0.75));
  for (const auto& [from, to] : {std::array{a, b}, {b, c}, {c, a}}) scene.add(from, to);
  scene.resolve();
  EXPECT_EQ(scene.chain.size(), 6u);
  EXPECT_EQ(scene.largest_count(), 1);
}

TEST(ResolveContacts, DoesNotMultiplyEdgesInAClusterOfVertices) {
  for (int count = 4; count <= 12; ++count) {
    Scene scene(1e-10);
    std::vector<std::uint32_t> ring;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count;
      const double radius = 1.5e-10 * (1 + 0.5 * (i % 3));
      ring.push_back(scene.vertex(radius * std::cos(angle), radius * std::sin(angle)));
    }
    for (const std::uint32_t from : ring) {
      for (const std::uint32_t to : ring) {
        if (from < to) scene.add(from, to), scene.add(to, from);
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const std::size_t step : {1, 2, 3}) scene.add(ring[i], ring[(i + step) % ring.size()]);
    }
    scene.resolve();
    EXPECT_LE(scene.largest_count(), 8) << count << " vertices";
    // Still closed: as much arrives in every vertex as leaves it.
    std::vector<std::int32_t> leaving(scene.welder.vertices().size());
    for (const ChainEdge& edge : scene.chain) {
      if (edge.carrier != 0) continue;
      leaving[edge.a] += edge.count;
      leaving[edge.b] -= edge.count;
    }
    EXPECT_EQ(leaving, std::vector<std::int32_t>(leaving.size()));
  }
}

}  // namespace
}  // namespace spoctree
