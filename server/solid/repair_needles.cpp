#include "server/solid/repair_needles.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <vector>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A triangle without area: its points, the middle one second.
struct Needle {
  std::uint32_t face;
  Triangle points;
};

std::vector<Needle> find_needles(const PolygonSoup& soup) {
  const auto point = [&](std::uint32_t i) {
    return Kernel::Point_3(soup.points[i].x, soup.points[i].y, soup.points[i].z);
  };
  std::vector<Needle> needles;
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    if (face.size() != 3) continue;
    const Kernel::Point_3 p = point(face[0]);
    const Kernel::Point_3 q = point(face[1]);
    const Kernel::Point_3 r = point(face[2]);
    if (!CGAL::collinear(p, q, r)) continue;
    if (CGAL::collinear_are_ordered_along_line(p, q, r)) {
      needles.push_back({f, {face[0], face[1], face[2]}});
    } else if (CGAL::collinear_are_ordered_along_line(q, r, p)) {
      needles.push_back({f, {face[1], face[2], face[0]}});
    } else {
      needles.push_back({f, {face[2], face[0], face[1]}});
    }
  }
  return needles;
}

// The new soup: without the faces marked, with a corner put in after some.
void rebuild(PolygonSoup& soup, const std::vector<bool>& is_dropped,
             const std::map<std::uint32_t, std::uint32_t>& added_after) {
  PolygonSoup kept;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    if (is_dropped[f]) continue;
    for (std::uint32_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c) {
      kept.corners.push_back(soup.corners[c]);
      const auto added = added_after.find(c);
      if (added != added_after.end()) kept.corners.push_back(added->second);
    }
    kept.first_corner.push_back(static_cast<std::uint32_t>(kept.corners.size()));
  }
  soup.corners = std::move(kept.corners);
  soup.first_corner = std::move(kept.first_corner);
}

// The sides of an edge; empty if there is none.
std::span<const SoupSide> sides_of(std::span<const SoupSide> sides, std::uint32_t a,
                                   std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  const auto begin = std::lower_bound(sides.begin(), sides.end(), SoupSide{low, high, 0, 0});
  const auto end = std::upper_bound(begin, sides.end(), SoupSide{low, high, kNone, kNone});
  return {begin, end};
}

}  // namespace

FirstFound<FacePlace> drop_needles(PolygonSoup& soup) {
  FirstFound<FacePlace> found;
  for (int round = 0; round < kMostNeedleRounds; ++round) {
    const std::vector<Needle> needles = find_needles(soup);
    if (needles.empty()) break;
    std::vector<bool> is_needle(soup.face_count(), false);
    for (const Needle& needle : needles) is_needle[needle.face] = true;
    const std::vector<SoupSide> sides = sides_by_edge(soup);
    std::vector<bool> is_dropped(soup.face_count(), false);
    std::map<std::uint32_t, std::uint32_t> added_after;
    // In one round a face gets a point at most once.
    std::map<std::uint32_t, std::vector<std::uint32_t>> points_added;
    bool is_any = false;
    for (const Needle& needle : needles) {
      const std::uint32_t middle = needle.points[1];
      const auto edge = sides_of(sides, needle.points[0], needle.points[2]);
      if (edge.size() > 2) continue;
      if (edge.size() == 2) {
        const SoupSide& beyond = edge[0].face == needle.face ? edge[1] : edge[0];
        if (is_needle[beyond.face]) continue;
        const auto corners = soup.face(beyond.face);
        auto& added = points_added[beyond.face];
        if (std::find(corners.begin(), corners.end(), middle) != corners.end()) continue;
        if (std::find(added.begin(), added.end(), middle) != added.end()) continue;
        added.push_back(middle);
        added_after[beyond.corner] = middle;
      }
      is_dropped[needle.face] = true;
      found.add(place_of_face(soup, needle.face));
      is_any = true;
    }
    if (!is_any) break;
    rebuild(soup, is_dropped, added_after);
  }
  return found;
}

}  // namespace spoctree
