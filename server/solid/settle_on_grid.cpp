#include "server/solid/settle_on_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <optional>

#include "common/geometry/universe.hpp"
#include "server/mesh/merge_equal_points.hpp"
#include "server/solid/face_groups.hpp"
#include "server/solid/grid_integers.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/merge_corners.hpp"
#include "server/solid/point_clusters.hpp"
#include "server/solid/repair_needles.hpp"

namespace spoctree {

namespace {

constexpr double kStep = 0x1p-52;

// Where points are heaped up more than this, they are looked at as the grid has them only.
constexpr std::size_t kMostPairsPerPoint = 256;

// Nothing for what import_solid refuses.
std::optional<Universe> universe_of(std::span<const glm::dvec3> points) {
  if (points.empty()) return std::nullopt;
  Vec3 lower = points[0];
  Vec3 upper = points[0];
  for (const Vec3& p : points) {
    if (!std::isfinite(p.x + p.y + p.z)) return std::nullopt;
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const Vec3 size = upper - lower;
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent >= kSmallestExtent && extent <= kLargestExtent)) return std::nullopt;
  return universe_around(lower, upper);
}

// Which other points are to be merged with; empty if none is.
std::vector<std::uint32_t> find_mergers(const PolygonSoup& soup, const Universe& universe) {
  std::vector<Vec3> places(soup.points.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = universe.to_universe(soup.points[i]);
  }
  const std::vector<std::uint32_t> crowded = find_crowded_points(places, kStep);
  if (crowded.empty()) return {};
  // The numbers from here on are those in `crowded`.
  std::vector<Vec3> near_places;
  std::vector<Vec3> on_grid;
  for (const std::uint32_t i : crowded) {
    near_places.push_back(places[i]);
    on_grid.push_back(universe.to_grid(soup.points[i]));
  }
  std::vector<PointPair> pairs;
  const bool are_few =
      visit_near_points(near_places, kStep, kMostPairsPerPoint * near_places.size(),
                        [&](std::uint32_t i, std::uint32_t j) {
                          pairs.push_back({i, j});
                        });
  if (!are_few) pairs.clear();
  const std::vector<std::uint32_t> equal = equal_points(on_grid);
  std::vector<PointPair> sure;
  for (std::uint32_t i = 0; i < equal.size(); ++i) {
    if (equal[i] != i) sure.push_back({equal[i], i});
  }
  std::vector<Box> boxes;
  for (const Vec3& place : near_places) boxes.push_back({place, place});
  const std::vector<std::uint32_t> cluster =
      bounded_clusters(std::move(boxes), pairs, kWidestSettling * kStep, sure);
  std::vector<std::uint32_t> uses(soup.points.size(), 0);
  for (const std::uint32_t corner : soup.corners) ++uses[corner];
  std::vector<std::uint32_t> new_number(soup.points.size());
  std::iota(new_number.begin(), new_number.end(), 0u);
  bool is_any = false;
  const std::vector<std::uint32_t> chosen = choose_points(cluster, [&](std::uint32_t i) {
    const Vec3 p = soup.points[crowded[i]];
    return PointRank{uses[crowded[i]], {p.x, p.y, p.z}};
  });
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    new_number[crowded[i]] = crowded[chosen[i]];
    is_any = is_any || chosen[i] != i;
  }
  return is_any ? new_number : std::vector<std::uint32_t>{};
}

// The corners of a triangle that is a line on the grid, the middle one second.
std::optional<std::array<std::uint32_t, 3>> line_on_grid(std::span<const Vec3> places,
                                                         std::span<const std::uint32_t> face) {
  const Vec3 u = places[face[1]] - places[face[0]];
  const Vec3 v = places[face[2]] - places[face[0]];
  // Coordinates differ by up to 2 and are exact: no product is off by more than 2^-50.
  constexpr double kDoubt = 0x1p-48;
  if (std::abs(u.x * v.y - u.y * v.x) > kDoubt || std::abs(u.y * v.z - u.z * v.y) > kDoubt ||
      std::abs(u.z * v.x - u.x * v.z) > kDoubt) {
    return std::nullopt;
  }
  std::array<GridPoint, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = to_grid_integers(places[face[i]]);
  if (area_vector(p[0], p[1], p[2]) != AreaVector{0, 0, 0}) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t before = (i + 2) % 3;
    const std::size_t after = (i + 1) % 3;
    const auto is_between = [&](std::size_t axis) {
      return (p[before][axis] <= p[i][axis] && p[i][axis] <= p[after][axis]) ||
             (p[after][axis] <= p[i][axis] && p[i][axis] <= p[before][axis]);
    };
    if (is_between(0) && is_between(1) && is_between(2)) {
      return {{face[before], face[i], face[after]}};
    }
  }
  return std::nullopt;
}

std::string line_about(const char* verb, const FirstFound<FacePlace>& faces, const char* which,
                       const PolygonSoup& soup) {
  return std::string(verb) + counted(faces.count(), "triangle") + which + ", " +
         faces.places([&](const FacePlace& face) { return place_text(soup.points, face.corners); });
}

}  // namespace

GridSettlement settle_on_grid(PolygonSoup& soup) {
  GridSettlement settled;
  // A second look, because without some points the extent may be another, and so the grid.
  for (int round = 0; round < 3; ++round) {
    const auto universe = universe_of(soup.points);
    if (!universe) return settled;
    const std::vector<std::uint32_t> new_number = find_mergers(soup, *universe);
    if (new_number.empty()) break;
    FirstFound<std::uint32_t> merged;
    for (std::uint32_t i = 0; i < new_number.size(); ++i) {
      if (new_number[i] != i) merged.add(i);
    }
    settled.merged_points += merged.count();
    settled.changes.push_back("merged: " + counted(merged.count(), "point") +
                              " with others that are nearer than 2^-52 of the extent, " +
                              merged.places([&](std::uint32_t i) {
                                return place_text(soup.points, {&i, 1});
                              }));
    // What was a line already is the file's own, and what has become one by this goes.
    const FirstFound<FacePlace> vanished = merge_corners(soup, new_number);
    if (vanished.count() > 0) {
      settled.dropped_faces += vanished.count();
      settled.changes.push_back(
          line_about("dropped: ", vanished, " with fewer than three different corners then", soup));
    }
    const CollapsedFaces before = soup.collapsed;
    merge_equal_points(soup);
    soup.collapsed = before;
  }
  const auto universe = universe_of(soup.points);
  if (!universe) return settled;
  std::vector<Vec3> places(soup.points.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = universe->to_grid(soup.points[i]);
  bool is_any = false;
  const auto line_of =
      [&](std::span<const std::uint32_t> face) -> std::optional<std::array<std::uint32_t, 3>> {
    const auto line = line_on_grid(places, face);
    if (!line || exact_line(soup, face)) return std::nullopt;
    is_any = true;
    return line;
  };
  const FirstFound<FacePlace> needles = drop_needles(soup, line_of);
  if (needles.count() > 0) {
    settled.dropped_faces += needles.count();
    settled.changes.push_back(
        line_about("dropped: ", needles, " thinner than 2^-52 of the extent", soup));
    merge_equal_points(soup);
  }
  return settled;
}

}  // namespace spoctree
