#include "client/queries/pair_sides.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "client/rebuild/loop_tracer.hpp"

namespace spoctree {

namespace {

struct Spoke {
  double angle = 0;  // counter-clockwise around the edge, seen against its direction
  bool forward = false;
  std::uint32_t face = 0;
  auto operator<=>(const Spoke&) const = default;
};

/// The direction of the edge: where the two planes meet that do so at the steepest angle. More
/// exact than its ends if these are near.
Vec3 direction_of(std::span<const Vec3> normals, Vec3 along) {
  Vec3 best{0.0};
  for (const Vec3 normal : normals) {
    const Vec3 c = glm::cross(normals.front(), normal);
    if (glm::dot(c, c) > glm::dot(best, best)) best = c;
  }
  return glm::dot(best, along) < 0 ? -best : best;
}

std::vector<Spoke> sort_around(const Surface& surface, const Surface::Edge& edge,
                               const PlaneSet& planes) {
  const auto sides = surface.sides_of(edge);
  // A face lies to the left of its loop, seen from outside: it runs off the edge along
  // normal x direction. So the normals turn as the faces do, if those of one kind are reversed.
  std::vector<Vec3> normals;
  for (const Surface::Side& side : sides) {
    const Vec3 normal = planes[surface.faces[side.face].plane].normal;
    normals.push_back(side.forward ? normal : -normal);
  }
  const Vec3 along = direction_of(normals, surface.vertices[edge.b] - surface.vertices[edge.a]);
  const double length = glm::length(along);
  const Vec3 axis = length > 0 ? along / length : along;
  std::vector<Spoke> spokes;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Vec2 turn{glm::dot(normals[0], normals[i]),
                    glm::dot(glm::cross(normals[0], normals[i]), axis)};
    spokes.push_back({pseudo_angle(turn), sides[i].forward, sides[i].face});
  }
  std::sort(spokes.begin(), spokes.end());
  return spokes;
}

}  // namespace

void pair_sides(const Surface& surface, const Surface::Edge& edge, const PlaneSet& planes,
                Filling filling, std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  if (edge.side_count == 2) {
    const auto sides = surface.sides_of(edge);
    pairs.emplace_back(sides[0].face, sides[1].face);
    return;
  }
  const std::vector<Spoke> spokes = sort_around(surface, edge, planes);
  // Counter-clockwise, material begins behind a face that runs backwards and ends at one that runs
  // forwards: brackets around the edge. They are read from where the fewest are open.
  const bool closing = filling == Filling::Material;
  std::size_t start = 0;
  std::int64_t depth = 0;
  std::int64_t least = 0;
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    depth += spokes[k].forward == closing ? -1 : 1;
    if (depth < least) {
      least = depth;
      start = k + 1;
    }
  }
  std::vector<std::uint32_t> open;
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    const Spoke& spoke = spokes[(start + k) % spokes.size()];
    if (spoke.forward != closing) {
      open.push_back(spoke.face);
    } else {
      pairs.emplace_back(open.back(), spoke.face);
      open.pop_back();
    }
  }
}

}  // namespace spoctree
