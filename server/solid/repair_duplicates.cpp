#include "server/solid/repair_duplicates.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "server/solid/face_groups.hpp"
#include "server/solid/keep_faces.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

namespace {

// Every face's corners from its smallest on, in the direction of its smaller neighbour: the same
// for all copies.
std::vector<std::uint32_t> canonical_corners(const PolygonSoup& soup) {
  std::vector<std::uint32_t> canonical = soup.corners;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto begin = canonical.begin() + soup.first_corner[f];
    const auto end = canonical.begin() + soup.first_corner[f + 1];
    std::rotate(begin, std::min_element(begin, end), end);
    if (*(begin + 1) > *(end - 1)) std::reverse(begin + 1, end);
  }
  return canonical;
}

// For every face the first face with the same corners.
std::vector<std::uint32_t> find_first_copies(const PolygonSoup& soup) {
  const std::vector<std::uint32_t> canonical = canonical_corners(soup);
  const auto corners = [&](std::uint32_t f) {
    return std::span(canonical).subspan(soup.first_corner[f],
                                        soup.first_corner[f + 1] - soup.first_corner[f]);
  };
  std::vector<std::uint32_t> order(soup.face_count());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    const auto a = corners(f);
    const auto b = corners(g);
    const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (at_a == a.end() && at_b == b.end()) return f < g;
    return at_b != b.end() && (at_a == a.end() || *at_a < *at_b);
  });
  std::vector<std::uint32_t> first(soup.face_count());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_copy = i > 0 && std::ranges::equal(corners(order[i - 1]), corners(order[i]));
    first[order[i]] = is_copy ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

DroppedDuplicates drop_duplicate_faces(PolygonSoup& soup) {
  DroppedDuplicates dropped;
  const std::vector<std::uint32_t> first = find_first_copies(soup);
  std::vector<bool> has_copies(soup.face_count(), false);  // of first faces
  bool is_any = false;
  for (std::uint32_t f = 0; f < first.size(); ++f) {
    if (first[f] == f) continue;
    has_copies[first[f]] = true;
    is_any = true;
  }
  if (!is_any) return dropped;

  // Each edge where duplicated faces end votes: one other face there wants a face to go on with.
  FaceGroups groups(soup.face_count());
  std::vector<std::int64_t> votes(soup.face_count(), 0);
  const std::vector<SoupSide> sides = sides_by_edge(soup);
  for (const bool is_voting : {false, true}) {
    for_each_edge(sides, [&](std::span<const SoupSide> edge) {
      std::uint32_t last_duplicated = 0;
      std::size_t duplicated = 0;
      std::size_t others = 0;
      for (const SoupSide& side : edge) {
        if (first[side.face] != side.face) continue;
        if (!has_copies[side.face]) {
          ++others;
          continue;
        }
        if (duplicated++ > 0 && !is_voting) groups.join(side.face, last_duplicated);
        last_duplicated = side.face;
      }
      if (is_voting && duplicated == 1 && others > 0) {
        votes[groups.group_of(last_duplicated)] += others % 2 == 1 ? 1 : -1;
      }
    });
  }
  std::vector<bool> is_kept(soup.face_count(), true);
  for (std::uint32_t f = 0; f < first.size(); ++f) {
    if (first[f] == f && !has_copies[f]) continue;
    const bool is_partition = votes[groups.group_of(first[f])] < 0;
    if (first[f] == f && !is_partition) continue;
    is_kept[f] = false;
    if (first[f] != f && is_partition) continue;  // counted once, with the first of its kind
    (is_partition ? dropped.partitions : dropped.copies).add(place_of_face(soup, f));
  }
  keep_faces(soup, is_kept);
  return dropped;
}

}  // namespace spoctree
