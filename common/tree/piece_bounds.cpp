#include "common/tree/piece_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

class Collector : public PieceVisitor {
 public:
  explicit Collector(const Octree& tree) : side_(2 * tree.universe.half_side) {}

  void piece(const NodeAddress& address, NodeKind kind, std::uint32_t,
             const Polyhedron& polyhedron) override {
    const double piece_volume = volume(polyhedron);
    const double side = std::ldexp(side_, -static_cast<int>(address.level));
    double position_error = 0;
    for (const PolyhedronVertex& vertex : polyhedron.vertices) {
      position_error = std::max(position_error, vertex.error);
    }
    // A convex piece of a cell has no larger surface than the cell; its faces are off by less than
    // twice the vertices' coordinates. The volume is a sum of tetrahedra, none of them negative.
    error_ += 12 * side * side * position_error +
              static_cast<double>(polyhedron.corners.size()) * side * side * side * 0x1p-49;
    ++count_;
    all_ += piece_volume;
    include(outer_box_, polyhedron, 1);
    if (kind == NodeKind::Grey) return;
    certain_ += piece_volume;
    include(inner_box_, polyhedron, -1);
  }

  PieceBounds bounds() const {
    const double error = error_ + count_ * 0x1p-53 * all_;
    PieceBounds bounds{std::max(certain_ - error, 0.0), all_ + error, inner_box_, outer_box_};
    // What is certain may be thinner than the errors.
    if (inner_box_ && glm::any(glm::greaterThan(inner_box_->lower, inner_box_->upper))) {
      bounds.inner_box.reset();
    }
    return bounds;
  }

 private:
  /// The box grows by the vertices, each as far out (`sense` 1) or in (-1) as its error allows.
  static void include(std::optional<Box>& box, const Polyhedron& polyhedron, double sense) {
    for (const PolyhedronVertex& vertex : polyhedron.vertices) {
      const Vec3 margin(sense * vertex.error);
      if (!box) box = Box{vertex.position - margin, vertex.position + margin};
      box->lower = glm::min(box->lower, vertex.position - margin);
      box->upper = glm::max(box->upper, vertex.position + margin);
    }
  }

  const double side_;
  double certain_ = 0;
  double all_ = 0;
  double error_ = 0;
  double count_ = 0;
  std::optional<Box> inner_box_;
  std::optional<Box> outer_box_;
};

}  // namespace

PieceBounds bound_pieces(const Octree& tree, std::uint32_t level) {
  Collector collector(tree);
  WalkOptions options;
  options.level = level;
  walk_pieces(tree, options, collector);
  return collector.bounds();
}

}  // namespace spoctree
