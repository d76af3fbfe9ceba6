#include "client/lines/line_source.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/geometry/tolerances.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

LineSource find_source(const Octree& tree, std::uint32_t level, Vec3 point,
                       std::span<const PlaneRef> planes) {
  // A hair into the material: behind the planes.
  Vec3 inwards{0.0};
  for (const PlaneRef plane : planes) inwards -= tree.plane_set()[plane].normal;
  const double length = glm::length(inwards);
  if (length > kEdgeOnTolerance) point += inwards * (kShortestLine / length);
  NodeAddress node;
  while (true) {
    const Level& nodes = tree.levels[node.level];
    const NodeKind kind = nodes.kinds[node.index];
    if (kind != NodeKind::Grey || node.level == level) break;
    std::uint32_t octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double middle =
          wall_coordinate(tree.universe.half_side, node.lower[axis] + node.size() / 2);
      if (point[axis] > middle) octant |= 1u << static_cast<unsigned>(axis);
    }
    node = node.child(nodes.first_child[node.index], octant);
  }
  const Level& nodes = tree.levels[node.level];
  const auto own = nodes.planes_of(node.index);
  LineSource source;
  source.kind = nodes.kinds[node.index];
  source.level = static_cast<std::uint8_t>(node.level);
  source.is_inherited = std::none_of(planes.begin(), planes.end(), [&](PlaneRef plane) {
    return !plane.is_wall() && std::find(own.begin(), own.end(), plane.index()) != own.end();
  });
  return source;
}

}  // namespace spoctree
