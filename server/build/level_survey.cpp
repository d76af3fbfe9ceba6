#include "server/build/level_survey.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "server/build/certify.hpp"
#include "server/solid/triangle_distance.hpp"

namespace spoctree {

void GreyRegions::add(GreyRegions&& other) {
  volume.add(other.volume);
  attained = std::max(attained, other.attained);
  candidates.insert(candidates.end(), std::make_move_iterator(other.candidates.begin()),
                    std::make_move_iterator(other.candidates.end()));
  other.candidates = {};
}

Reach reach_of(const BuiltOctree& built, const Solid& solid, const NodeAddress& grey_node,
               const Polyhedron& region) {
  const std::uint32_t grey = built.tree.levels[grey_node.level].first_child[grey_node.index] / 8;
  const SolidTriangle& witness = solid.triangles[built.witnesses[grey_node.level][grey]];
  const MeasuredTriangle triangle(solid.vertices[witness.vertex[0]],
                                  solid.vertices[witness.vertex[1]],
                                  solid.vertices[witness.vertex[2]]);
  Reach reach;
  for (const PolyhedronVertex& vertex : region.vertices) {
    const double distance = std::sqrt(triangle.squared_distance(vertex.position)) + vertex.error;
    if (distance >= reach.bound) reach = {distance, &vertex};
  }
  return reach;
}

void LevelSurvey::inner(const NodeAddress& address, const Polyhedron& region) {
  GreyRegions& level = levels_[address.level];
  level.volume.add(volume(region));
  const auto [bound, farthest] = reach_of(built_, solid_, address, region);
  if (bound <= kErrorBoundRatio * level.attained) return;
  // A distance that is attained, from the corner that looks farthest, keeps the list short.
  const double distance =
      queries_.distance_beyond(level.attained, farthest->position) - farthest->error;
  if (distance > level.attained && queries_.side_of(farthest->position) != SolidQueries::Side::In) {
    level.attained = distance;
  }
  if (bound > kErrorBoundRatio * level.attained)
    level.candidates.push_back({bound, address, region});
}

}  // namespace spoctree
