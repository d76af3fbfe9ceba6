#include "client/draw/solid_points.hpp"

#include <glm/common.hpp>

#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

class PointCollector : public PieceVisitor {
 public:
  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    for (const PolyhedronVertex& vertex : piece.vertices) points.push_back(vertex.position);
  }
  std::vector<Vec3> points;
};

}  // namespace

std::vector<Vec3> coarsest_points(const Octree& tree) {
  PointCollector collector;
  WalkOptions options;
  options.level = 0;
  walk_pieces(tree, options, collector);
  if (!collector.points.empty()) return std::move(collector.points);
  const double side = tree.universe.half_side;
  std::vector<Vec3> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    corners.push_back({(corner & 1) != 0 ? side : -side, (corner & 2) != 0 ? side : -side,
                       (corner & 4) != 0 ? side : -side});
  }
  return corners;
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 lower = points.front();
  Vec3 upper = points.front();
  for (const Vec3 point : points) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  return 0.5 * (lower + upper);
}

}  // namespace spoctree
