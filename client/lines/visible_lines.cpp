#include "client/lines/visible_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/lines/arrange_lines.hpp"
#include "client/lines/extent.hpp"
#include "client/lines/find_seen_parts.hpp"
#include "client/lines/line_source.hpp"
#include "client/lines/view.hpp"
#include "client/rebuild/radix_sort.hpp"
#include "common/base/errors.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// The shares of the steps, where there are a million faces.
constexpr double kChoosing = 0.04;
constexpr double kLooking = 0.7;
constexpr double kMerging = 0.03;
constexpr double kMaking = 0.04;
constexpr double kJoining = 0.07;
constexpr double kComparing = 0.08;
constexpr double kOrdering = 0.04;

/// Parts of creases, each merged to as few as there are; what is shorter than `shortest`, gap or
/// part, goes to its neighbours unless it is a whole crease.
void merge_parts(std::vector<CreasePart>& parts, const Creases& creases, double shortest) {
  radix_sort(parts, creases.creases.size(), [](const CreasePart& part) { return part.crease; });
  for (auto begin = parts.begin(); begin != parts.end();) {
    const auto end = std::find_if(
        begin, parts.end(), [&](const CreasePart& part) { return part.crease != begin->crease; });
    std::sort(begin, end, [](const CreasePart& p, const CreasePart& q) {
      return p.interval.begin < q.interval.begin;
    });
    begin = end;
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < parts.size();) {
    CreasePart merged = parts[k];
    const Crease& crease = creases.creases[merged.crease];
    const double least = shortest / glm::distance(crease.a, crease.b);
    for (++k; k < parts.size() && parts[k].crease == merged.crease &&
              parts[k].interval.begin <= merged.interval.end + least;
         ++k) {
      merged.interval.end = std::max(merged.interval.end, parts[k].interval.end);
    }
    if (merged.interval.begin < least) merged.interval.begin = 0;
    if (merged.interval.end > 1 - least) merged.interval.end = 1;
    const double length = merged.interval.end - merged.interval.begin;
    if (length >= least || length == 1) parts[kept++] = merged;
  }
  parts.resize(kept);
}

/// The parts of the creases in `wanted` that are not in `parts`; both by ascending crease.
std::vector<CreasePart> rest_of(std::span<const std::uint32_t> wanted,
                                const std::vector<CreasePart>& parts) {
  std::vector<CreasePart> rest;
  auto part = parts.begin();
  for (const std::uint32_t crease : wanted) {
    double from = 0;
    for (; part != parts.end() && part->crease == crease; ++part) {
      if (part->interval.begin > from) rest.push_back({crease, {from, part->interval.begin}});
      from = part->interval.end;
    }
    if (from < 1) rest.push_back({crease, {from, 1}});
  }
  return rest;
}

void keep_what_is_in_front(std::vector<CreasePart>& parts, const Creases& creases,
                           const Camera& camera) {
  for (CreasePart& part : parts) {
    const Crease& crease = creases.creases[part.crease];
    const Interval range = project(crease.a, crease.b, camera).range;
    part.interval.begin = std::max(part.interval.begin, range.begin);
    part.interval.end = std::min(part.interval.end, range.end);
  }
  std::erase_if(parts,
                [](const CreasePart& part) { return !(part.interval.begin < part.interval.end); });
}

/// Of T_k alone, that is while GREY nodes wait for their children: in a complete tree, faces in
/// cell walls are there to stay (a classical octree has no others).
bool is_step(const LineScene& scene, const Crease& crease) {
  if (scene.tree().levels[scene.level()].grey_count == 0) return false;
  const auto sides = scene.creases().sides_of(crease);
  return std::any_of(sides.begin(), sides.end(),
                     [](const CreaseSide& side) { return side.plane.is_wall(); });
}

bool is_asked_for(const LineScene& scene, const Crease& crease, LineKind kind,
                  const LineOptions& options) {
  if (is_step(scene, crease)) return options.with_steps;
  return kind == LineKind::Crease ? options.with_creases : options.with_silhouettes;
}

/// All of it is one point of the picture, however many of its kind follow each other.
bool is_end_on(const Crease& crease, const Camera& camera) {
  if (camera.is_perspective()) return false;
  const Vec3 way = crease.b - crease.a;
  return std::abs(glm::dot(camera.right(), way)) + std::abs(glm::dot(camera.up(), way)) <=
         kShortestLine * glm::length(way);
}

/// From either side.
bool are_same_plane(PlaneRef a, PlaneRef b) { return a == b || a == b.flipped(); }

class LineMaker {
 public:
  LineMaker(const LineScene& scene, std::vector<LineKind> kinds)
      : scene_(scene), kinds_(std::move(kinds)) {}

  VisibleLine line_of(const CreasePart& part, bool hidden) const {
    const Crease& crease = scene_.creases().creases[part.crease];
    const auto at = [&](double t) {
      return t <= 0 ? crease.a : (t >= 1 ? crease.b : crease.a + t * (crease.b - crease.a));
    };
    VisibleLine line;
    line.a = at(part.interval.begin);
    line.b = at(part.interval.end);
    line.kind = kinds_[part.crease];
    line.hidden = hidden;
    // Where four faces meet, two of them may lie in one plane.
    const auto sides = scene_.creases().sides_of(crease);
    line.planes[0] = line.planes[1] = sides[0].plane;
    for (const CreaseSide& side : sides) {
      if (are_same_plane(line.planes[0], line.planes[1])) line.planes[1] = side.plane;
    }
    line.is_step = is_step(scene_, crease);
    return line;
  }

 private:
  const LineScene& scene_;
  const std::vector<LineKind> kinds_;
};

/// Cuts lines where their sources differ.
VisibleLines split_by_source(const VisibleLines& lines) {
  VisibleLines split;
  for (const VisibleLine& line : lines) {
    const std::vector<LineStretch> stretches = stretches_of(line);
    double begin = 0;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      if (k + 1 < stretches.size() && stretches[k].source == stretches[k + 1].source) continue;
      split.push_back(cut(line, begin, stretches[k].end));
      begin = stretches[k].end;
    }
  }
  return split;
}

}  // namespace

VisibleLines visible_lines(const LineScene& scene, const Camera& camera,
                           const LineOptions& options) {
  if (!(options.crease_angle_deg >= 0 && options.crease_angle_deg <= 180)) {
    throw UsageError("the crease angle must be between 0 and 180 degrees");
  }
  const double unit = scene.diagonal();
  const double shortest = kShortestLine * unit;
  const PlaneSet planes = scene.tree().plane_set();
  const Creases& creases = scene.creases();

  std::vector<LineKind> kinds(creases.creases.size());
  std::vector<std::uint32_t> wanted;                         // all that is drawn, if it is seen
  std::vector<bool> is_open(creases.creases.size(), false);  // not hidden by its own material
  ProgressCounter choosing(options.progress.part(kChoosing));
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    choosing.add(per_item(kinds.size()));
    const Crease& crease = creases.creases[k];
    if (is_end_on(crease, camera) || is_flat(crease, creases, planes)) continue;
    const bool is_seen = may_be_seen(crease, creases, planes, camera);
    if (!is_seen && !options.with_hidden_lines) continue;
    const bool silhouette = is_silhouette(crease, creases, planes, camera);
    kinds[k] = silhouette ? LineKind::Silhouette : LineKind::Crease;
    if (!is_asked_for(scene, crease, kinds[k], options)) continue;
    if (!silhouette && options.crease_angle_deg > 0 && !is_step(scene, crease) &&
        crease_angle_deg(crease, creases, planes) < options.crease_angle_deg - kTurnTolerance) {
      continue;
    }
    wanted.push_back(k);
    is_open[k] = is_seen;
  }
  choosing.tell();

  const Rectangle frame =
      options.frame ? *options.frame : extent_of_universe(scene.tree().universe, camera);
  const ProgressShare looking = options.progress.part(kLooking);
  std::vector<CreasePart> seen = options.find_seen_parts
                                     ? options.find_seen_parts(is_open, camera, frame, looking)
                                     : find_seen_parts(scene, is_open, camera, frame, looking);
  merge_parts(seen, creases, kShortestGlimpse * unit);
  options.progress.add(kMerging);
  std::vector<CreasePart> hidden;
  if (options.with_hidden_lines) {
    hidden = rest_of(wanted, seen);
    keep_what_is_in_front(hidden, creases, camera);
  }
  const LineMaker maker(scene, std::move(kinds));
  VisibleLines lines;
  lines.reserve(seen.size() + hidden.size());
  ProgressCounter making(options.progress.part(kMaking));
  const auto make = [&](const CreasePart& part, bool is_hidden) {
    making.add(per_item(seen.size() + hidden.size()));
    lines.push_back(maker.line_of(part, is_hidden));
  };
  for (const CreasePart& part : seen) make(part, false);
  for (const CreasePart& part : hidden) make(part, true);
  making.tell();
  small_count(2 * lines.size(), "ends of lines", kMostIn32Bits - 1);
  lines = join_lines(lines, kJoinTolerance * unit, options.progress.part(kJoining));
  lines = remove_overlaps(std::move(lines), camera, kOverlapTolerance * unit,
                          options.progress.part(kComparing));
  std::erase_if(lines, [&](const VisibleLine& line) {
    return glm::distance(camera.project(line.a), camera.project(line.b)) < shortest;
  });
  lines = in_pen_order(std::move(lines), camera, options.progress.part(kOrdering));
  find_sources(lines, scene.tree(), scene.level());
  return options.split_by_source ? split_by_source(lines) : lines;
}

VisibleLines visible_lines(const Octree& tree, const Surface& surface, const Camera& camera,
                           const LineOptions& options) {
  return visible_lines(LineScene(tree, surface, options.level), camera, options);
}

}  // namespace spoctree
