// Convex polyhedra -> their corners.
#pragma once

#include <algorithm>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/corner_sum.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

/// Adds the corners of pieces to a sum. A vertex of more than three faces is as many corners as it
/// takes: a fan of threes around its first face, whose inner edges cancel.
class PolyhedronCorners : public PieceVisitor {
 public:
  PolyhedronCorners(const Carriers& carriers, CornerSum& sum) : carriers_(carriers), sum_(sum) {}

  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    numbers_.clear();
    for (const Polyhedron::Face& face : piece.faces) {
      numbers_.push_back(carriers_.number_of(face.plane));
    }
    first_face_.assign(piece.vertices.size(), static_cast<std::uint32_t>(-1));
    for_each_corner(piece, [&](std::uint32_t vertex, std::uint32_t face, std::uint32_t) {
      first_face_[vertex] = std::min(first_face_[vertex], face);
    });
    for_each_corner(piece, [&](std::uint32_t vertex, std::uint32_t face, std::uint32_t next) {
      const std::uint32_t first = first_face_[vertex];
      if (face == first || next == first) return;
      sum_.add(numbers_[first], numbers_[face], numbers_[next], 1);
    });
  }

 private:
  /// Calls visit(vertex, face, next face counter-clockwise around the vertex).
  template <class Visit>
  static void for_each_corner(const Polyhedron& piece, Visit&& visit) {
    for (std::uint32_t face = 0; face < piece.faces.size(); ++face) {
      const auto loop = piece.loop(piece.faces[face]);
      // Across the edge that arrives lies the face that comes next.
      std::uint32_t next = loop.back().across;
      for (const Polyhedron::Corner& corner : loop) {
        visit(corner.vertex, face, next);
        next = corner.across;
      }
    }
  }

  const Carriers& carriers_;
  CornerSum& sum_;
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint32_t> first_face_;
};

}  // namespace spoctree
