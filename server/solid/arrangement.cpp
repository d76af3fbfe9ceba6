#include "server/solid/arrangement.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "server/solid/face_groups.hpp"
#include "server/solid/meeting_lines.hpp"
#include "server/solid/split_in_plane.hpp"

namespace spoctree {

namespace {

// Numbers of equal points become one, the smallest.
void weld(const ExactPoints& points, std::vector<std::uint32_t> some,
          std::span<const std::array<std::uint32_t, 2>> same, std::vector<Piece>& pieces) {
  FaceGroups groups(points.size());
  for (const auto& [p, q] : same) groups.join(p, q);
  struct Place {
    ExactPoint point;
    std::uint32_t number;
  };
  std::vector<Place> places;
  places.reserve(some.size());
  for (const std::uint32_t number : some) places.push_back({points[number], number});
  std::sort(places.begin(), places.end(), [](const Place& p, const Place& q) {
    const auto order = CGAL::compare_xyz(p.point, q.point);
    return order != CGAL::EQUAL ? order == CGAL::SMALLER : p.number < q.number;
  });
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].point == places[i - 1].point) groups.join(places[i - 1].number, places[i].number);
  }
  for (Piece& piece : pieces) {
    for (std::uint32_t& corner : piece.corners) corner = groups.group_of(corner);
  }
}

}  // namespace

Arrangement arrange(std::span<const Vec3> given, std::span<const Corners> triangles,
                    std::span<const std::array<std::uint32_t, 2>> pairs) {
  Arrangement made{ExactPoints(given), {}};
  const MeetingLines meeting = find_meeting_lines(made.points, given, triangles, pairs);
  if (made.points.size() - made.points.given() > kMostConstructedPoints) {
    throw TooEntangled("they have more than " + std::to_string(kMostConstructedPoints) +
                       " points in common");
  }

  // What lies in one plane is split together, under the number of its first triangle.
  FaceGroups planes(triangles.size());
  std::vector<std::uint8_t> is_met(triangles.size(), 0);
  for (const auto& [a, b] : meeting.in_plane) {
    planes.join(a, b);
    is_met[a] = is_met[b] = 1;
  }
  std::map<std::uint32_t, std::vector<MeetingLine>> lines_in;
  for (const MeetingLine& line : meeting.lines) {
    is_met[line.triangle] = 1;
    lines_in[planes.group_of(line.triangle)].push_back(line);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> members_of;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (is_met[t] == 0) {
      made.pieces.push_back({triangles[t], t, 1});
      continue;
    }
    members_of[planes.group_of(t)].push_back(t);
    corners.insert(corners.end(), triangles[t].begin(), triangles[t].end());
  }
  std::vector<std::array<std::uint32_t, 2>> same;
  for (const auto& [plane, members] : members_of) {
    split_in_plane(made.points, given, triangles, members, lines_in[plane], made.pieces, same);
  }

  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (std::size_t i = made.points.given(); i < made.points.size(); ++i) {
    corners.push_back(static_cast<std::uint32_t>(i));
  }
  weld(made.points, std::move(corners), same, made.pieces);
  return made;
}

}  // namespace spoctree
