#include "client/cells/merge_cells.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <queue>
#include <unordered_map>
#include <utility>

#include "common/geometry/polyhedron_clipper.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

namespace {

/// Positions err by less than this, and so does the value of a plane there, a few times over.
constexpr double kSurelyOff = 0x1p-40;

/// Shared faces are found by their boxes in steps of this; those that fall apart because they are
/// rounded to different steps are not merged, which is a pity only.
constexpr double kBoxStep = 0x1p-34;

class Merger {
 public:
  Merger(std::vector<Polyhedron> cells, const PlaneSet& planes, const ProgressShare& progress)
      : planes_(planes), progress_(progress), cells_(std::move(cells)) {
    make_cell(NodeAddress{}.lower, NodeAddress{}.size(), planes_, universe_);
  }

  MergedCells run() {
    const std::size_t before = cells_.size();
    merged_into_.assign(before, kNone);
    std::size_t faces = 0;
    for (const Polyhedron& cell : cells_) faces += cell.faces.size();
    cell_at_.reserve(faces);
    for (std::uint32_t cell = 0; cell < before; ++cell) {
      progress_.add(0.5 * per_item(before));
      add_faces(cell);
    }
    while (!shared_.empty()) {
      const Shared shared = shared_.top();
      shared_.pop();
      if (merged_into_[shared.first] == kNone && merged_into_[shared.second] == kNone &&
          make_union(shared)) {
        progress_.add(0.5 * per_item(before));
        unite(shared.first, shared.second);
      }
    }
    progress_.tell();
    return compact(before);
  }

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  struct Shared {
    double area;
    std::uint32_t first;
    std::uint32_t second;
    PlaneRef plane;  ///< outward of `first`

    bool operator<(const Shared& other) const {
      if (area != other.area) return area < other.area;
      return std::pair(first, second) > std::pair(other.first, other.second);
    }
  };

  /// Off the middle between steps, where walls often are.
  static std::int64_t step_of(double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / kBoxStep + 0.3819660113));
  }

  /// Of a face's place: its plane's name, turned as asked, and its box.
  static std::uint64_t key_of(const Polyhedron& cell, const Polyhedron::Face& face,
                              PlaneRef plane) {
    Vec3 lower(2.0);
    Vec3 upper(-2.0);
    for (const Polyhedron::Corner& corner : cell.loop(face)) {
      lower = glm::min(lower, cell.vertices[corner.vertex].position);
      upper = glm::max(upper, cell.vertices[corner.vertex].position);
    }
    std::uint64_t key = plane.code() * 0x9E3779B97F4A7C15u;
    for (const Vec3 corner : {lower, upper}) {
      for (int axis = 0; axis < 3; ++axis) {
        key = (key ^ (key >> 29) ^ static_cast<std::uint64_t>(step_of(corner[axis]))) *
              0xBF58476D1CE4E5B9u;
      }
    }
    return key ^ (key >> 32);
  }

  static double area_of(const Polyhedron& cell, const Polyhedron::Face& face) {
    const auto loop = cell.loop(face);
    const Vec3 origin = cell.vertices[loop[0].vertex].position;
    Vec3 twice_area{0.0};
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      twice_area += glm::cross(cell.vertices[loop[k].vertex].position - origin,
                               cell.vertices[loop[k + 1].vertex].position - origin);
    }
    return 0.5 * glm::length(twice_area);
  }

  /// Where another cell has a face in the same place, on the other side, they may be merged.
  void add_faces(std::uint32_t cell) {
    for (const Polyhedron::Face& face : cells_[cell].faces) {
      cell_at_[key_of(cells_[cell], face, face.plane)] = cell;
      const auto found = cell_at_.find(key_of(cells_[cell], face, face.plane.flipped()));
      if (found == cell_at_.end() || merged_into_[found->second] != kNone) continue;
      shared_.push({area_of(cells_[cell], face), cell, found->second, face.plane});
    }
  }

  static bool has_face(const Polyhedron& cell, PlaneRef plane) {
    return std::any_of(cell.faces.begin(), cell.faces.end(),
                       [&](const Polyhedron::Face& face) { return face.plane == plane; });
  }

  /// All of the cell is inside the planes of the other one, but for the shared one.
  bool is_inside(const Polyhedron& cell, const Polyhedron& other, PlaneRef shared) const {
    for (const Polyhedron::Face& face : other.faces) {
      if (face.plane == shared) continue;
      const Plane plane = planes_[face.plane];
      for (const PolyhedronVertex& vertex : cell.vertices) {
        const double value = glm::dot(plane.normal, vertex.position) - plane.offset;
        if (value < -kSurelyOff) continue;
        if (value > kSurelyOff || side_of_vertex(vertex, face.plane, planes_) > 0) return false;
      }
    }
    return true;
  }

  /// Into `union_`; false if it is not convex. What is inside the planes of both, but for the
  /// shared one, is on one side of that in one cell, on the other side in the other.
  bool make_union(const Shared& shared) {
    const Polyhedron& first = cells_[shared.first];
    const Polyhedron& second = cells_[shared.second];
    if (!has_face(second, shared.plane.flipped()) ||  // another place with the same key
        !is_inside(second, first, shared.plane) ||
        !is_inside(first, second, shared.plane.flipped())) {
      return false;
    }
    union_planes_.clear();
    for (const Polyhedron::Face& face : first.faces) {
      if (face.plane != shared.plane) union_planes_.push_back(face.plane);
    }
    for (const Polyhedron::Face& face : second.faces) {
      if (face.plane != shared.plane.flipped()) union_planes_.push_back(face.plane);
    }
    std::sort(union_planes_.begin(), union_planes_.end());
    union_planes_.erase(std::unique(union_planes_.begin(), union_planes_.end()),
                        union_planes_.end());
    union_ = universe_;
    for (const PlaneRef plane : union_planes_) {
      if (clipper_.clip(union_, plane, planes_) == ClipResult::Empty) return false;
    }
    // Equal planes of different names would leave one of their faces without a plane of its name.
    return union_.faces.size() == union_planes_.size();
  }

  void unite(std::uint32_t first, std::uint32_t second) {
    const auto whole = static_cast<std::uint32_t>(cells_.size());
    merged_into_[first] = merged_into_[second] = whole;
    merged_into_.push_back(kNone);
    cells_[first] = {};
    cells_[second] = {};
    Polyhedron& stored = cells_.emplace_back(union_);
    stored.vertices.shrink_to_fit();
    stored.corners.shrink_to_fit();
    stored.faces.shrink_to_fit();
    add_faces(whole);
  }

  MergedCells compact(std::size_t before) {
    MergedCells merged;
    std::vector<std::uint32_t> number(cells_.size(), kNone);
    // A cell is merged into one with a greater number.
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      if (merged_into_[cell] != kNone) continue;
      number[cell] = static_cast<std::uint32_t>(merged.cells.size());
      merged.cells.push_back(std::move(cells_[cell]));
    }
    for (std::size_t cell = cells_.size(); cell-- > 0;) {
      if (number[cell] == kNone) number[cell] = number[merged_into_[cell]];
    }
    merged.cell_of.assign(number.begin(), number.begin() + static_cast<std::ptrdiff_t>(before));
    return merged;
  }

  const PlaneSet planes_;
  ProgressCounter progress_;
  Polyhedron universe_;
  std::vector<Polyhedron> cells_;
  std::vector<std::uint32_t> merged_into_;
  std::unordered_map<std::uint64_t, std::uint32_t> cell_at_;  // by the key of a face
  std::priority_queue<Shared> shared_;
  PolyhedronClipper clipper_;
  Polyhedron union_;
  std::vector<PlaneRef> union_planes_;
};

}  // namespace

MergedCells merge_cells(std::vector<Polyhedron> cells, const PlaneSet& planes,
                        const ProgressShare& progress) {
  return Merger(std::move(cells), planes, progress).run();
}

}  // namespace spoctree
