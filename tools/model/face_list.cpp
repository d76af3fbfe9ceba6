#include "tools/model/face_list.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tools/model/cut_holes.hpp"

namespace spoctree::model {

Corners at_height(const Corners2& profile, double z) {
  Corners corners;
  corners.reserve(profile.size());
  for (const glm::dvec2& point : profile) corners.emplace_back(point.x, point.y, z);
  return corners;
}

Loop FaceList::weld(const Corners& corners) {
  Loop loop;
  loop.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    const auto next = static_cast<std::uint32_t>(mesh_.points.size());
    // 0.0 and -0.0 compare equal, so mirrored points need no care.
    const auto [place, is_new] = index_of_.try_emplace({corner.x, corner.y, corner.z}, next);
    if (is_new) mesh_.points.push_back(corner);
    loop.push_back(place->second);
  }
  return loop;
}

void FaceList::add(const Corners& outer, const std::vector<Corners>& holes) {
  Loop outer_loop = weld(outer);
  std::vector<Loop> hole_loops;
  hole_loops.reserve(holes.size());
  for (const Corners& hole : holes) hole_loops.push_back(weld(hole));
  for (Loop& piece : cut_holes(mesh_.points, std::move(outer_loop), std::move(hole_loops)))
    mesh_.faces.push_back(std::move(piece));
}

void FaceList::add_walls(const Corners& from, const Corners& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.size();
    add({from[i], from[next], to[next], to[i]});
  }
}

void FaceList::add_prism(const Corners2& profile, double z_low, double z_high,
                         const std::vector<Corners2>& holes) {
  const auto reversed = [](Corners corners) {
    std::reverse(corners.begin(), corners.end());
    return corners;
  };
  std::vector<Corners> top_holes;
  std::vector<Corners> bottom_holes;
  for (const Corners2& hole : holes) {
    top_holes.push_back(at_height(hole, z_high));
    bottom_holes.push_back(reversed(at_height(hole, z_low)));
  }
  add(reversed(at_height(profile, z_low)), bottom_holes);
  add_walls(at_height(profile, z_low), at_height(profile, z_high));
  for (const Corners2& hole : holes) add_walls(at_height(hole, z_low), at_height(hole, z_high));
  add(at_height(profile, z_high), top_holes);
}

void FaceList::add_box(const glm::dvec3& low, const glm::dvec3& high, bool hollow) {
  const Corners2 base{{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}};
  // A box whose bottom is above its top, seen from outside, is inside out.
  if (hollow)
    add_prism(base, high.z, low.z);
  else
    add_prism(base, low.z, high.z);
}

}  // namespace spoctree::model
