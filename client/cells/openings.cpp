#include "client/cells/openings.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "client/cells/cell_polygon.hpp"

namespace spoctree {

namespace {

/// Corners err by less than this, a few times over.
constexpr double kBoxMargin = 0x1p-40;

class Finder {
 public:
  Finder(const std::vector<Polyhedron>& cells, const PlaneSet& planes,
         const ProgressShare& progress, std::size_t most)
      : cells_(cells), planes_(planes), progress_(progress), most_(most) {}

  Openings run() {
    collect_faces();
    for (auto begin = faces_.begin(); begin != faces_.end();) {
      const PlaneRef carrier = begin->plane.carrier();
      const auto end = std::find_if(
          begin, faces_.end(), [&](const Face& face) { return face.plane.carrier() != carrier; });
      pair_up({begin, end});
      progress_.add(static_cast<double>(end - begin) * per_item(faces_.size()));
      begin = end;
    }
    list_by_cell();
    progress_.tell();
    return std::move(result_);
  }

 private:
  struct Face {
    PlaneRef plane;
    std::uint32_t cell;
    std::uint32_t number;
    Vec3 lower;
    Vec3 upper;
  };

  bool is_universe_wall(PlaneRef plane) const {
    const std::uint32_t last = std::uint32_t{1} << kMaxDepth;
    return plane.is_wall() && plane.index() == (plane.is_flipped() ? 0 : last);
  }

  /// Those of one plane together, and of these those of one side.
  void collect_faces() {
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      const Polyhedron& polyhedron = cells_[cell];
      for (std::uint32_t number = 0; number < polyhedron.faces.size(); ++number) {
        Face face{polyhedron.faces[number].plane, cell, number, Vec3(2.0), Vec3(-2.0)};
        if (is_universe_wall(face.plane)) {
          copy_face(polyhedron, polyhedron.faces[number], polygon_);
          add({cell, kOuterSpace}, face.plane);
          continue;
        }
        for (const Polyhedron::Corner& corner : polyhedron.loop(polyhedron.faces[number])) {
          face.lower = glm::min(face.lower, polyhedron.vertices[corner.vertex].position);
          face.upper = glm::max(face.upper, polyhedron.vertices[corner.vertex].position);
        }
        faces_.push_back(face);
      }
    }
    std::sort(faces_.begin(), faces_.end(), [](const Face& p, const Face& q) {
      if (p.plane.carrier() != q.plane.carrier()) return p.plane.carrier() < q.plane.carrier();
      return std::pair(p.cell, p.number) < std::pair(q.cell, q.number);
    });
  }

  /// Sweeps along the axis on which the faces of a plane are spread widest.
  void pair_up(std::span<Face> faces) {
    if (faces.size() < 2) return;
    Vec3 lower(2.0);
    Vec3 upper(-2.0);
    for (const Face& face : faces) {
      lower = glm::min(lower, face.lower);
      upper = glm::max(upper, face.upper);
    }
    const Vec3 spread = upper - lower;
    const int axis =
        spread.x >= spread.y ? (spread.x >= spread.z ? 0 : 2) : (spread.y >= spread.z ? 1 : 2);
    std::stable_sort(faces.begin(), faces.end(), [axis](const Face& p, const Face& q) {
      return p.lower[axis] < q.lower[axis];
    });
    std::vector<const Face*>* const open = open_;
    open[0].clear();
    open[1].clear();
    for (const Face& face : faces) {
      const bool side = face.plane.is_flipped();
      std::vector<const Face*>& others = open[!side];
      std::erase_if(others, [&](const Face* other) {
        return other->upper[axis] < face.lower[axis] - kBoxMargin;
      });
      for (const Face* other : others) {
        if (other->cell < face.cell) {
          intersect(*other, face);
        } else {
          intersect(face, *other);
        }
      }
      open[side].push_back(&face);
    }
  }

  void intersect(const Face& first, const Face& second) {
    for (int axis = 0; axis < 3; ++axis) {
      if (first.upper[axis] < second.lower[axis] - kBoxMargin ||
          second.upper[axis] < first.lower[axis] - kBoxMargin) {
        return;
      }
    }
    const Polyhedron& other = cells_[second.cell];
    copy_face(cells_[first.cell], cells_[first.cell].faces[first.number], polygon_);
    for (const Polyhedron::Corner& corner : other.loop(other.faces[second.number])) {
      if (!clipper_.clip(polygon_, first.plane, other.plane_across(corner), planes_)) return;
    }
    add({first.cell, second.cell}, first.plane);
  }

  void add(std::pair<std::uint32_t, std::uint32_t> cells, PlaneRef plane) {
    small_count(result_.openings.size() + 1, "openings between cells", most_);
    Opening opening;
    opening.cells[0] = cells.first;
    opening.cells[1] = cells.second;
    opening.plane = plane;
    opening.first_corner = small_count(result_.corners.size(), "corners of openings");
    opening.corner_count = static_cast<std::uint32_t>(polygon_.corners.size());
    for (const CellPolygon::Corner& corner : polygon_.corners) {
      result_.corners.push_back(corner.vertex.position);
    }
    result_.openings.push_back(opening);
  }

  void list_by_cell() {
    const std::size_t count = cells_.size() + 1;
    const auto row_of = [&](std::uint32_t cell) {
      return cell == kOuterSpace ? cells_.size() : cell;
    };
    std::vector<std::uint32_t>& begin = result_.begin;
    begin.assign(count + 1, 0);
    for (const Opening& opening : result_.openings) {
      for (const std::uint32_t cell : opening.cells) ++begin[row_of(cell) + 1];
    }
    for (std::size_t k = 0; k < count; ++k) begin[k + 1] += begin[k];
    result_.numbers.resize(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t number = 0; number < result_.openings.size(); ++number) {
      for (const std::uint32_t cell : result_.openings[number].cells) {
        result_.numbers[next[row_of(cell)]++] = number;
      }
    }
  }

  const std::vector<Polyhedron>& cells_;
  const PlaneSet planes_;
  ProgressCounter progress_;
  const std::size_t most_;
  Openings result_;
  std::vector<Face> faces_;
  std::vector<const Face*> open_[2];
  CellPolygonClipper clipper_;
  CellPolygon polygon_;
};

}  // namespace

Openings find_openings(const std::vector<Polyhedron>& cells, const PlaneSet& planes,
                       const ProgressShare& progress, std::size_t most) {
  return Finder(cells, planes, progress, most).run();
}

}  // namespace spoctree
