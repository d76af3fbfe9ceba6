#include "client/lines/crease_pool.hpp"

#include <glm/geometric.hpp>

namespace spoctree {

namespace {

/// Rests shorter than this many tolerances stay with the part they are a rest of, and parts that
/// touch a region along less are left where they are: a touch decides nothing.
constexpr double kShortestRest = 4;

/// Shrinks `interval` to the part in the half-space moved outwards by `tolerance`; false if nothing
/// is left.
bool clip(const Crease& crease, const Plane& plane, double tolerance, Interval& interval) {
  const double at_a = glm::dot(plane.normal, crease.a) - plane.offset - tolerance;
  const double slope = glm::dot(plane.normal, crease.b - crease.a);
  const double begin = at_a + slope * interval.begin;
  const double end = at_a + slope * interval.end;
  if (begin > 0 && end > 0) return false;
  if (begin > 0 || end > 0) {
    const double crossing =
        interval.begin + (interval.end - interval.begin) * (begin / (begin - end));
    (begin > 0 ? interval.begin : interval.end) = crossing;
  }
  return true;
}

}  // namespace

void CreasePool::take(std::span<const Plane> half_spaces, std::vector<CreasePart>& taken) {
  const std::size_t first = frames_.back();
  std::size_t kept = first;
  rests_.clear();
  for (std::size_t k = first; k < parts_.size(); ++k) {
    const CreasePart part = parts_[k];
    const Crease& crease = creases_[part.crease];
    Interval inside = part.interval;
    bool touches = true;
    for (const Plane& plane : half_spaces) {
      if (!clip(crease, plane, tolerance_, inside)) {
        touches = false;
        break;
      }
    }
    if (touches && (inside.begin > part.interval.begin || inside.end < part.interval.end)) {
      const double shortest = kShortestRest * tolerance_ / glm::distance(crease.a, crease.b);
      if (inside.begin - part.interval.begin < shortest) inside.begin = part.interval.begin;
      if (part.interval.end - inside.end < shortest) inside.end = part.interval.end;
      touches = inside.end - inside.begin >= shortest;
    }
    if (!touches) {
      parts_[kept++] = part;
      continue;
    }
    taken.push_back({part.crease, part.sides, inside});
    if (inside.begin > part.interval.begin) {
      rests_.push_back({part.crease, part.sides, {part.interval.begin, inside.begin}});
    }
    if (inside.end < part.interval.end) {
      rests_.push_back({part.crease, part.sides, {inside.end, part.interval.end}});
    }
  }
  parts_.resize(kept);
  parts_.insert(parts_.end(), rests_.begin(), rests_.end());
}

void CreasePool::open_frame(std::span<const Plane> half_spaces) {
  moved_.clear();
  if (!frame_is_empty()) take(half_spaces, moved_);
  frames_.push_back(parts_.size());
  parts_.insert(parts_.end(), moved_.begin(), moved_.end());
}

}  // namespace spoctree
