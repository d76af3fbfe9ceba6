#include "client/lines/extent.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

class ExtentFinder : public PieceVisitor {
 public:
  explicit ExtentFinder(const Camera& camera) : camera_(camera) {}

  void add(Vec3 point) {
    if (camera_.depth(point) < camera_.least_depth()) {
      is_in_front_ = false;
      return;
    }
    const Vec2 at = camera_.project(point);
    extent_.lower = glm::min(extent_.lower, at);
    extent_.upper = glm::max(extent_.upper, at);
  }
  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    for (const PolyhedronVertex& vertex : piece.vertices) add(vertex.position);
  }

  bool is_empty() const { return extent_.lower.x > extent_.upper.x; }
  bool is_in_front() const { return is_in_front_; }
  const Rectangle& extent() const { return extent_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Camera& camera_;
  bool is_in_front_ = true;
  Rectangle extent_{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
};

}  // namespace

Rectangle extent_of_universe(const Universe& universe, const Camera& camera) {
  ExtentFinder finder(camera);
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = (corner >> axis & 1) != 0 ? universe.half_side : -universe.half_side;
    }
    finder.add(point);
  }
  return finder.is_in_front() ? finder.extent() : widest_frame(camera);
}

Rectangle widest_frame(const Camera& camera) {
  const double half = camera.focal_length() * std::tan(85 * std::numbers::pi / 180);
  return {{-half, -half}, {half, half}};
}

Rectangle extent_of_solid(const Octree& tree, const Camera& camera) {
  ExtentFinder finder(camera);
  WalkOptions options;
  options.level = 0;
  walk_pieces(tree, options, finder);
  return finder.is_empty() || !finder.is_in_front() ? extent_of_universe(tree.universe, camera)
                                                    : finder.extent();
}

}  // namespace spoctree
