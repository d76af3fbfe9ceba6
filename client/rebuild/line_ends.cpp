#include "client/rebuild/line_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "client/rebuild/line_end_sum.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

class Collector : public PieceVisitor {
 public:
  Collector(const Octree& tree, Carriers& carriers, VertexWelder& welder)
      : half_side_(tree.universe.half_side), carriers_(carriers), welder_(welder) {}

  void piece(const NodeAddress& node, NodeKind kind, std::uint32_t,
             const Polyhedron& piece) override {
    positions_.clear();
    for (const PolyhedronVertex& vertex : piece.vertices) positions_.push_back(vertex.position);
    welder_.weld(positions_, ids_);
    name_faces(piece);
    // A node of one piece has nothing to cancel in itself.
    const bool is_alone = kind != NodeKind::Concave && kind != NodeKind::Vertex;
    LineEndSum& sum = sums_[is_alone ? node.level : node.level + 1];
    for (std::size_t f = 0; f < piece.faces.size(); ++f) {
      const CarrierSide side = sides_[f];
      std::uint8_t& known_sides = result_.sides[side >> 1];
      known_sides = static_cast<std::uint8_t>(known_sides | (1u << (side & 1)));
      const std::uint32_t carrier = side >> 1;
      const auto loop = piece.loop(piece.faces[f]);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        // Each edge once, from one of its faces.
        if (loop[k].across < piece.faces[f].plane) continue;
        const std::uint32_t across = carrier_of(piece, loop[k].across);
        std::uint32_t from = ids_[loop[k].vertex];
        std::uint32_t to = ids_[loop[k + 1 == loop.size() ? 0 : k + 1].vertex];
        if (from == to) continue;
        if (carrier > across) std::swap(from, to);
        const std::uint32_t low = std::min(carrier, across);
        const std::uint32_t high = std::max(carrier, across);
        sum.add(low, high, from, -1);
        sum.add(low, high, to, 1);
      }
    }
  }

  void leave(const NodeAddress& node) override {
    // Ends inside the cell are final; those on its walls may meet others.
    double lower[3];
    double upper[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double margin = 4 * welder_.tolerance();
      lower[axis] = wall_coordinate(half_side_, node.lower[axis]) + margin;
      upper[axis] = wall_coordinate(half_side_, node.lower[axis] + node.size()) - margin;
    }
    LineEndSum& outer = sums_[node.level];
    sums_[node.level + 1].flush([&](const LineEnd& end) {
      const Vec3 p = welder_.vertices()[end.vertex];
      const bool is_inside = p.x > lower[0] && p.x < upper[0] && p.y > lower[1] && p.y < upper[1] &&
                             p.z > lower[2] && p.z < upper[2];
      if (is_inside) {
        result_.ends.push_back(end);
      } else {
        outer.add(end.low, end.high, end.vertex, end.count);
      }
    });
  }

  LineEnds take() {
    sums_[0].flush([&](const LineEnd& end) { result_.ends.push_back(end); });
    return std::move(result_);
  }

 private:
  void name_faces(const Polyhedron& piece) {
    sides_.clear();
    for (const Polyhedron::Face& face : piece.faces) {
      sides_.push_back(carriers_.side_of(face.plane));
    }
    result_.sides.resize(carriers_.count());
  }

  /// Every plane across an edge is that of a face.
  std::uint32_t carrier_of(const Polyhedron& piece, PlaneRef plane) {
    constexpr std::size_t kFew = 12;
    if (piece.faces.size() <= kFew) {
      for (std::size_t f = 0; f < piece.faces.size(); ++f) {
        if (piece.faces[f].plane == plane) return sides_[f] >> 1;
      }
    }
    return carriers_.side_of(plane) >> 1;
  }

  const double half_side_;
  Carriers& carriers_;
  VertexWelder& welder_;
  LineEnds result_;
  /// sums_[0] for the whole tree, sums_[k + 1] for the node of level k that is being visited.
  std::array<LineEndSum, kMaxDepth + 2> sums_;
  std::vector<Vec3> positions_;
  std::vector<std::uint32_t> ids_;
  std::vector<CarrierSide> sides_;
};

}  // namespace

LineEnds collect_line_ends(const Octree& tree, std::uint32_t level, Carriers& carriers,
                           VertexWelder& welder) {
  Collector collector(tree, carriers, welder);
  WalkOptions options;
  options.level = level;
  walk_pieces(tree, options, collector);
  return collector.take();
}

}  // namespace spoctree
