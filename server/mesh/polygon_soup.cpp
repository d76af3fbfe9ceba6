#include "server/mesh/polygon_soup.hpp"

#include <algorithm>
#include <compare>
#include <utility>

#include "server/mesh/limits.hpp"

namespace spoctree {

std::optional<std::uint32_t> repeated_vertex(std::span<const std::uint32_t> corners) {
  constexpr std::size_t kCompareAllPairs = 8;
  if (corners.size() <= kCompareAllPairs) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (corners[i] == corners[j]) return corners[i];
      }
    }
    return std::nullopt;
  }
  std::vector<std::uint32_t> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin == sorted.end()) return std::nullopt;
  return *twin;
}

namespace {

// Two loops that share a vertex, of three corners each.
constexpr std::size_t kFewestTouchingCorners = 6;

// Leaves out corners that are equal to the one before them, all around the face that begins there.
void drop_equal_neighbours(std::vector<std::uint32_t>& corners, std::size_t first) {
  const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(first);
  auto end = std::unique(begin, corners.end());
  while (end - begin > 1 && *begin == *(end - 1)) --end;
  corners.erase(end, corners.end());
}

bool has_equal_neighbours(std::span<const std::uint32_t> face) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (face[i] == face[i == 0 ? face.size() - 1 : i - 1]) return true;
  }
  return false;
}

}  // namespace

std::optional<std::uint32_t> wrongly_repeated_vertex(std::span<const std::uint32_t> corners) {
  const auto vertex = repeated_vertex(corners);
  if (!vertex || corners.size() < kFewestTouchingCorners) return vertex;
  struct Side {
    std::uint32_t low;
    std::uint32_t high;
    int direction;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t from = corners[i];
    const std::uint32_t to = corners[i + 1 < corners.size() ? i + 1 : 0];
    sides.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }
  std::sort(sides.begin(), sides.end());
  bool has_border = false;
  for (std::size_t i = 0; i < sides.size();) {
    const Side edge = sides[i];
    int sum = 0;
    for (; i < sides.size() && sides[i].low == edge.low && sides[i].high == edge.high; ++i)
      sum += sides[i].direction;
    if (sum < -1 || sum > 1) return vertex;
    has_border = has_border || sum != 0;
  }
  return has_border ? std::nullopt : vertex;
}

std::string close_face(PolygonSoup& soup, std::uint32_t index_base) {
  if (soup.corners.size() == soup.first_corner.back()) {
    return "has 0 corners, a face needs 3 or more";
  }
  drop_equal_neighbours(soup.corners, soup.first_corner.back());
  const auto face = std::span(soup.corners).subspan(soup.first_corner.back());
  if (face.size() < 3) {
    if (soup.collapsed.count++ == 0) soup.collapsed.first = soup.face_count();
    soup.corners.resize(soup.first_corner.back());
    return {};
  }
  if (const auto vertex = wrongly_repeated_vertex(face)) {
    return "uses vertex " + std::to_string(std::uint64_t{*vertex} + index_base) + " more than once";
  }
  if (soup.corners.size() > mesh_limits::kMaxCorners) {
    return "takes the file over the limit of " + std::to_string(mesh_limits::kMaxCorners) +
           " face corners";
  }
  if (soup.face_count() >= mesh_limits::kMaxFaces) {
    return "takes the file over the limit of " + std::to_string(mesh_limits::kMaxFaces) + " faces";
  }
  soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return {};
}

bool drop_collapsed_faces(PolygonSoup& soup) {
  std::size_t face = 0;
  while (face < soup.face_count() && !has_equal_neighbours(soup.face(face))) ++face;
  if (face == soup.face_count()) return false;

  PolygonSoup kept;
  kept.corners.assign(soup.corners.begin(), soup.corners.begin() + soup.first_corner[face]);
  kept.first_corner.assign(soup.first_corner.begin(),
                           soup.first_corner.begin() + static_cast<std::ptrdiff_t>(face) + 1);
  kept.collapsed = soup.collapsed;
  for (; face < soup.face_count(); ++face) {
    const auto corners = soup.face(face);
    kept.corners.insert(kept.corners.end(), corners.begin(), corners.end());
    drop_equal_neighbours(kept.corners, kept.first_corner.back());
    if (kept.corners.size() - kept.first_corner.back() < 3) {
      kept.corners.resize(kept.first_corner.back());
      // Faces before the first that was dropped have the numbers that the file gives them.
      if (kept.collapsed.count++ == 0 || face < kept.collapsed.first) kept.collapsed.first = face;
    } else {
      kept.first_corner.push_back(static_cast<std::uint32_t>(kept.corners.size()));
    }
  }
  kept.points = std::move(soup.points);
  kept.remarks = std::move(soup.remarks);
  kept.precision = soup.precision;
  soup = std::move(kept);
  return true;
}

}  // namespace spoctree
