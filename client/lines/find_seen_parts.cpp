#include "client/lines/find_seen_parts.hpp"

#include <algorithm>
#include <cmath>

#include "client/lines/covered_picture.hpp"
#include "client/lines/outline.hpp"
#include "client/lines/view.hpp"
#include "common/geometry/predicates.hpp"
#include "common/geometry/tolerances.hpp"
#include "common/tree/expression.hpp"

namespace spoctree {

namespace {

std::vector<ProjectedLine> project_all(const std::vector<Crease>& creases,
                                       const std::vector<bool>& is_wanted, const Camera& camera) {
  std::vector<ProjectedLine> projected(creases.size());
  for (std::size_t k = 0; k < creases.size(); ++k) {
    if (is_wanted[k]) projected[k] = project(creases[k].a, creases[k].b, camera);
  }
  return projected;
}

/// What of the frame the wanted creases take up: nothing else is looked at.
Rectangle extent_of(const std::vector<ProjectedLine>& creases, const Rectangle& frame) {
  Rectangle extent{frame.upper, frame.lower};
  for (const ProjectedLine& crease : creases) {
    if (!(crease.range.begin < crease.range.end)) continue;
    for (const Vec2 end : {crease.a, crease.b}) {
      extent.lower = glm::min(extent.lower, end);
      extent.upper = glm::max(extent.upper, end);
    }
  }
  if (extent.lower.x > extent.upper.x) return {};
  extent.lower = glm::max(extent.lower, frame.lower);
  extent.upper = glm::min(extent.upper, frame.upper);
  return extent;
}

class Looker {
 public:
  Looker(const LineScene& scene, const std::vector<bool>& is_wanted, const Camera& camera,
         const Rectangle& frame, const ProgressShare& progress)
      : scene_(scene),
        tree_(scene.tree()),
        planes_(tree_.plane_set()),
        camera_(camera),
        viewpoint_(camera.viewpoint()),
        is_wanted_(is_wanted),
        reach_(kCreaseTolerance * scene.diagonal()),
        tolerance_(kPictureTolerance * scene.diagonal()),
        projected_(project_all(scene.creases().creases, is_wanted, camera)),
        covered_(extent_of(projected_, frame), scene.pieces().leaf_count() / 2),
        progress_(progress) {}

  std::vector<CreasePart> run() {
    visit({}, 1);
    progress_.tell();
    return std::move(seen_);
  }

 private:
  double wall(std::uint32_t index) const { return wall_coordinate(planes_.half_side(), index); }

  /// Exact: one wrong order next to a viewer in a plane could hide anything behind it.
  bool viewer_is_outside(const Plane& plane) const {
    return side_of_any_point({plane.normal, plane.offset * viewpoint_.w}, viewpoint_.xyz) > 0;
  }

  /// A share of `work` is done then.
  void visit(const NodeAddress& node, double work) {
    const Level& level = tree_.levels[node.level];
    const NodeKind kind = level.kinds[node.index];
    const bool is_leaf = kind != NodeKind::Grey || node.level == scene_.level();
    const LeafPieces* const pieces = is_leaf ? scene_.pieces().find(node) : nullptr;
    const auto parts = is_leaf ? scene_.parts().of(node) : std::span<const CreasePart>{};
    if (scene_.extents().is_empty(node)) {
      progress_.add(work);
      return;
    }
    const auto extent = extent_of_box(scene_.extents().of(node), camera_);
    if (extent && covered_.is_full(*extent)) {
      progress_.add(work);
      return;
    }
    if (is_leaf) {
      look_at_leaf(node, pieces, parts);
      progress_.add(work);
      return;
    }
    std::uint32_t nearest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = wall(node.lower[axis] + node.size() / 2);
      if (viewpoint_.xyz[axis] > viewpoint_.w * middle)
        nearest |= 1u << static_cast<unsigned>(axis);
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
      visit(node.child(level.first_child[node.index], i ^ nearest), work / 8);
    }
  }

  void look_at_leaf(const NodeAddress& node, const LeafPieces* pieces,
                    std::span<const CreasePart> parts) {
    const Vec3 lower{wall(node.lower[0]), wall(node.lower[1]), wall(node.lower[2])};
    const double side = wall(node.lower[0] + node.size()) - lower.x;
    waiting_.clear();
    for (const CreasePart& part : parts) {
      if (!is_wanted_[part.crease]) continue;
      if (pieces == nullptr || is_on_near_wall(part, lower, side)) {
        look_at(part);
      } else {
        waiting_.push_back(part);
      }
    }
    if (pieces == nullptr) return;
    later_.clear();
    if (!waiting_.empty()) divide_by_bounds(*pieces);
    // What divide_by_bounds has put off is looked at last: it is not in use by then.
    const auto expression = scene_.pieces().expression(*pieces);
    if (!expression.empty()) {
      walk_expression(node, *pieces, expression);
    } else {
      // What is waiting still lies within the piece, or behind it.
      cover(pieces->is_whole_cube ? cube_corners(lower, side)
                                  : scene_.pieces().corners(*pieces, 0));
    }
    for (const CreasePart& part : later_) look_at(part);
  }

  std::span<const Vec3> cube_corners(Vec3 lower, double side) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      cube_[corner] = lower + side * Vec3{corner & 1, corner >> 1 & 1, corner >> 2};
    }
    return cube_;
  }

  Vec3 at(const CreasePart& part, double t) const {
    const Crease& crease = scene_.creases().creases[part.crease];
    return crease.a + t * (crease.b - crease.a);
  }

  /// The cell on the viewer's side of the wall has come before. There is none beyond the universe's
  /// walls; those count if they are seen edge-on, too: nothing out there hides anything.
  bool is_on_near_wall(const CreasePart& part, Vec3 lower, double side) const {
    const Vec3 begin = at(part, part.interval.begin);
    const Vec3 end = at(part, part.interval.end);
    for (int axis = 0; axis < 3; ++axis) {
      const double upper = lower[axis] + side;
      const double viewer = viewpoint_.xyz[axis];
      const double above = viewer - viewpoint_.w * upper;
      const double below = viewpoint_.w * lower[axis] - viewer;
      const bool upper_is_near = above > 0 || (above == 0 && upper == planes_.half_side());
      const bool lower_is_near = below > 0 || (below == 0 && lower[axis] == -planes_.half_side());
      if ((upper_is_near && std::min(begin[axis], end[axis]) > upper - reach_) ||
          (lower_is_near && std::max(begin[axis], end[axis]) < lower[axis] + reach_)) {
        return true;
      }
    }
    return false;
  }

  /// Divides a part where it crosses { plane = threshold }.
  template <class Visit>
  void divide(const CreasePart& part, const Plane& plane, double threshold, Visit&& visit) const {
    const auto value = [&](double t) {
      return glm::dot(plane.normal, at(part, t)) - plane.offset - threshold;
    };
    const double at_begin = value(part.interval.begin);
    const double at_end = value(part.interval.end);
    if ((at_begin > 0) == (at_end > 0)) {
      visit(part, at_begin > 0);
      return;
    }
    const double border = part.interval.begin + (part.interval.end - part.interval.begin) *
                                                    (at_begin / (at_begin - at_end));
    visit({part.crease, {part.interval.begin, border}}, at_begin > 0);
    visit({part.crease, {border, part.interval.end}}, at_end > 0);
  }

  /// Planes that bound all pieces of a leaf. What is on the viewer's side of one that faces the
  /// viewer is looked at at once; what is beyond one that does not, when the leaf is done.
  void divide_by_bounds(const LeafPieces& pieces) {
    const auto bounds = scene_.pieces().bounds(pieces);
    for (const bool faces_viewer : {true, false}) {
      for (const std::uint32_t bound : bounds) {
        const Plane& plane = tree_.planes[bound];
        if ((camera_.facing(plane) >= 0) != faces_viewer || waiting_.empty()) continue;
        divided_.clear();
        for (const CreasePart& whole : waiting_) {
          divide(whole, plane, faces_viewer ? -reach_ : reach_,
                 [&](const CreasePart& part, bool is_beyond) {
                   if (!is_beyond) {
                     divided_.push_back(part);
                   } else if (faces_viewer) {
                     look_at(part);
                   } else {
                     later_.push_back(part);
                   }
                 });
        }
        std::swap(waiting_, divided_);
      }
    }
  }

  /// A stack of its own instead of recursion: there are as many splits within each other as the
  /// node has planes.
  void walk_expression(const NodeAddress& node, const LeafPieces& pieces,
                       std::span<const std::uint32_t> tokens) {
    const auto own = tree_.levels[node.level].planes_of(node.index);
    find_ends(tokens, ends_);
    number_in_cells(tokens, in_cells_);
    // The parts of the cells that are still to come; those of the nearest cell last.
    std::swap(parts_, waiting_);
    cells_.assign(1, {0, 0});
    while (!cells_.empty()) {
      const Cell cell = cells_.back();
      cells_.pop_back();
      const std::uint32_t token = tokens[cell.token];
      if (token < kFirstPlaneToken) {
        if (token == kInToken) {
          cover(scene_.pieces().corners(pieces, in_cells_[cell.token]));
        } else {
          for (std::size_t k = cell.first_part; k < parts_.size(); ++k) look_at(parts_[k]);
        }
        parts_.resize(cell.first_part);
        continue;
      }
      const Plane& plane = tree_.planes[own[token - kFirstPlaneToken]];
      const bool outside_is_near = viewer_is_outside(plane);
      near_.clear();
      far_.clear();
      for (std::size_t k = cell.first_part; k < parts_.size(); ++k) {
        divide(parts_[k], plane, outside_is_near ? -reach_ : reach_,
               [&](const CreasePart& part, bool is_beyond) {
                 (is_beyond == outside_is_near ? near_ : far_).push_back(part);
               });
      }
      parts_.resize(cell.first_part);
      parts_.insert(parts_.end(), far_.begin(), far_.end());
      const std::uint32_t inside = cell.token + 1;
      const std::uint32_t outside = ends_[inside];
      cells_.push_back({outside_is_near ? inside : outside, cell.first_part});
      cells_.push_back({outside_is_near ? outside : inside, parts_.size()});
      parts_.insert(parts_.end(), near_.begin(), near_.end());
    }
  }

  /// Pieces meet up to rounding, which is larger in the picture where they are near the viewer; but
  /// what covers too much beside pieces that reach past the viewer hides more than seams would
  /// show.
  double tolerance_of(std::span<const Vec3> corners) const {
    constexpr double kMostGrowth = 64;
    if (!camera_.is_perspective()) return tolerance_;
    double depth = camera_.focal_length();
    for (const Vec3 corner : corners) depth = std::min(depth, camera_.depth(corner));
    const double least = camera_.focal_length() / kMostGrowth;
    return tolerance_ * camera_.focal_length() / std::max(depth, least);
  }

  void cover(std::span<const Vec3> corners) {
    project(corners, camera_, points_);
    if (points_.size() < 3) return;
    find_outline(points_, outline_);
    covered_.cover(outline_, tolerance_of(corners));
  }

  void look_at(const CreasePart& part) {
    const ProjectedLine& crease = projected_[part.crease];
    const double begin = std::max(part.interval.begin, crease.range.begin);
    const double end = std::min(part.interval.end, crease.range.end);
    if (!(begin < end)) return;
    uncovered_.clear();
    covered_.find_uncovered(crease.a, crease.b, {crease.to_picture(begin), crease.to_picture(end)},
                            uncovered_);
    for (const Interval& interval : uncovered_) {
      seen_.push_back(
          {part.crease, {crease.to_space(interval.begin), crease.to_space(interval.end)}});
    }
  }

  struct Cell {
    std::uint32_t token;
    std::size_t first_part;
  };

  const LineScene& scene_;
  const Octree& tree_;
  const PlaneSet planes_;
  const Camera& camera_;
  const Viewpoint viewpoint_;
  const std::vector<bool>& is_wanted_;
  const double reach_;
  const double tolerance_;
  const std::vector<ProjectedLine> projected_;
  CoveredPicture covered_;
  std::vector<CreasePart> seen_;
  ProgressCounter progress_;
  // Working memory.
  Vec3 cube_[8];
  std::vector<CreasePart> waiting_, divided_, later_, parts_, near_, far_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> ends_, in_cells_;
  std::vector<Vec2> points_, outline_;
  std::vector<Interval> uncovered_;
};

}  // namespace

std::vector<CreasePart> find_seen_parts(const LineScene& scene, const std::vector<bool>& is_wanted,
                                        const Camera& camera, const Rectangle& frame,
                                        const ProgressShare& progress) {
  return Looker(scene, is_wanted, camera, frame, progress).run();
}

}  // namespace spoctree
