#include "server/solid/repair_orientation.hpp"

#include <algorithm>

namespace spoctree {

namespace {

// Faces on both sides of an edge, and whether they run along it in the same direction.
struct Meeting {
  std::uint32_t face;
  std::uint32_t other;
  bool disagree;
};

// Both directions of every meeting, by face.
std::vector<Meeting> find_meetings(const PolygonSoup& soup) {
  std::vector<Meeting> meetings;
  const std::vector<SoupSide> sides = sides_by_edge(soup);
  for_each_edge(sides, [&](std::span<const SoupSide> edge) {
    if (edge.size() != 2) return;
    const bool disagree = runs_up(soup, edge[0]) == runs_up(soup, edge[1]);
    meetings.push_back({edge[0].face, edge[1].face, disagree});
    meetings.push_back({edge[1].face, edge[0].face, disagree});
  });
  std::stable_sort(meetings.begin(), meetings.end(),
                   [](const Meeting& a, const Meeting& b) { return a.face < b.face; });
  return meetings;
}

}  // namespace

TurnedFaces agree_on_outside(PolygonSoup& soup) {
  TurnedFaces turned;
  const std::vector<Meeting> meetings = find_meetings(soup);
  const bool is_any = std::any_of(meetings.begin(), meetings.end(),
                                  [](const Meeting& meeting) { return meeting.disagree; });
  if (!is_any) return turned;

  std::vector<std::size_t> begin(soup.face_count() + 1, 0);
  for (const Meeting& meeting : meetings) ++begin[meeting.face + 1];
  for (std::size_t f = 1; f < begin.size(); ++f) begin[f] += begin[f - 1];

  std::vector<bool> is_reached(soup.face_count(), false);
  std::vector<bool> is_turned(soup.face_count(), false);
  for (std::uint32_t start = 0; start < soup.face_count(); ++start) {
    if (is_reached[start]) continue;
    is_reached[start] = true;
    std::vector<std::uint32_t> surface{start};
    std::size_t turned_here = 0;
    std::size_t conflicts = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const std::uint32_t face = surface[i];
      for (std::size_t m = begin[face]; m < begin[face + 1]; ++m) {
        const Meeting& meeting = meetings[m];
        const bool wanted = is_turned[face] != meeting.disagree;
        if (is_reached[meeting.other]) {
          if (is_turned[meeting.other] != wanted) ++conflicts;
          continue;
        }
        is_reached[meeting.other] = true;
        is_turned[meeting.other] = wanted;
        if (wanted) ++turned_here;
        surface.push_back(meeting.other);
      }
    }
    turned.one_sided_edges += conflicts / 2;
    const bool is_majority = 2 * turned_here > surface.size();
    for (const std::uint32_t face : surface) {
      is_turned[face] = conflicts == 0 && is_turned[face] != is_majority;
    }
  }
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    if (!is_turned[f]) continue;
    turned.faces.add(place_of_face(soup, f));
    std::reverse(soup.corners.begin() + soup.first_corner[f],
                 soup.corners.begin() + soup.first_corner[f + 1]);
  }
  return turned;
}

}  // namespace spoctree
