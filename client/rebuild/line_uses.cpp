#include "client/rebuild/line_uses.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "client/rebuild/flat_index.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

struct Corner {
  std::uint32_t vertex = 0;
  std::uint32_t across = 0;  ///< the carrier beyond the edge to the next corner
};

/// Faces that wait for the opposite face of a neighbour. Storage of cancelled ones is used again.
class OpenFaces {
 public:
  /// Keeps the face, or drops it together with its opposite.
  void add(CarrierSide side, std::span<const Corner> face) {
    std::uint64_t key = side >> 1;
    for (const Corner& corner : face) key += mix_bits(corner.vertex + 1);
    const std::uint32_t opposite = index_.take(key, [&](std::uint32_t candidate) {
      return faces_[candidate].side == (side ^ 1u) && is_reverse(corners_of(candidate), face);
    });
    if (opposite != FlatIndex::kNone) {
      free_corners_[size_class(faces_[opposite].count)].push_back(faces_[opposite].first);
      faces_[opposite].count = 0;
      free_faces_.push_back(opposite);
    } else {
      index_.insert(key, store(side, face));
    }
  }

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      if (faces_[i].count > 0) visit(faces_[i].side, corners_of(i));
    }
  }

 private:
  struct Face {
    CarrierSide side = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  static constexpr std::size_t kSizeClasses = 16;  // by number of corners; the last is for the rest

  static std::size_t size_class(std::size_t count) { return std::min(count, kSizeClasses - 1); }
  std::span<const Corner> corners_of(std::uint32_t face) const {
    return {corners_.data() + faces_[face].first, faces_[face].count};
  }

  static bool is_reverse(std::span<const Corner> a, std::span<const Corner> b) {
    const std::size_t n = a.size();
    if (n != b.size()) return false;
    std::size_t at = 0;  // of a's first corner in b
    while (at < n && b[at].vertex != a[0].vertex) ++at;
    if (at == n) return false;
    for (std::size_t i = 0; i < n; ++i) {
      // The edge that leaves a[i] is the one that arrives in b[at].
      if (a[i].vertex != b[at].vertex) return false;
      at = at == 0 ? n - 1 : at - 1;
      if (a[i].across != b[at].across) return false;
    }
    return true;
  }

  std::uint32_t store(CarrierSide side, std::span<const Corner> face) {
    const auto count = static_cast<std::uint32_t>(face.size());
    auto& free = free_corners_[size_class(count)];
    std::uint32_t first;
    if (count < kSizeClasses - 1 && !free.empty()) {
      first = free.back();
      free.pop_back();
      std::copy(face.begin(), face.end(), corners_.begin() + first);
    } else {
      first = static_cast<std::uint32_t>(corners_.size());
      corners_.insert(corners_.end(), face.begin(), face.end());
    }
    std::uint32_t index;
    if (free_faces_.empty()) {
      index = static_cast<std::uint32_t>(faces_.size());
      faces_.push_back({side, first, count});
    } else {
      index = free_faces_.back();
      free_faces_.pop_back();
      faces_[index] = {side, first, count};
    }
    return index;
  }

  std::vector<Face> faces_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> free_faces_;
  std::array<std::vector<std::uint32_t>, kSizeClasses> free_corners_;
  FlatIndex index_;
};

class Collector : public PieceVisitor {
 public:
  Collector(Carriers& carriers, VertexWelder& welder) : carriers_(carriers), welder_(welder) {}

  void piece(const NodeAddress&, NodeKind kind, std::uint32_t, const Polyhedron& piece) override {
    positions_.clear();
    for (const PolyhedronVertex& vertex : piece.vertices) positions_.push_back(vertex.position);
    welder_.weld(positions_, ids_);
    const bool is_split = kind == NodeKind::Concave || kind == NodeKind::Vertex;
    for (const Polyhedron::Face& face : piece.faces) {
      const CarrierSide side = carriers_.side_of(face.plane);
      read_loop(piece.loop(face));
      if (face_.size() < 2) continue;
      // Only walls and the planes that split a node can have material on both sides.
      if (face_.size() > 2 && (is_split || face.plane.is_wall())) {
        open_.add(side, face_);
      } else {
        use(side, face_);
      }
    }
  }

  LineUses take() {
    open_.for_each([&](CarrierSide side, std::span<const Corner> face) { use(side, face); });
    result_.sides.resize(carriers_.count());
    return std::move(result_);
  }

 private:
  /// The loop without the edges that welding has shrunk to nothing.
  void read_loop(std::span<const Polyhedron::Corner> loop) {
    face_.clear();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::uint32_t from = ids_[loop[k].vertex];
      const std::uint32_t to = ids_[loop[k + 1 == loop.size() ? 0 : k + 1].vertex];
      if (from != to) face_.push_back({from, carriers_.side_of(loop[k].across) >> 1});
    }
  }

  void use(CarrierSide side, std::span<const Corner> face) {
    const std::uint32_t carrier = side >> 1;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t to = face[k + 1 == face.size() ? 0 : k + 1].vertex;
      const std::uint32_t across = face[k].across;
      result_.uses.push_back({std::min(carrier, across), std::max(carrier, across), face[k].vertex,
                              to | (carrier > across ? LineUse::kOnHigh : 0)});
    }
    if (result_.sides.size() <= carrier) result_.sides.resize(carriers_.count());
    result_.sides[carrier] |= static_cast<std::uint8_t>(1u << (side & 1));
  }

  Carriers& carriers_;
  VertexWelder& welder_;
  OpenFaces open_;
  LineUses result_;
  std::vector<Vec3> positions_;
  std::vector<std::uint32_t> ids_;
  std::vector<Corner> face_;
};

}  // namespace

LineUses collect_line_uses(const Octree& tree, std::uint32_t level, Carriers& carriers,
                           VertexWelder& welder) {
  Collector collector(carriers, welder);
  WalkOptions options;
  options.level = level;
  walk_pieces(tree, options, collector);
  return collector.take();
}

}  // namespace spoctree
