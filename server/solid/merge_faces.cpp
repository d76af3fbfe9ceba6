#include "server/solid/merge_faces.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "common/base/parallel.hpp"
#include "server/solid/fit_jointly.hpp"
#include "server/solid/mend_folds.hpp"
#include "server/solid/merging_gain.hpp"
#include "server/solid/planar_patch.hpp"
#include "server/solid/self_intersections.hpp"
#include "server/solid/settle_corners.hpp"
#include "server/solid/touching.hpp"

namespace spoctree {

namespace {

// After so many rounds of pinning corners nothing is merged at all.
constexpr int kMostRounds = 24;
// From this round on, pins spread to the neighbours of what is wrong.
constexpr int kFirstSpreadingRound = 6;

// What becomes smaller than this (universe units) by moving, and was not nearly so before, is as
// good as collapsed: rebuilding could hardly tell it from nothing.
constexpr double kFinest = 0x1p-33;

double distance(const GridPoint& p, const GridPoint& q) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = static_cast<double>(q[i] - p[i]) * 0x1p-52;
    sum += d * d;
  }
  return std::sqrt(sum);
}

// The shortest edge, and the smallest height.
std::array<double, 2> finest_of(const Corners& t, std::span<const GridPoint> points) {
  const double edges[] = {distance(points[t[0]], points[t[1]]),
                          distance(points[t[1]], points[t[2]]),
                          distance(points[t[2]], points[t[0]])};
  const AreaVector area = area_vector(points[t[0]], points[t[1]], points[t[2]]);
  double squared = 0;
  for (const Int128 x : area) squared += static_cast<double>(x) * static_cast<double>(x);
  const auto [shortest, longest] = std::minmax({edges[0], edges[1], edges[2]});
  return {shortest, std::sqrt(squared) * 0x1p-104 / longest};
}

struct Grouping {
  FlatGroups in_planes;        // already
  FlatAndRoundedGroups found;  // within the tolerance
};

Grouping find_groups(const FlatSurface& surface, const FlatTolerance& tolerance) {
  Grouping groups;
  parallel_invoke([&] { groups.in_planes = find_groups_in_planes(surface); },
                  [&] { groups.found = find_flat_and_rounded_groups(surface, tolerance); });
  return groups;
}

class Merger {
 public:
  Merger(const GridMesh& mesh, const FlatSurface& surface, FlatGroups in_planes, FlatGroups flat,
         const BoxTree& boxes, const ShellJudgement& shells, const FlatTolerance& tolerance)
      : mesh_(mesh),
        surface_(surface),
        boxes_(boxes),
        shells_(shells),
        tolerance_(tolerance),
        gain_(surface, std::move(in_planes)),
        is_given_back_(surface.triangles.size(), 0),
        settler_(make_settler(surface, std::move(flat), tolerance.most_move())) {
    for (const std::uint32_t v : mesh.touching) settler_.pin(v);
  }

  /// Nothing if it does not work out.
  std::optional<PlanarSurface> merge();

 private:
  struct Attempt {
    SettledSurface surface;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> changed;  // triangles
    std::vector<std::uint32_t> wrong;    // triangles that must not stay as they are
    bool has_folds = false;              // some of them are upside down in their groups
  };

  static CornerSettler make_settler(const FlatSurface& surface, FlatGroups groups,
                                    double most_move);
  Attempt attempt();
  void settle();
  void find_wrong(Attempt& attempt);
  std::vector<std::array<std::uint32_t, 2>> find_intersections(const Attempt& attempt);
  bool has_collapsed(const Attempt& attempt, std::uint32_t triangle) const;
  void regroup_folds(Attempt& attempt);
  bool lies_near(std::uint32_t triangle, std::uint32_t group) const;
  void pin_corners(const Attempt& attempt, bool spread);
  std::optional<PlanarSurface> finish(Attempt attempt) const;

  const GridMesh& mesh_;
  const FlatSurface& surface_;
  const BoxTree& boxes_;
  const ShellJudgement& shells_;
  FlatTolerance tolerance_;
  MergingGain gain_;
  std::vector<std::uint8_t> is_given_back_;  // triangles
  CornerSettler settler_;
  std::set<std::uint32_t> regrouped_;  // triangles

  // The first attempt whose triangles were compared with each other.
  struct Judged {
    std::vector<Vec3> vertices;
    std::vector<Corners> triangles;
    SomeBoxes changed;
    std::vector<std::array<std::uint32_t, 2>> wrong;  // pairs of triangles that met
  };
  std::optional<Judged> judged_;
};

CornerSettler Merger::make_settler(const FlatSurface& surface, FlatGroups groups,
                                   double most_move) {
  JointFit fit = fit_jointly(surface, groups, most_move);
  return {surface, std::move(groups), std::move(fit), most_move};
}

// Where merging saves next to nothing, the surface stays as it was. No triangle is given back
// twice.
void Merger::settle() {
  for (;;) {
    settler_.settle();
    auto wasted = gain_.find_wasted(settler_.groups(), settler_.points());
    std::erase_if(wasted, [&](std::uint32_t t) { return is_given_back_[t] != 0; });
    if (wasted.empty()) return;
    for (const std::uint32_t t : wasted) is_given_back_[t] = 1;
    settler_.give_back(wasted, gain_.before());
  }
}

Merger::Attempt Merger::attempt() {
  settle();
  const FlatGroups& groups = settler_.groups();
  Attempt made;
  made.surface = {settler_.points(),
                  &groups,
                  {surface_.triangles.begin(), surface_.triangles.end()},
                  {surface_.neighbours.begin(), surface_.neighbours.end()}};
  made.vertices = mesh_.vertices;
  for (std::uint32_t v = 0; v < made.vertices.size(); ++v) {
    if (!settler_.is_moved(v)) continue;
    for (int i = 0; i < 3; ++i) {
      made.vertices[v][i] =
          static_cast<double>(settler_.points()[v][static_cast<std::size_t>(i)]) * 0x1p-52;
    }
  }
  std::vector<std::uint32_t> suspects;
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
    const Corners& c = surface_.triangles[t];
    const bool is_changed =
        settler_.is_moved(c[0]) || settler_.is_moved(c[1]) || settler_.is_moved(c[2]);
    if (is_changed) made.changed.push_back(t);
    const std::uint32_t group = groups.of_triangle[t];
    if (group == kNone) continue;
    if (is_changed || !groups.groups[group].is_exact) suspects.push_back(t);
  }
  const std::vector<std::uint32_t> turned = mend_folds(made.surface, suspects);
  made.has_folds = !suspects.empty();
  made.wrong = std::move(suspects);
  const auto middle = made.changed.insert(made.changed.end(), turned.begin(), turned.end());
  std::inplace_merge(made.changed.begin(), middle, made.changed.end());
  made.changed.erase(std::unique(made.changed.begin(), made.changed.end()), made.changed.end());
  return made;
}

void Merger::find_wrong(Attempt& attempt) {
  const auto is_outside = [&](std::uint32_t v) {
    const Vec3 p = attempt.vertices[v];
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) >= mesh_.universe.half_side;
  };
  for (const std::uint32_t t : attempt.changed) {
    const Corners& c = attempt.surface.triangles[t];
    if (std::any_of(c.begin(), c.end(), is_outside) || has_collapsed(attempt, t)) {
      attempt.wrong.push_back(t);
    }
  }
  std::sort(attempt.wrong.begin(), attempt.wrong.end());
  attempt.wrong.erase(std::unique(attempt.wrong.begin(), attempt.wrong.end()), attempt.wrong.end());
  if (!attempt.wrong.empty()) return;
  for (const auto& pair : find_intersections(attempt)) {
    attempt.wrong.insert(attempt.wrong.end(), pair.begin(), pair.end());
  }
}

// All changes are compared with everything once. Later attempts differ little from the first that
// got so far, and what they have in common with it need not be compared again.
std::vector<std::array<std::uint32_t, 2>> Merger::find_intersections(const Attempt& attempt) {
  // To those that look for meetings, what touches in a point shares it.
  const std::vector<Corners> triangles = without_copies(mesh_, attempt.surface.triangles);
  std::vector<std::uint8_t> is_outdated(surface_.triangles.size(), 0);
  for (const std::uint32_t t : attempt.changed) is_outdated[t] = 1;
  if (!judged_) {
    judged_ = {attempt.vertices,
               attempt.surface.triangles,
               boxes_of(attempt.vertices, triangles, attempt.changed),
               {}};
    const JudgedBoxes unmoved{&boxes_, {}, is_outdated};
    auto found =
        find_new_self_intersections(attempt.vertices, triangles, judged_->changed, {&unmoved, 1});
    // Of very many, some may not have been told.
    if (found.size() < kAllPairsAreFoundBelow) {
      judged_->wrong = found;
    } else {
      judged_.reset();
    }
    return found;
  }
  std::vector<std::uint32_t> changed;
  std::vector<std::uint8_t> is_changed_again(surface_.triangles.size(), 0);
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
    const Corners& corners = attempt.surface.triangles[t];
    const bool is_same = corners == judged_->triangles[t] &&
                         std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
                           return attempt.vertices[v] == judged_->vertices[v];
                         });
    if (is_same) continue;
    changed.push_back(t);
    is_changed_again[t] = 1;
    is_outdated[t] = 1;
  }
  for (const std::uint32_t t : judged_->changed.triangles) is_outdated[t] = 1;
  const JudgedBoxes judged[] = {
      {&boxes_, {}, is_outdated},
      {&judged_->changed.boxes, judged_->changed.triangles, is_changed_again}};
  auto found = find_new_self_intersections(
      attempt.vertices, triangles, boxes_of(attempt.vertices, triangles, std::move(changed)),
      judged);
  std::copy_if(judged_->wrong.begin(), judged_->wrong.end(), std::back_inserter(found),
               [&](const std::array<std::uint32_t, 2>& pair) {
                 return is_changed_again[pair[0]] == 0 && is_changed_again[pair[1]] == 0;
               });
  return found;
}

// Needles within a face are no harm, as long as they have an area.
bool Merger::has_collapsed(const Attempt& attempt, std::uint32_t triangle) const {
  const Corners& corners = attempt.surface.triangles[triangle];
  const auto [edge, height] = finest_of(corners, attempt.surface.points);
  if (height == 0) return true;
  const bool is_in_face = settler_.groups().of_triangle[triangle] != kNone;
  if (edge >= kFinest && (is_in_face || height >= kFinest)) return false;
  const auto [edge_before, height_before] = finest_of(corners, surface_.points);
  return edge < std::min(kFinest, 0.5 * edge_before) ||
         (!is_in_face && height < std::min(kFinest, 0.5 * height_before));
}

// Needles along a rim fit the faces on both sides of it. Those that end up upside down in the one
// are tried in the other; connected ones together, and each only once. The others stay wrong.
void Merger::regroup_folds(Attempt& attempt) {
  const FlatGroups& groups = settler_.groups();
  std::vector<std::uint32_t> still_wrong;
  std::set<std::uint32_t> waiting;
  for (const std::uint32_t t : attempt.wrong) {
    const bool is_new = groups.of_triangle[t] != kNone && regrouped_.insert(t).second;
    if (is_new) {
      waiting.insert(t);
    } else {
      still_wrong.push_back(t);
    }
  }
  while (!waiting.empty()) {
    std::vector<std::uint32_t> cluster = {*waiting.begin()};
    waiting.erase(waiting.begin());
    const std::uint32_t group = groups.of_triangle[cluster.front()];
    std::uint32_t best = kNone;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      for (const std::uint32_t n : surface_.neighbours[cluster[i]]) {
        const std::uint32_t other = groups.of_triangle[n];
        if (other == group && waiting.erase(n) > 0) cluster.push_back(n);
        if (other == group || other == kNone) continue;
        if (best == kNone || groups.groups[other].area > groups.groups[best].area) best = other;
      }
    }
    // Its group may have fallen apart when others left it.
    if (group != kNone && best != kNone &&
        std::all_of(cluster.begin(), cluster.end(),
                    [&](std::uint32_t t) { return lies_near(t, best); })) {
      settler_.regroup(cluster, best);
    } else {
      still_wrong.insert(still_wrong.end(), cluster.begin(), cluster.end());
    }
  }
  attempt.wrong = std::move(still_wrong);
}

bool Merger::lies_near(std::uint32_t triangle, std::uint32_t group) const {
  const GridPlane& plane = settler_.groups().groups[group].plane;
  const Int128 offset = static_cast<Int128>(plane.offset) << kGridBits;
  const Int128 most = to_height(tolerance_.rounded_spread(plane.normal));
  const Corners& corners = surface_.triangles[triangle];
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    const Int128 height = plane.height(surface_.points[v]) - offset;
    return -most <= height && height <= most;
  });
}

void Merger::pin_corners(const Attempt& attempt, bool spread) {
  const auto pin = [&](const Corners& corners) {
    for (const std::uint32_t v : corners) settler_.pin(v);
  };
  for (const std::uint32_t t : attempt.wrong) {
    pin(surface_.triangles[t]);
    pin(attempt.surface.triangles[t]);
    if (!spread) continue;
    for (const std::uint32_t n : surface_.neighbours[t]) pin(surface_.triangles[n]);
  }
}

std::optional<PlanarSurface> Merger::finish(Attempt attempt) const {
  const FlatGroups& groups = settler_.groups();
  PlanarSurface merged;
  merged.mesh = mesh_;
  merged.mesh.vertices = std::move(attempt.vertices);
  merged.mesh.triangles = std::move(attempt.surface.triangles);
  merged.neighbours = std::move(attempt.surface.neighbours);
  // Where corners moved far enough, a small shell may have changed places with a wall.
  merged.shells = judge_shells(
      merged.mesh, merged.neighbours,
      shells_.shells > 1 ? box_tree_of(merged.mesh.vertices, merged.mesh.triangles) : boxes_);
  if (!merged.shells.wrong.empty()) return std::nullopt;

  merged.planes = surface_.planes;
  for (const std::uint32_t t : attempt.changed) {
    merged.planes[t] = plane_of(merged.mesh.triangles[t], settler_.points());
  }
  for (std::uint32_t t = 0; t < merged.planes.size(); ++t) {
    const std::uint32_t group = groups.of_triangle[t];
    if (group != kNone) merged.planes[t] = groups.groups[group].plane;
  }
  if (number_planes(merged.planes).first.size() > surface_.distinct_planes) return std::nullopt;
  double squared_move = 0;
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    const Vec3 way = merged.mesh.vertices[v] - mesh_.vertices[v];
    squared_move = std::max(squared_move, way.x * way.x + way.y * way.y + way.z * way.z);
  }
  merged.largest_move = std::sqrt(squared_move);
  return merged;
}

std::optional<PlanarSurface> Merger::merge() {
  for (int round = 0; round < kMostRounds; ++round) {
    Attempt made = attempt();
    find_wrong(made);
    if (made.wrong.empty()) return finish(std::move(made));
    if (made.has_folds) regroup_folds(made);
    pin_corners(made, round >= kFirstSpreadingRound);
  }
  return std::nullopt;
}

std::size_t plane_count(const PlanarSurface& surface) {
  return number_planes(surface.planes).first.size();
}

// What rounding explains need not work out together. Then it may be less than what the tolerance
// merges without it.
std::optional<PlanarSurface> merge_groups(const GridMesh& mesh, const FlatSurface& surface,
                                          Grouping groups, const BoxTree& boxes,
                                          const ShellJudgement& shells,
                                          const FlatTolerance& tolerance) {
  std::optional<PlanarSurface> rounded;
  if (groups.found.rounded) {
    const std::size_t fewest_without = count_planes(groups.found.flat);
    rounded = Merger(mesh, surface, groups.in_planes, std::move(*groups.found.rounded), boxes, shells,
                     tolerance)
                  .merge();
    if (rounded && plane_count(*rounded) <= fewest_without) return rounded;
  }
  auto merged = Merger(mesh, surface, std::move(groups.in_planes), std::move(groups.found.flat), boxes,
                       shells, {tolerance.spread, {}})
                    .merge();
  if (rounded && (!merged || plane_count(*rounded) < plane_count(*merged))) return rounded;
  return merged;
}

}  // namespace

PlanarSurface merge_faces(GridMesh mesh, std::vector<Corners> neighbours, const BoxTree& boxes,
                          const ShellJudgement& shells, const FlatTolerance& tolerance) {
  FlatSurface surface = make_flat_surface(mesh.vertices, mesh.triangles, neighbours);
  if (tolerance.spread > 0) {
    auto merged =
        merge_groups(mesh, surface, find_groups(surface, tolerance), boxes, shells, tolerance);
    if (merged) {
      merged->planes_before_merging = surface.distinct_planes;
      return std::move(*merged);
    }
  }
  PlanarSurface as_it_is;
  as_it_is.planes = std::move(surface.planes);
  as_it_is.planes_before_merging = surface.distinct_planes;
  as_it_is.mesh = std::move(mesh);
  as_it_is.neighbours = std::move(neighbours);
  as_it_is.shells = shells;
  return as_it_is;
}

}  // namespace spoctree
