#include "server/solid/merge_corners.hpp"

#include <algorithm>
#include <map>

namespace spoctree {

namespace {

using Loop = std::vector<std::uint32_t>;

void drop_repetitions(Loop& loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
}

// Simple loops that run along the same edges in the same directions; an edge there and back is
// none.
void divide(const Loop& loop, std::vector<Loop>& parts) {
  Loop walk;
  std::map<std::uint32_t, std::size_t> place;
  const auto cut = [&](std::size_t begin) {
    if (walk.size() - begin >= 3) {
      parts.emplace_back(walk.begin() + static_cast<std::ptrdiff_t>(begin), walk.end());
    }
    for (std::size_t i = begin; i < walk.size(); ++i) place.erase(walk[i]);
    walk.resize(begin);
  };
  for (const std::uint32_t corner : loop) {
    if (const auto before = place.find(corner); before != place.end()) cut(before->second);
    place.emplace(corner, walk.size());
    walk.push_back(corner);
  }
  cut(0);
}

}  // namespace

FirstFound<FacePlace> merge_corners(PolygonSoup& soup, std::span<const std::uint32_t> new_number,
                                    std::vector<std::uint32_t>* origin) {
  FirstFound<FacePlace> vanished;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first_corner{0};
  std::vector<std::uint32_t> new_origin;
  corners.reserve(soup.corners.size());
  first_corner.reserve(soup.first_corner.size());
  Loop loop;
  std::vector<Loop> parts;
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    const auto add = [&](std::span<const std::uint32_t> part) {
      corners.insert(corners.end(), part.begin(), part.end());
      first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
      if (origin != nullptr) new_origin.push_back((*origin)[f]);
    };
    if (std::none_of(face.begin(), face.end(),
                     [&](std::uint32_t corner) { return new_number[corner] != corner; })) {
      add(face);
      continue;
    }
    loop.clear();
    for (const std::uint32_t corner : face) loop.push_back(new_number[corner]);
    drop_repetitions(loop);
    parts.clear();
    // A face that a reader has left touching itself means it so.
    if (loop.size() > 3 && repeated_vertex(loop) && !repeated_vertex(face)) {
      divide(loop, parts);
    } else if (loop.size() >= 3 && (loop.size() > 3 || !repeated_vertex(loop))) {
      parts.push_back(loop);
    }
    for (const Loop& part : parts) add(part);
    if (parts.empty()) vanished.add(place_of_face(soup, f));
  }
  soup.corners = std::move(corners);
  soup.first_corner = std::move(first_corner);
  if (origin != nullptr) *origin = std::move(new_origin);
  return vanished;
}

}  // namespace spoctree
