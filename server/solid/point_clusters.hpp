// Points that are near each other into clusters that do not depend on the order of the points, and
// that no chain makes wide.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/universe.hpp"
#include "server/solid/box_tree.hpp"

namespace spoctree {

using PointPair = std::array<std::uint32_t, 2>;

/// For each point the first point that is equal. REQUIRES: no NaN.
std::vector<std::uint32_t> equal_points(std::span<const Vec3> points);

/// Numbers of points, in order, among which are all that differ from another one by less than
/// `distance` in each coordinate; and few others, unless points lie in regular rows. Linear.
/// REQUIRES: 0 < distance, coordinates up to 2^10, finite.
std::vector<std::uint32_t> find_crowded_points(std::span<const Vec3> points, double distance);

/// The cells of a grid of cubes that have points in them, so that near points are found.
class PointCells {
 public:
  PointCells(std::span<const Vec3> points, double side);

  /// Calls visit(i) for the points in the 27 cells around `p`: all those within `side` of it in
  /// each coordinate, and others. Ends when that returns false, and returns false then.
  template <class Visit>
  bool visit_around(Vec3 p, Visit visit) const {
    const Cell middle = cell_of(p);
    for (std::int64_t x = middle[0] - 1; x <= middle[0] + 1; ++x) {
      for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y) {
        // Cells above each other stand together.
        const Cell last{x, y, middle[2] + 1};
        auto entry =
            std::lower_bound(entries_.begin(), entries_.end(), Entry{Cell{x, y, middle[2] - 1}, 0});
        for (; entry != entries_.end() && entry->cell <= last; ++entry) {
          if (!visit(entry->point)) return false;
        }
      }
    }
    return true;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    std::uint32_t point;
    auto operator<=>(const Entry&) const = default;
  };
  Cell cell_of(Vec3 p) const;

  double side_;
  std::vector<Entry> entries_;
};

/// Calls visit(i, j), i < j, once for each pair of points that differ by less than `distance` in
/// each coordinate. False if more than `most` pairs would have to be looked at; some have been
/// visited then.
template <class Visit>
bool visit_near_points(std::span<const Vec3> points, double distance, std::size_t most,
                       Visit visit) {
  const PointCells cells(points, distance);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const bool is_affordable = cells.visit_around(points[i], [&](std::uint32_t j) {
      if (most == 0) return false;
      --most;
      const Vec3 d = points[i] - points[j];
      if (i < j && std::abs(d.x) < distance && std::abs(d.y) < distance &&
          std::abs(d.z) < distance) {
        visit(i, j);
      }
      return true;
    });
    if (!is_affordable) return false;
  }
  return true;
}

/// Joins points along `pairs`. For each point the first point of its cluster. A point may stand for
/// others already, which are in its box; else that is the point. A cluster whose boxes are together
/// wider than `width` in a coordinate is not made; of its points, only those joined by `sure` pairs
/// are. Nearly linear.
std::vector<std::uint32_t> bounded_clusters(std::vector<Box> boxes,
                                            std::span<const PointPair> pairs, double width,
                                            std::span<const PointPair> sure = {});

/// Which of the points of a cluster all of them become: the one that most corners have, among these
/// the one with the smallest coordinates, from the last to the first in magnitude.
struct PointRank {
  std::uint32_t uses = 0;
  std::array<double, 3> place{};

  bool is_before(const PointRank& other) const {
    if (uses != other.uses) return uses > other.uses;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = std::abs(place[i]);
      const double b = std::abs(other.place[i]);
      if (a != b) return a < b;
    }
    return place < other.place;
  }
};

/// For each point the one that its cluster becomes; `rank_of(i)` is the rank of point i.
template <class RankOf>
std::vector<std::uint32_t> choose_points(std::span<const std::uint32_t> cluster,
                                         const RankOf& rank_of) {
  std::vector<std::uint32_t> best(cluster.begin(), cluster.end());
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    std::uint32_t& chosen = best[cluster[i]];
    if (cluster[i] != i && rank_of(i).is_before(rank_of(chosen))) chosen = i;
  }
  std::vector<std::uint32_t> chosen(cluster.size());
  for (std::uint32_t i = 0; i < cluster.size(); ++i) chosen[i] = best[cluster[i]];
  return chosen;
}

}  // namespace spoctree
