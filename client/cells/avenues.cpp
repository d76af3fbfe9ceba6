#include "client/cells/avenues.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "client/cells/sight_mask.hpp"
#include "common/geometry/predicates.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

class Walker {
 public:
  Walker(const EmptySpace& space, const CellCreases& parts, const Creases& creases,
         const std::vector<bool>& is_wanted, const Camera& camera, const Rectangle& frame,
         const ProgressShare& progress)
      : space_(space),
        planes_(space.tree().plane_set()),
        parts_(parts),
        creases_(creases),
        is_wanted_(is_wanted),
        camera_(camera),
        viewpoint_(camera.viewpoint()),
        frame_(frame),
        progress_(progress),
        thinnest_(kThinnestMask * diagonal()),
        tolerance_(kMaskTolerance * diagonal()),
        seen_openings_(space.openings().openings.size()),
        projected_(creases.creases.size()),
        is_projected_(creases.creases.size(), false),
        is_seen_(space.cells().size(), false) {}

  std::vector<CreasePart> run(AvenueCounts& counts) {
    const SightMask picture = mask_of(frame_);
    whole_area_ = std::max(area_of(picture.corners), std::numeric_limits<double>::min());
    for (const std::uint32_t cell : space_.find_cells(viewpoint_, kEyeInPlane)) {
      if (cell == kOuterSpace) {
        go_on_from(kOuterSpace, picture.corners, 0);
        look_at_universe_walls(picture);
      } else {
        begin_in(cell, picture);
      }
    }
    while (!open_.empty()) {
      const Avenue avenue = open_.back();
      open_.pop_back();
      mask_.assign(masks_.begin() + static_cast<std::ptrdiff_t>(avenue.first_corner), masks_.end());
      masks_.resize(avenue.first_corner);
      ++counts_.avenues;
      counts_.longest = std::max(counts_.longest, avenue.openings);
      if (!is_seen_[avenue.cell]) ++counts_.cells;
      is_seen_[avenue.cell] = true;
      for (const CreasePart& part : parts_.of(avenue.cell)) look_at(part, mask_);
      go_on_from(avenue.cell, mask_, avenue.openings);
    }
    progress_.tell();
    counts = counts_;
    return std::move(seen_);
  }

 private:
  struct Avenue {
    std::uint32_t cell;
    std::uint32_t openings;    ///< passed so far
    std::size_t first_corner;  ///< of its mask, which is the last one but for those of later ones
  };

  /// An opening as this viewer sees it; found when an avenue first comes to it.
  struct Seen {
    bool is_known = false;
    int side = 0;  ///< of the viewer, with respect to the plane; 0: seen edge-on, or too thin
    std::uint32_t first_corner = 0;
    Rectangle box;
  };

  double diagonal() const { return std::sqrt(3.0) * 2 * space_.tree().universe.half_side; }

  /// Exact, as every cell's place in the partition is, but for planes that the eye is in up to
  /// rounding: they have been there before it.
  int side_of_viewer(PlaneRef ref) const {
    const Plane plane = planes_[ref];
    if (camera_.is_perspective() &&
        std::abs(glm::dot(plane.normal, viewpoint_.xyz) - plane.offset) <= kEyeInPlane) {
      return 0;
    }
    return side_of_any_point({plane.normal, plane.offset * viewpoint_.w}, viewpoint_.xyz);
  }

  /// The directions from an eye in a face of the cell that go into the cell.
  void begin_in(std::uint32_t cell, const SightMask& picture) {
    SightMask mask = picture;
    for (const Polyhedron::Face& face : space_.cells()[cell].faces) {
      if (side_of_viewer(face.plane) < 0) continue;
      const Vec3 normal = -planes_[face.plane].normal;
      const double x = glm::dot(normal, camera_.right()) / camera_.focal_length();
      const double y = glm::dot(normal, camera_.up()) / camera_.focal_length();
      const double w = -glm::dot(normal, camera_.toward_viewer());
      const double length = std::hypot(x, y);
      if (length > 0 && !clipper_.clip(mask, {x / length, y / length, w / length}, thinnest_)) {
        return;
      }
      if (length == 0 && w < 0) return;
    }
    push(cell, 0, mask.corners);
  }

  void push(std::uint32_t cell, std::uint32_t openings,
            const std::vector<SightMask::Corner>& mask) {
    open_.push_back({cell, openings, masks_.size()});
    masks_.insert(masks_.end(), mask.begin(), mask.end());
  }

  const Seen& see(std::uint32_t number) {
    Seen& seen = seen_openings_[number];
    if (seen.is_known) return seen;
    seen.is_known = true;
    const Openings& all = space_.openings();
    const Opening& opening = all.openings[number];
    seen.side = side_of_viewer(opening.plane);
    if (seen.side == 0) return seen;
    const auto corners = all.corners_of(opening);
    seen.first_corner = static_cast<std::uint32_t>(corners_.size());
    bool is_in_front = true;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    seen.box = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    in_picture_.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      // Counter-clockwise for this viewer.
      const Vec3 corner = corners[seen.side > 0 ? k : corners.size() - 1 - k];
      const SightPoint at = sight_point(corner, camera_);
      corners_.push_back({at, {}});
      is_in_front &= at.w >= camera_.least_depth();
      if (!is_in_front) continue;
      const Vec2 in_picture{at.x / at.w, at.y / at.w};
      in_picture_.push_back({in_picture, {}});
      seen.box.lower = glm::min(seen.box.lower, in_picture);
      seen.box.upper = glm::max(seen.box.upper, in_picture);
    }
    if (!is_in_front) seen.box = {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
    if (is_in_front && is_too_thin(in_picture_, thinnest_)) {
      seen.side = 0;
      return seen;
    }
    SightOpening::Corner* const own = &corners_[seen.first_corner];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      own[k].line = sight_line(own[k].at, own[k + 1 == corners.size() ? 0 : k + 1].at);
      touch(own[k].line, {own, corners.size()});
    }
    return seen;
  }

  /// Moves a line outwards until no corner is beyond it. Where planes meet in a vertex of the
  /// solid, openings have edges as short as rounding, whose directions mean nothing: they must not
  /// cut.
  void touch(SightLine& line, std::span<const SightOpening::Corner> corners) const {
    double farthest = 0;
    for (const SightOpening::Corner& corner : corners) {
      if (corner.at.w < camera_.least_depth()) continue;
      farthest = std::min(farthest, line(corner.at) / corner.at.w);
    }
    line.c -= farthest;
  }

  /// What of the mask goes on through no opening is done.
  void go_on_from(std::uint32_t cell, const std::vector<SightMask::Corner>& mask,
                  std::uint32_t openings) {
    Rectangle box{mask[0].at, mask[0].at};
    for (const SightMask::Corner& corner : mask) {
      box.lower = glm::min(box.lower, corner.at);
      box.upper = glm::max(box.upper, corner.at);
    }
    double done = area_of(mask);
    for (const std::uint32_t number : space_.openings().of(cell)) {
      const Seen& seen = see(number);
      const Opening& opening = space_.openings().openings[number];
      const bool is_first = opening.cells[0] == cell;
      // Out of the cell only; out of the universe cube there is nothing more to be seen.
      if (seen.side == 0 || (seen.side < 0) != is_first) continue;
      const std::uint32_t beyond = opening.cells[is_first ? 1 : 0];
      if (beyond == kOuterSpace) continue;
      if (seen.box.lower.x > box.upper.x || seen.box.upper.x < box.lower.x ||
          seen.box.lower.y > box.upper.y || seen.box.upper.y < box.lower.y) {
        continue;
      }
      const SightOpening polygon{{corners_.data() + seen.first_corner, opening.corner_count}};
      if (!clipper_.clip(mask, polygon, thinnest_, next_)) continue;
      done -= area_of(next_.corners);
      push(beyond, openings + 1, next_.corners);
    }
    progress_.add(std::max(0.0, done / whole_area_));
  }

  void look_at(const CreasePart& part, const std::vector<SightMask::Corner>& mask) {
    if (!is_wanted_[part.crease]) return;
    ProjectedCrease& crease = projected_[part.crease];
    if (!is_projected_[part.crease]) {
      is_projected_[part.crease] = true;
      const Crease& line = creases_.creases[part.crease];
      crease.a = sight_point(line.a, camera_);
      crease.b = sight_point(line.b, camera_);
      crease.range = {0, 1};
      const double least = camera_.least_depth();
      const double border = (least - crease.a.w) / (crease.b.w - crease.a.w);
      if (crease.a.w < least && crease.b.w < least) {
        crease.range.end = 0;
      } else if (crease.a.w < least) {
        crease.range.begin = border;
      } else if (crease.b.w < least) {
        crease.range.end = border;
      }
    }
    Interval seen{std::max(part.interval.begin, crease.range.begin),
                  std::min(part.interval.end, crease.range.end)};
    if (!(seen.begin < seen.end)) return;
    clip_line(crease.a, crease.b, mask, tolerance_, seen);
    if (seen.begin < seen.end) seen_.push_back({part.crease, seen});
  }

  /// Those that face the viewer are seen from outside; there is no cell that has them.
  void look_at_universe_walls(const SightMask& picture) {
    const double half = space_.tree().universe.half_side;
    const double reach = kCreaseTolerance * diagonal();
    for (std::uint32_t number = 0; number < creases_.creases.size(); ++number) {
      const Crease& crease = creases_.creases[number];
      for (int axis = 0; axis < 3; ++axis) {
        const double viewer = viewpoint_.xyz[axis];
        const bool is_upper = std::min(crease.a[axis], crease.b[axis]) > half - reach &&
                              viewer >= viewpoint_.w * half;
        const bool is_lower = std::max(crease.a[axis], crease.b[axis]) < -half + reach &&
                              viewer <= -viewpoint_.w * half;
        if (is_upper || is_lower) look_at({number, {0, 1}}, picture.corners);
      }
    }
  }

  struct ProjectedCrease {
    SightPoint a;
    SightPoint b;
    Interval range;  ///< in front of the viewer
  };

  const EmptySpace& space_;
  const PlaneSet planes_;
  const CellCreases& parts_;
  const Creases& creases_;
  const std::vector<bool>& is_wanted_;
  const Camera& camera_;
  const Viewpoint viewpoint_;
  const Rectangle frame_;
  ProgressCounter progress_;
  const double thinnest_;
  const double tolerance_;
  double whole_area_ = 1;
  std::vector<CreasePart> seen_;
  AvenueCounts counts_;
  std::vector<Seen> seen_openings_;
  std::vector<SightOpening::Corner> corners_;  // of the openings seen so far
  std::vector<ProjectedCrease> projected_;
  std::vector<bool> is_projected_;
  std::vector<bool> is_seen_;  // by cell
  // The stack: avenues to go on with, and their masks.
  std::vector<Avenue> open_;
  std::vector<SightMask::Corner> masks_;
  // Working memory.
  MaskClipper clipper_;
  std::vector<SightMask::Corner> mask_, in_picture_;
  SightMask next_;
};

}  // namespace

std::vector<CreasePart> find_parts_in_avenues(const EmptySpace& space, const CellCreases& parts,
                                              const Creases& creases,
                                              const std::vector<bool>& is_wanted,
                                              const Camera& camera, const Rectangle& frame,
                                              AvenueCounts* counts, const ProgressShare& progress) {
  AvenueCounts own;
  return Walker(space, parts, creases, is_wanted, camera, frame, progress)
      .run(counts != nullptr ? *counts : own);
}

}  // namespace spoctree
