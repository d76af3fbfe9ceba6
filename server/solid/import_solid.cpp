#include "server/solid/import_solid.hpp"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "server/solid/facets.hpp"
#include "server/solid/find_rounding.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/merge_faces.hpp"
#include "server/solid/neighbours.hpp"
#include "server/solid/self_intersections.hpp"
#include "server/solid/settle_on_grid.hpp"
#include "server/solid/shells.hpp"
#include "server/solid/touching.hpp"
#include "server/solid/triangulate.hpp"

namespace spoctree {

namespace {

// The connected surface that each triangle is in, numbered from 1 in the order of the file.
std::vector<std::uint32_t> number_parts(const std::vector<Corners>& neighbours,
                                        std::uint32_t& parts) {
  std::vector<std::uint32_t> part_of(neighbours.size(), 0);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t first = 0; first < neighbours.size(); ++first) {
    if (part_of[first] != 0) continue;
    part_of[first] = ++parts;
    reached.assign(1, first);
    while (!reached.empty()) {
      const Corners around = neighbours[reached.back()];
      reached.pop_back();
      for (const std::uint32_t n : around) {
        if (part_of[n] != 0) continue;
        part_of[n] = parts;
        reached.push_back(n);
      }
    }
  }
  return part_of;
}

[[noreturn]] void fail_for_meeting(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                                   const MeetingTriangles& meeting) {
  // The coordinates of the file may be finer than the grid; then say whose fault it is.
  const auto as_filed = find_self_intersections(mesh.points, mesh.triangles,
                                                box_tree_of(mesh.points, mesh.triangles));
  const bool is_by_rounding = as_filed.pairs.count() == 0 && as_filed.are_all;
  std::uint32_t parts = 0;
  const std::vector<std::uint32_t> part_of = number_parts(neighbours, parts);
  FirstFound<std::array<std::uint32_t, 2>> within;
  FirstFound<std::array<std::uint32_t, 2>> between;
  std::vector<bool> is_meeting(parts + 1, false);
  for (auto [a, b] : meeting.pairs) {
    if (a > b) std::swap(a, b);
    const bool is_one = part_of[a] == part_of[b];
    (is_one ? within : between).add({a, b});
    if (!is_one) is_meeting[part_of[a]] = is_meeting[part_of[b]] = true;
  }
  std::string text;
  const auto describe = [&](const FirstFound<std::array<std::uint32_t, 2>>& pairs,
                            const std::string& fault, const std::string& whose, bool name_parts) {
    if (pairs.count() == 0) return;
    const auto place = [&](std::uint32_t t) {
      return mesh.place(mesh.triangles[t]) +
             (name_parts ? " (part " + std::to_string(part_of[t]) + ")" : "");
    };
    text += (text.empty() ? "" : "; ") + fault + ": " + (meeting.are_all ? "" : "at least ") +
            counted(pairs.count(), "pair") + " of triangles meet" + whose +
            (is_by_rounding ? " once points are rounded to 2^-52 of the extent" : "") + ", " +
            pairs.places([&](const std::array<std::uint32_t, 2>& pair) {
              return place(pair[0]) + " with " + place(pair[1]);
            });
  };
  const auto count = std::count(is_meeting.begin(), is_meeting.end(), true);
  describe(between, "closed parts touch or overlap",
           ", of " + std::to_string(count) + " of " + std::to_string(parts) + " parts", true);
  describe(within, "self-intersecting", "", false);
  mesh.fail_as_unsound(text);
}

void reject_self_intersections(const GridMesh& mesh, const std::vector<Corners>& neighbours,
                               const BoxTree& boxes) {
  const MeetingTriangles meeting = find_meeting_triangles(mesh.vertices, mesh.triangles, boxes);
  if (!meeting.pairs.empty()) fail_for_meeting(mesh, neighbours, meeting);
  if (meeting.are_all) return;
  mesh.fail("too entangled to be judged: the bounding boxes of more than " +
            std::to_string(kMostComparisons) + " pairs of its " +
            counted(mesh.triangles.size(), "triangle") + " overlap");
}

// Reverses the triangles of the shells that `starts` are in. Their edges 0 and 2 change places.
void turn_shells(std::vector<Corners>& triangles, std::vector<Corners>& neighbours,
                 std::vector<std::uint32_t> starts) {
  std::vector<bool> is_turned(triangles.size(), false);
  while (!starts.empty()) {
    const std::uint32_t t = starts.back();
    starts.pop_back();
    if (is_turned[t]) continue;
    is_turned[t] = true;
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(neighbours[t][0], neighbours[t][2]);
    starts.insert(starts.end(), neighbours[t].begin(), neighbours[t].end());
  }
}

ShellJudgement judge_nesting(GridMesh& mesh, std::vector<Corners>& neighbours, const BoxTree& boxes,
                             bool may_turn_shells, SolidReport& report) {
  ShellJudgement shells = judge_shells(mesh, neighbours, boxes);
  if (shells.wrong.empty() || shells.is_inside_out()) return shells;
  if (!may_turn_shells) {
    FirstFound<std::uint32_t> wrong;
    for (const std::uint32_t t : shells.wrong) wrong.add(t);
    mesh.fail_as_unsound("not consistently oriented: " + std::to_string(wrong.count()) + " of " +
              std::to_string(shells.shells) + " shells face the wrong way for how they nest, " +
              wrong.places([&](std::uint32_t t) { return mesh.place(mesh.triangles[t]); }));
  }
  report.turned_shells = shells.wrong.size();
  turn_shells(mesh.triangles, neighbours, shells.wrong);
  return judge_shells(mesh, neighbours, boxes);
}

// Reverses all triangles. Their edges 0 and 2 change places.
void turn(std::vector<Corners>& triangles, std::vector<Corners>& neighbours,
          ShellJudgement& shells) {
  for (Corners& t : triangles) std::swap(t[1], t[2]);
  for (Corners& n : neighbours) std::swap(n[0], n[2]);
  shells.wrong.clear();
  shells.volume = -shells.volume;
}

// In the file's units; what is not by rounding is not yet known in them.
FlatToleranceTaken choose_flat_tolerance(const PolygonSoup& soup, const ImportOptions& options) {
  FlatToleranceTaken taken;
  taken.fraction = options.flat_tolerance.value_or(kDefaultFlatTolerance);
  taken.was_given = options.flat_tolerance.has_value();
  if (soup.points.empty()) return taken;
  glm::dvec3 lower = soup.points.front();
  glm::dvec3 upper = lower;
  for (const glm::dvec3& p : soup.points) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  taken.spread = taken.fraction * glm::length(upper - lower);
  if (taken.was_given) return taken;
  // The first is the quicker question.
  const glm::dvec3 spacing = coordinate_spacing(soup.precision, soup.points);
  if (!(kRoundingSlack * glm::length(spacing) > taken.spread)) return taken;
  const glm::dvec3 rounding = find_rounding(soup.precision, soup.points);
  const double rounded_spread = kRoundingSlack * glm::length(rounding);
  if (!(rounded_spread > taken.spread)) return taken;
  taken.rounding = rounding;
  taken.rounded_spread = rounded_spread;
  taken.precision = soup.precision;
  return taken;
}

FlatTolerance in_universe_units(const FlatToleranceTaken& taken, const GridMesh& mesh) {
  FlatTolerance tolerance;
  tolerance.spread = taken.fraction * mesh.box_diagonal;
  for (int i = 0; i < 3; ++i) {
    tolerance.rounding[static_cast<std::size_t>(i)] = taken.rounding[i] / mesh.universe.scale();
  }
  return tolerance;
}

Solid make_solid(PlanarSurface surface, SolidReport report) {
  Solid solid;
  solid.report = std::move(report);
  solid.universe = surface.mesh.universe;
  const double scale = solid.universe.scale();
  solid.volume = surface.shells.volume * scale * scale * scale;
  solid.report.planes_before_merging = surface.planes_before_merging;
  solid.report.largest_move = surface.largest_move * scale;
  const std::vector<Corners> triangles = without_copies(surface.mesh, surface.mesh.triangles);
  solid.triangles.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners& t = triangles[i];
    const Corners& n = surface.neighbours[i];
    solid.triangles.push_back({{t[0], t[1], t[2]}, {n[0], n[1], n[2]}, 0});
  }
  solid.vertices = std::move(surface.mesh.vertices);
  solid.vertices.resize(solid.vertices.size() - surface.mesh.copy_of.size());
  group_into_facets(solid, surface.planes);
  return solid;
}

}  // namespace

Solid import_solid(PolygonSoup soup, std::string_view name, const ImportOptions& options) {
  assert(!options.flat_tolerance ||
         (*options.flat_tolerance >= 0 && *options.flat_tolerance < 0.1));
  const auto report_progress = [&options](double fraction) {
    if (options.progress) options.progress(fraction);
  };
  SolidReport report;
  GridSettlement settled = settle_on_grid(soup);
  report.merged_points = settled.merged_points;
  report.settled = std::move(settled.changes);
  report.flat_tolerance = choose_flat_tolerance(soup, options);
  // Corners of rounded faces may move farther than the universe cube has room by itself.
  GridMesh mesh = place_on_grid(soup.points, name, report.flat_tolerance.rounded_spread);
  triangulate(soup, mesh, report);
  std::vector<Corners> neighbours = find_neighbours(mesh, options.may_touch_itself);
  report_progress(0.25);

  const BoxTree boxes = box_tree_of(mesh.vertices, mesh.triangles);
  report_progress(0.4);
  reject_self_intersections(mesh, neighbours, boxes);
  report_progress(0.6);
  ShellJudgement shells = judge_nesting(mesh, neighbours, boxes, options.turn_shells, report);
  report.was_turned = shells.is_inside_out();
  if (report.was_turned) turn(mesh.triangles, neighbours, shells);

  report_progress(0.7);

  if (options.may_touch_itself) separate_fans(mesh, neighbours);
  const FlatTolerance tolerance = in_universe_units(report.flat_tolerance, mesh);
  return make_solid(merge_faces(std::move(mesh), std::move(neighbours), boxes, shells, tolerance),
                    std::move(report));
}

}  // namespace spoctree
