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

/// A region is bounded by the largest distance of its corners from one triangle of the solid: the
/// distance from a convex set is convex.
void LevelSurvey::inner(const NodeAddress& address, const Polyhedron& region) {
  GreyRegions& level = levels_[address.level];
  level.volume.add(volume(region));
  const std::uint32_t grey = built_.tree.levels[address.level].first_child[address.index] / 8;
  const SolidTriangle& witness = solid_.triangles[built_.witnesses[address.level][grey]];
  const MeasuredTriangle triangle(solid_.vertices[witness.vertex[0]],
                                  solid_.vertices[witness.vertex[1]],
                                  solid_.vertices[witness.vertex[2]]);
  double bound = 0;
  const PolyhedronVertex* farthest = nullptr;
  for (const PolyhedronVertex& vertex : region.vertices) {
    const double distance = std::sqrt(triangle.squared_distance(vertex.position)) + vertex.error;
    if (distance >= bound) {
      bound = distance;
      farthest = &vertex;
    }
  }
  if (bound <= kErrorBoundRatio * level.attained) return;
  // A distance that is attained, from the corner that looks farthest, keeps the list short.
  const double distance = queries_.distance(farthest->position) - farthest->error;
  if (distance > level.attained && queries_.side_of(farthest->position) != SolidQueries::Side::In) {
    level.attained = distance;
  }
  if (bound > kErrorBoundRatio * level.attained)
    level.candidates.push_back({bound, address, region});
}

}  // namespace spoctree
