#include "client/lines/find_seen_parts.hpp"

#include <algorithm>
#include <cmath>

#include "client/lines/covered_region.hpp"
#include "client/lines/extent.hpp"
#include "client/lines/outline.hpp"
#include "common/geometry/tolerances.hpp"
#include "common/tree/pieces.hpp"

namespace spoctree {

namespace {

/// Walks the tree from front to back and collects the parts of creases that can be seen.
class Looker : public PieceVisitor {
 public:
  Looker(const Octree& tree, const Creases& creases, std::vector<CreasePart> open,
         const Camera& camera, double unit, CoveredRegion& covered)
      : creases_(creases),
        camera_(camera),
        tolerance_(kPictureTolerance * unit),
        reach_(kCreaseTolerance * unit),
        sweep_(kCreaseDepthTolerance * unit),
        planes_(tree.plane_set()),
        outlines_(planes_, tree.planes.size(), camera, tolerance_),
        pool_(creases.creases, std::move(open), reach_),
        covered_(covered) {}

  bool enter(const NodeAddress& address, NodeKind, const Polyhedron& region) override {
    if (pool_.is_empty()) return false;
    if (covered_.is_full(extent_of(region))) {
      // What can be seen of it lies behind full tiles; so do the creases on it.
      if (!pool_.frame_is_empty()) {
        taken_.clear();
        half_spaces_.clear();
        for (const Polyhedron::Face& face : region.faces) {
          half_spaces_.push_back(planes_[face.plane]);
        }
        pool_.take(half_spaces_, taken_);
      }
      return false;
    }
    half_spaces_.clear();
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t lower = address.lower[axis];
      half_spaces_.push_back(swept(PlaneRef::of_wall(axis, lower).flipped()));
      half_spaces_.push_back(swept(PlaneRef::of_wall(axis, lower + address.size())));
    }
    pool_.open_frame(half_spaces_);
    return true;
  }

  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron& piece) override {
    outlines_.find(piece, outline_);
    if (!pool_.frame_is_empty()) {
      taken_.clear();
      find_swept_half_spaces(piece);
      pool_.take(half_spaces_, taken_);
      for (const CreasePart& part : taken_) look_at(part, piece);
    }
    covered_.cover(outline_);
  }

  void leave(const NodeAddress&) override { pool_.close_frame(); }

  std::vector<CreasePart> take_seen() { return std::move(seen_); }

 private:
  Rectangle extent_of(const Polyhedron& region) const {
    const Vec2 first = camera_.project(region.vertices.front().position);
    Rectangle extent{first, first};
    for (const PolyhedronVertex& vertex : region.vertices) {
      const Vec2 at = camera_.project(vertex.position);
      extent.lower = glm::min(extent.lower, at);
      extent.upper = glm::max(extent.upper, at);
    }
    return extent;
  }

  /// The piece swept as `swept` says: its faces, then what lies under its outline, edge by edge
  /// (for the half-spaces of the faces grow aside, too).
  void find_swept_half_spaces(const Polyhedron& piece) {
    half_spaces_.clear();
    for (const Polyhedron::Face& face : piece.faces) half_spaces_.push_back(swept(face.plane));
    for (std::size_t k = 0; k < outline_.size(); ++k) {
      const Vec2 from = outline_[k];
      const Vec2 along = outline_[k + 1 == outline_.size() ? 0 : k + 1] - from;
      const Vec2 outwards = Vec2{along.y, -along.x} / glm::length(along);
      half_spaces_.push_back(
          {outwards.x * camera_.right() + outwards.y * camera_.up(), glm::dot(outwards, from)});
    }
  }

  /// The half-space swept a little away from the viewer. A crease close behind a piece, and in the
  /// picture on its outline, is the piece's own up to rounding: faces that are almost seen edge-on
  /// make much depth of little breadth.
  Plane swept(PlaneRef ref) const {
    Plane plane = planes_[ref];
    plane.offset += sweep_ * std::max(0.0, -glm::dot(plane.normal, camera_.toward_viewer()));
    return plane;
  }

  /// Judges a part of a crease that `piece`, whose outline is `outline_`, is the first to touch.
  /// What can hide the piece is in the covered region by now, and nothing behind the piece is;
  /// beside the crease, that is so where the outline extends. On a side where it does not (the
  /// piece ends there, or is seen edge-on), the next piece that touches the part will judge. If
  /// none does, a nearer crease makes the same line in the picture.
  void look_at(const CreasePart& part, const Polyhedron& piece) {
    const Crease& crease = creases_.creases[part.crease];
    const Vec2 origin = camera_.project(crease.a);
    const Vec2 step = camera_.project(crease.b) - origin;
    auto judged = static_cast<LineSides>(part.sides & sides_of_outline(origin, step));
    const auto open = static_cast<LineSides>(part.sides & ~judged);
    judged = static_cast<LineSides>(judged & ~sides_blocked_by(piece, part));
    if (judged == kNeitherSide) {
      if (open != kNeitherSide) pool_.put_back({part.crease, open, part.interval});
      return;
    }
    parts_.clear();
    covered_.uncovered_parts(origin, step, part.interval, judged, parts_);
    for (const Interval& interval : parts_) seen_.push_back({part.crease, judged, interval});
    if (open == kNeitherSide) return;
    // Only what the covered region ends at: what it covers on both sides stays hidden.
    hidden_.clear();
    append_rest(part.interval, parts_, hidden_);
    for (const Interval& hidden : hidden_) {
      parts_.clear();
      covered_.uncovered_parts(origin, step, hidden, open, parts_);
      for (const Interval& interval : parts_) pool_.put_back({part.crease, open, interval});
    }
  }

  /// The sides of a line of the picture on which the outline extends.
  LineSides sides_of_outline(Vec2 origin, Vec2 step) const {
    const Vec2 left = Vec2{-step.y, step.x} / glm::length(step);
    LineSides sides = kNeitherSide;
    for (const Vec2 corner : outline_) {
      const double distance = glm::dot(left, corner - origin);
      if (distance > tolerance_) sides |= kLeftSide;
      if (distance < -tolerance_) sides |= kRightSide;
    }
    return sides;
  }

  /// The sides beside which the line of sight enters the piece itself: all of the piece's faces
  /// that the part lies on look away. REQUIRES: find_swept_half_spaces(piece) (that
  /// those of faces that look away are swept does not matter).
  LineSides sides_blocked_by(const Polyhedron& piece, const CreasePart& part) const {
    const Crease& crease = creases_.creases[part.crease];
    const Vec3 along = crease.b - crease.a;
    const Vec3 begin = crease.a + part.interval.begin * along;
    const Vec3 end = crease.a + part.interval.end * along;
    const Vec3 left = glm::cross(camera_.toward_viewer(), along);
    LineSides blocked = kBothSides;
    for (std::size_t k = 0; k < piece.faces.size() && blocked != kNeitherSide; ++k) {
      const Plane& plane = half_spaces_[k];
      const double depth =
          plane.offset - std::min(glm::dot(plane.normal, begin), glm::dot(plane.normal, end));
      if (depth > 2 * reach_) continue;  // the part does not lie on this face
      const int facing = outlines_.facing(piece.faces[k].plane);
      if (facing > 0) return kNeitherSide;
      if (facing == 0) blocked &= glm::dot(plane.normal, left) > 0 ? kRightSide : kLeftSide;
    }
    return blocked;
  }

  /// The parts of `whole` that are in none of `parts`, which are sorted by that.
  static void append_rest(Interval whole, std::vector<Interval>& parts,
                          std::vector<Interval>& rest) {
    std::sort(parts.begin(), parts.end(),
              [](const Interval& p, const Interval& q) { return p.begin < q.begin; });
    double from = whole.begin;
    for (const Interval& part : parts) {
      if (part.begin > from) rest.push_back({from, part.begin});
      from = std::max(from, part.end);
    }
    if (from < whole.end) rest.push_back({from, whole.end});
  }

  const Creases& creases_;
  const Camera& camera_;
  const double tolerance_;
  const double reach_;
  const double sweep_;
  const PlaneSet planes_;
  OutlineFinder outlines_;
  CreasePool pool_;
  CoveredRegion& covered_;
  std::vector<CreasePart> seen_;
  // Working memory.
  std::vector<Plane> half_spaces_;
  std::vector<CreasePart> taken_;
  std::vector<Interval> parts_;
  std::vector<Interval> hidden_;
  std::vector<Vec2> outline_;
};

/// About so many tiles that a few pieces are seen in each.
std::uint32_t tiles_per_side(const Octree& tree, std::uint32_t level, std::size_t crease_count) {
  std::size_t nodes = crease_count;
  for (std::uint32_t k = 0; k < tree.levels.size() && k <= level; ++k) {
    const auto counts = tree.levels[k].count_kinds();
    nodes += tree.levels[k].size() - counts[static_cast<int>(NodeKind::White)];
  }
  const double wanted = 0.5 * std::sqrt(static_cast<double>(nodes));
  return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 1024.0));
}

}  // namespace

std::vector<CreasePart> find_seen_parts(const Octree& tree, std::uint32_t level,
                                        const Creases& creases, std::vector<CreasePart> open,
                                        const Camera& camera) {
  const double unit = std::sqrt(3.0) * 2 * tree.universe.half_side;
  CoveredRegion covered(extent_of_universe(tree.universe, camera),
                        tiles_per_side(tree, level, creases.creases.size()),
                        kPictureTolerance * unit);
  Looker looker(tree, creases, std::move(open), camera, unit, covered);
  walk_pieces(tree, {level, camera.viewpoint()}, looker);
  return looker.take_seen();
}

}  // namespace spoctree
