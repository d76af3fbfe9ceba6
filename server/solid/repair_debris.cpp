#include "server/solid/repair_debris.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "server/solid/keep_faces.hpp"
#include "server/solid/soup_surfaces.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

DroppedPieces drop_pieces(PolygonSoup& soup, const SoupSurfaces& surfaces,
                          const std::vector<bool>& is_dropped) {
  DroppedPieces dropped;
  for (std::size_t i = 0; i < surfaces.list.size(); ++i) {
    if (!is_dropped[i]) continue;
    const SoupSurface& piece = surfaces.list[i];
    dropped.pieces.add({place_of_face(soup, piece.first_face), piece.faces});
    dropped.faces += piece.faces;
  }
  if (dropped.faces == 0) return dropped;
  std::vector<bool> is_kept(soup.face_count());
  for (std::size_t f = 0; f < is_kept.size(); ++f) is_kept[f] = !is_dropped[surfaces.of_face[f]];
  keep_faces(soup, is_kept);
  return dropped;
}

// One round of drop_flaps.
DroppedPieces drop_outer_flaps(PolygonSoup& soup) {
  const std::vector<SoupSide> sides = sides_by_edge(soup);
  const SoupSurfaces pieces = find_surfaces(soup, sides, Connection::EdgeOfTwo);
  // How often each piece is at an edge of three faces or more, edge by edge.
  struct Hanging {
    std::uint32_t piece;
    std::uint32_t edge;
    std::uint32_t sides;
  };
  std::vector<Hanging> hangings;
  std::vector<std::size_t> faces_at;  // by edge
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (edge.size() < 3) return;
    const auto number = static_cast<std::uint32_t>(faces_at.size());
    faces_at.push_back(edge.size());
    std::vector<std::uint32_t> here;
    for (const SoupSide& side : edge) here.push_back(pieces.of_face[side.face]);
    std::sort(here.begin(), here.end());
    for (std::size_t i = 0; i < here.size();) {
      std::size_t end = i;
      while (end < here.size() && here[end] == here[i]) ++end;
      hangings.push_back({here[i], number, static_cast<std::uint32_t>(end - i)});
      i = end;
    }
  });
  std::stable_sort(hangings.begin(), hangings.end(),
                   [](const Hanging& a, const Hanging& b) { return a.piece < b.piece; });
  std::vector<std::size_t> begin(pieces.list.size() + 1, 0);
  for (const Hanging& hanging : hangings) ++begin[hanging.piece + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];

  std::vector<std::uint32_t> flaps;
  for (std::uint32_t i = 0; i < pieces.list.size(); ++i) {
    if (pieces.list[i].border_edges > 0 && begin[i] < begin[i + 1]) flaps.push_back(i);
  }
  const auto openness = [&](std::uint32_t i) {
    const SoupSurface& piece = pieces.list[i];
    return piece.border_length * piece.border_length / piece.area;
  };
  std::stable_sort(flaps.begin(), flaps.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return openness(a) > openness(b); });
  std::vector<bool> is_dropped(pieces.list.size(), false);
  for (const std::uint32_t flap : flaps) {
    const std::span<const Hanging> its(hangings.data() + begin[flap],
                                       begin[flap + 1] - begin[flap]);
    if (std::any_of(its.begin(), its.end(), [&](const Hanging& hanging) {
          return faces_at[hanging.edge] < hanging.sides + 2;
        })) {
      continue;
    }
    is_dropped[flap] = true;
    for (const Hanging& hanging : its) faces_at[hanging.edge] -= hanging.sides;
  }
  return drop_pieces(soup, pieces, is_dropped);
}

// Whether all points of the faces lie in one plane, exactly.
class FlatnessTest {
 public:
  explicit FlatnessTest(const PolygonSoup& soup) : soup_(soup) {}

  void add(std::span<const std::uint32_t> face) {
    for (const std::uint32_t corner : face) {
      if (!is_flat_) return;
      add(corner);
    }
  }
  bool is_flat() const { return is_flat_; }

 private:
  void add(std::uint32_t corner) {
    const glm::dvec3 q = soup_.points[corner];
    const Kernel::Point_3 p(q.x, q.y, q.z);
    if (known_ == 0 || (known_ == 1 && p != plane_[0]) ||
        (known_ == 2 && !CGAL::collinear(plane_[0], plane_[1], p))) {
      plane_[known_++] = p;
    } else if (known_ == 3) {
      is_flat_ = CGAL::coplanar(plane_[0], plane_[1], plane_[2], p);
    }
  }

  const PolygonSoup& soup_;
  std::array<Kernel::Point_3, 3> plane_;
  std::size_t known_ = 0;
  bool is_flat_ = true;
};

}  // namespace

DroppedPieces drop_flaps(PolygonSoup& soup) {
  DroppedPieces all;
  for (int round = 0; round < kMostFlapRounds; ++round) {
    const DroppedPieces dropped = drop_outer_flaps(soup);
    if (dropped.faces == 0) break;
    all.pieces.add_all(dropped.pieces);
    all.faces += dropped.faces;
  }
  return all;
}

DroppedPieces drop_debris(PolygonSoup& soup, const std::vector<bool>& is_scrap) {
  const SoupSurfaces surfaces = find_surfaces(soup, sides_by_edge(soup), Connection::AnyEdge);
  if (surfaces.list.size() < 2) return {};
  std::vector<FlatnessTest> flatness(surfaces.list.size(), FlatnessTest(soup));
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    if (surfaces.list[surfaces.of_face[f]].is_closed())
      flatness[surfaces.of_face[f]].add(soup.face(f));
  }
  double closed_area = 0;
  for (std::size_t i = 0; i < surfaces.list.size(); ++i) {
    if (surfaces.list[i].is_closed() && !flatness[i].is_flat()) {
      closed_area += surfaces.list[i].area;
    }
  }
  if (!(closed_area > 0)) return {};
  std::vector<bool> is_dropped(surfaces.list.size(), false);
  for (std::size_t i = 0; i < surfaces.list.size(); ++i) {
    const SoupSurface& surface = surfaces.list[i];
    if (surface.is_closed()) {
      is_dropped[i] = flatness[i].is_flat();
      continue;
    }
    // Edges of three faces say that something is wrong, but not what.
    if (surface.odd_edges > 0) continue;
    const bool is_hardly_more =
        surface.first_face < is_scrap.size() && is_scrap[surface.first_face];
    is_dropped[i] = surface.area <= kLargestDebris * closed_area ||
                    surface.flatness() > kFlatPiece ||
                    (is_hardly_more && surface.area <= closed_area);
  }
  return drop_pieces(soup, surfaces, is_dropped);
}

}  // namespace spoctree
