#include "client/lines/visible_lines.hpp"

#include <algorithm>
#include <cmath>

#include "client/lines/arrange_lines.hpp"
#include "client/lines/find_seen_parts.hpp"
#include "common/base/errors.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

Creases creases_of(const Surface& surface) {
  Creases creases;
  creases.creases.reserve(surface.edges.size());
  creases.sides.reserve(surface.sides.size());
  for (const Surface::Edge& edge : surface.edges) {
    creases.creases.push_back(
        {surface.vertices[edge.a], surface.vertices[edge.b], edge.first_side, edge.side_count});
  }
  for (const Surface::Side& side : surface.sides) {
    creases.sides.push_back({surface.faces[side.face].plane, side.forward});
  }
  return creases;
}

/// Parts of creases, each merged to as few as there are; what is shorter than `shortest`, gap or
/// part, goes to its neighbours unless it is a whole crease.
void merge_parts(std::vector<CreasePart>& parts, const Creases& creases, double shortest) {
  std::sort(parts.begin(), parts.end(), [](const CreasePart& p, const CreasePart& q) {
    return p.crease != q.crease ? p.crease < q.crease : p.interval.begin < q.interval.begin;
  });
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
      if (part->interval.begin > from)
        rest.push_back({crease, kNeitherSide, {from, part->interval.begin}});
      from = part->interval.end;
    }
    if (from < 1) rest.push_back({crease, kNeitherSide, {from, 1}});
  }
  return rest;
}

VisibleLine line_of(const CreasePart& part, const Creases& creases, LineKind kind, bool hidden) {
  const Crease& crease = creases.creases[part.crease];
  const auto at = [&](double t) {
    return t <= 0 ? crease.a : (t >= 1 ? crease.b : crease.a + t * (crease.b - crease.a));
  };
  VisibleLine line{at(part.interval.begin), at(part.interval.end), kind, hidden, false, {}, {}};
  const auto sides = creases.sides_of(crease);
  for (std::size_t k = 0; k < 2 && k < sides.size(); ++k) line.planes[k] = sides[k].plane;
  return line;
}

}  // namespace

VisibleLines visible_lines(const Octree& tree, const Surface& surface, const Camera& camera,
                           const LineOptions& options) {
  if (!(options.crease_angle_deg >= 0 && options.crease_angle_deg <= 180)) {
    throw UsageError("the crease angle must be between 0 and 180 degrees");
  }
  const double unit = std::sqrt(3.0) * 2 * tree.universe.half_side;
  const double shortest = kShortestLine * unit;
  const PlaneSet planes = tree.plane_set();
  const Creases creases = creases_of(surface);

  std::vector<LineKind> kinds(creases.creases.size());
  std::vector<std::uint32_t> wanted;  // all that should be drawn, if they can be seen
  std::vector<CreasePart> open;       // those not hidden by their own material
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    const Crease& crease = creases.creases[k];
    // A line in the line of sight is a point.
    if (glm::distance(camera.project(crease.a), camera.project(crease.b)) < 1e-3 * shortest) {
      continue;
    }
    const LineSides sides = open_sides(crease, creases, planes, camera);
    if (sides == kNeitherSide && !options.with_hidden_lines) continue;
    const bool silhouette = is_silhouette(crease, creases, planes, camera);
    kinds[k] = silhouette ? LineKind::Silhouette : LineKind::Crease;
    if (!silhouette && options.crease_angle_deg > 0 &&
        crease_angle_deg(crease, creases, planes) < options.crease_angle_deg) {
      continue;
    }
    wanted.push_back(k);
    if (sides != kNeitherSide) open.push_back({k, sides, {0, 1}});
  }

  std::vector<CreasePart> seen =
      find_seen_parts(tree, options.level, creases, std::move(open), camera);
  const double joint = kJoinTolerance * unit;
  merge_parts(seen, creases, kShortestGlimpse * unit);
  VisibleLines lines;
  for (const CreasePart& part : seen) {
    lines.push_back(line_of(part, creases, kinds[part.crease], false));
  }
  if (options.with_hidden_lines) {
    for (const CreasePart& part : rest_of(wanted, seen)) {
      lines.push_back(line_of(part, creases, kinds[part.crease], true));
    }
  }
  lines = remove_overlaps(join_lines(lines, joint), camera, joint);
  std::erase_if(lines, [&](const VisibleLine& line) {
    return glm::distance(camera.project(line.a), camera.project(line.b)) < shortest;
  });
  return in_pen_order(lines, camera);
}

}  // namespace spoctree
