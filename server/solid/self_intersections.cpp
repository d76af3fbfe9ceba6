#include "server/solid/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;

// The corners of both triangles, each rotated so that what they share comes first.
struct Pair {
  std::array<Point, 3> a;
  std::array<Point, 3> b;
  int shared = 0;
};

bool is_on_one_side(const std::array<Point, 3>& plane, const Point& p, const Point& q) {
  const CGAL::Orientation at_p = CGAL::orientation(plane[0], plane[1], plane[2], p);
  return at_p != CGAL::COPLANAR && at_p == CGAL::orientation(plane[0], plane[1], plane[2], q);
}

// They share an edge. Unless they are folded flat onto each other, nothing else.
bool is_folded(const Pair& pair) {
  return CGAL::orientation(pair.a[0], pair.a[1], pair.a[2], pair.b[2]) == CGAL::COPLANAR &&
         CGAL::coplanar_orientation(pair.a[0], pair.a[1], pair.a[2], pair.b[2]) == CGAL::POSITIVE;
}

// They share a corner. What else they share would reach the far edge of one of them.
bool meet_beyond_corner(const Pair& pair) {
  const auto& [a, b, shared] = pair;
  if (is_on_one_side(a, b[1], b[2]) || is_on_one_side(b, a[1], a[2])) return false;
  return CGAL::do_intersect(Triangle(a[0], a[1], a[2]), Segment(b[1], b[2])) ||
         CGAL::do_intersect(Triangle(b[0], b[1], b[2]), Segment(a[1], a[2]));
}

bool meet_wrongly(const Pair& pair) {
  switch (pair.shared) {
    case 0:
      return CGAL::do_intersect(Triangle(pair.a[0], pair.a[1], pair.a[2]),
                                Triangle(pair.b[0], pair.b[1], pair.b[2]));
    case 1:
      return meet_beyond_corner(pair);
    case 2:
      return is_folded(pair);
    default:
      return true;  // back to back
  }
}

// The triangles with what they share in front; meet_wrongly tells about all kinds.
bool meet_wrongly(std::span<const Vec3> points, Corners a, Corners b) {
  const auto point = [&](std::uint32_t i) { return Point(points[i].x, points[i].y, points[i].z); };
  int shared = 0;
  for (int k = shared; k < 3; ++k) {
    const auto match = std::find(b.begin() + shared, b.end(), a[static_cast<std::size_t>(k)]);
    if (match == b.end()) continue;
    std::swap(a[static_cast<std::size_t>(k)], a[static_cast<std::size_t>(shared)]);
    std::iter_swap(match, b.begin() + shared);
    ++shared;
  }
  return meet_wrongly(
      {{point(a[0]), point(a[1]), point(a[2])}, {point(b[0]), point(b[1]), point(b[2])}, shared});
}

// A task of this many boxes is large enough for one thread.
constexpr std::uint32_t kBoxesPerTask = 2048;
constexpr std::size_t kTasksAtATime = 16;    // at first
constexpr std::size_t kTasksToUseAllUp = 4;  // comparisons: no task makes more than its share
constexpr std::size_t kQueriesPerTask = 1024;
static_assert(kAllPairsAreFoundBelow <= std::min(kQueriesPerTask, kMostSelfIntersections));

using TrianglePair = std::array<std::uint32_t, 2>;

// What compare(i, j, pairs) appends to `pairs` for all pairs of overlapping boxes, in an order that
// does not depend on the number of threads; it returns the number of its comparisons. Stops soon
// after kMostSelfIntersections, or after that many comparisons, and takes those made off the
// number.
template <class Compare>
std::vector<TrianglePair> compare_pairs(const BoxTree& boxes,
                                        std::span<const std::uint32_t> node_labels,
                                        std::size_t& comparisons, const Compare& compare) {
  const std::vector<NodePair> tasks = boxes.split_pairs(kBoxesPerTask);
  std::vector<TrianglePair> all;
  // Few tasks at a time where much is found, so that little is done in vain.
  std::size_t at_a_time = kTasksAtATime;
  for (std::size_t begin = 0;
       begin < tasks.size() && all.size() < kMostSelfIntersections && comparisons > 0;) {
    const std::size_t affordable =
        std::max(kTasksAtATime, comparisons / (std::size_t{kBoxesPerTask} * kBoxesPerTask));
    const std::size_t count = std::min({at_a_time, affordable, tasks.size() - begin});
    std::vector<std::vector<TrianglePair>> found(count);
    std::vector<std::size_t> compared(count, 0);
    const std::size_t most = comparisons / kTasksToUseAllUp;
    parallel_for(count, [&](std::size_t k) {
      boxes.visit_overlapping_pairs(
          tasks[begin + k], node_labels, [&](std::uint32_t i, std::uint32_t j) {
            if (found[k].size() >= kMostSelfIntersections || compared[k] > most) return;
            compared[k] += compare(i, j, found[k]);
          });
    });
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    begin += count;
    const std::size_t sum = std::accumulate(compared.begin(), compared.end(), std::size_t{0});
    const bool was_cut_short = std::any_of(compared.begin(), compared.end(),
                                           [&](std::size_t made) { return made > most; });
    comparisons -= was_cut_short ? comparisons : std::min(comparisons, sum);
    if (all.size() < 1000) at_a_time = std::min(2 * at_a_time, tasks.size());
  }
  return all;
}

// The pairs of overlapping boxes for which is_wrong(i, j).
template <class IsWrong>
std::vector<TrianglePair> find_pairs(const BoxTree& boxes, std::size_t& comparisons,
                                     const IsWrong& is_wrong) {
  return compare_pairs(boxes, {}, comparisons,
                       [&](std::uint32_t i, std::uint32_t j, std::vector<TrianglePair>& found) {
                         if (is_wrong(i, j)) found.push_back({std::min(i, j), std::max(i, j)});
                         return std::size_t{1};
                       });
}

// Vertices in very many triangles: the boxes of these all overlap each other there.
class Hubs {
 public:
  Hubs(std::span<const Vec3> points, std::span<const Corners> triangles)
      : points_(points), triangles_(triangles) {
    std::vector<std::uint32_t> degree(points.size(), 0);
    for (const Corners& t : triangles) {
      for (const std::uint32_t v : t) ++degree[v];
    }
    if (std::none_of(degree.begin(), degree.end(), is_large)) return;
    hub_of_.assign(triangles.size(), BoxTree::kMixed);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t v = *std::max_element(
          triangles[i].begin(), triangles[i].end(), [&](std::uint32_t p, std::uint32_t q) {
            return degree[p] != degree[q] ? degree[p] < degree[q] : p > q;
          });
      if (is_large(degree[v])) hub_of_[i] = v;
    }
  }

  // The hub of each triangle, or BoxTree::kMixed; empty if there are none.
  const std::vector<std::uint32_t>& hub_of() const { return hub_of_; }

  // Some triangles with the same hub, or any one.
  using Bundle = std::vector<std::uint32_t>;

  // All triangles in bundles that are thin for their length: as many boxes are enough for those of
  // a fan, in whose order they mostly come, however many there are.
  std::vector<Bundle> bundles() const {
    std::vector<Bundle> all;
    for (std::uint32_t i = 0; i < hub_of_.size(); ++i) {
      if (hub_of_[i] == BoxTree::kMixed) all.push_back({i});
    }
    for (const auto& [hub, fan] : fans()) {
      Box far;
      double most = 0;
      const std::size_t first = all.size();
      for (const std::uint32_t i : fan) {
        const Box next = far_edge(i);
        far = {glm::min(far.lower, next.lower), glm::max(far.upper, next.upper)};
        if (all.size() == first || all.back().size() == kMostInBundle ||
            glm::distance(far.lower, far.upper) > most) {
          all.emplace_back();
          far = next;
          const Vec3 middle = 0.5 * (far.lower + far.upper);
          most = kThinness / kSlices * glm::distance(points_[hub], middle);
        }
        all.back().push_back(i);
      }
    }
    return all;
  }

  // Boxes that contain the bundle's triangles together: slices between their hub and their far
  // edges, or the one's box.
  void append_slices(const Bundle& bundle, std::vector<Box>& boxes) const {
    const std::uint32_t hub = hub_of_[bundle.front()];
    if (hub == BoxTree::kMixed) {
      const Corners& t = triangles_[bundle.front()];
      boxes.push_back(box_around(points_[t[0]], points_[t[1]], points_[t[2]]));
      return;
    }
    Box far = far_edge(bundle.front());
    for (const std::uint32_t i : bundle) {
      const Box next = far_edge(i);
      far = {glm::min(far.lower, next.lower), glm::max(far.upper, next.upper)};
    }
    const Vec3 from = points_[hub];
    const Vec3 rounding =
        0x1p-50 * glm::max(glm::abs(from), glm::max(glm::abs(far.lower), glm::abs(far.upper)));
    const auto at = [&](Vec3 corner, int slice) {
      return from + (corner - from) * (static_cast<double>(slice) / kSlices);
    };
    for (int i = 0; i < kSlices; ++i) {
      boxes.push_back({glm::min(at(far.lower, i), at(far.lower, i + 1)) - rounding,
                       glm::max(at(far.upper, i), at(far.upper, i + 1)) + rounding});
    }
  }

  // Pairs of triangles of the same hub. What two triangles share with their hub's corner, they
  // share along a ray from there: what is to be compared is where they are seen from the hub.
  std::vector<TrianglePair> find_wrong_pairs(std::size_t& comparisons) const {
    std::vector<TrianglePair> all;
    for (const auto& [hub, fan] : fans()) {
      std::vector<Box> boxes;
      for (const std::uint32_t i : fan) boxes.push_back(seen_from(hub, triangles_[i]));
      const auto found =
          find_pairs(BoxTree(boxes), comparisons, [&, &of = fan](std::uint32_t i, std::uint32_t j) {
            return meet_wrongly(points_, triangles_[of[i]], triangles_[of[j]]);
          });
      for (const auto& [i, j] : found) all.push_back({fan[i], fan[j]});
    }
    return all;
  }

 private:
  static constexpr int kSlices = 32;
  static constexpr std::size_t kMostInBundle = 16;
  static constexpr double kThinness = 0.25;  // of a bundle beside the length of a slice
  static bool is_large(std::uint32_t degree) { return degree > 256; }

  // The box of a triangle's corners other than its hub.
  Box far_edge(std::uint32_t triangle) const {
    Corners t = triangles_[triangle];
    while (t[0] != hub_of_[triangle]) std::rotate(t.begin(), t.begin() + 1, t.end());
    return {glm::min(points_[t[1]], points_[t[2]]), glm::max(points_[t[1]], points_[t[2]])};
  }

  std::map<std::uint32_t, std::vector<std::uint32_t>> fans() const {
    std::map<std::uint32_t, std::vector<std::uint32_t>> fans;
    for (std::uint32_t i = 0; i < hub_of_.size(); ++i) {
      if (hub_of_[i] != BoxTree::kMixed) fans[hub_of_[i]].push_back(i);
    }
    return fans;
  }

  // The box of the arc that the triangle covers on the unit sphere around the hub.
  Box seen_from(std::uint32_t hub, const Corners& t) const {
    Vec3 ends[2];
    int count = 0;
    for (const std::uint32_t v : t) {
      if (v != hub) ends[count++] = glm::normalize(points_[v] - points_[hub]);
    }
    // The arc leaves its chord by less than this; the corners are rounded.
    const double half_chord = std::min(1.0, 0.5 * glm::distance(ends[0], ends[1]));
    const double margin = 1 - std::sqrt(1 - half_chord * half_chord) + 0x1p-40;
    return {glm::min(ends[0], ends[1]) - margin, glm::max(ends[0], ends[1]) + margin};
  }

  std::span<const Vec3> points_;
  std::span<const Corners> triangles_;
  std::vector<std::uint32_t> hub_of_;
};

// All pairs of triangles that meet wrongly. Stops as find_pairs does.
std::vector<TrianglePair> find_wrong_pairs(std::span<const Vec3> points,
                                           std::span<const Corners> triangles, const BoxTree& boxes,
                                           std::size_t& comparisons) {
  const Hubs hubs(points, triangles);
  const std::vector<std::uint32_t>& hub_of = hubs.hub_of();
  if (hub_of.empty()) {
    return find_pairs(boxes, comparisons, [&](std::uint32_t i, std::uint32_t j) {
      return meet_wrongly(points, triangles[i], triangles[j]);
    });
  }
  // Long needles have boxes that overlap those of many others; slices of them have not.
  const std::vector<Hubs::Bundle> bundles = hubs.bundles();
  std::vector<Box> slices;
  std::vector<std::uint32_t> bundle_of;
  std::vector<std::uint32_t> label_of;
  for (std::uint32_t k = 0; k < bundles.size(); ++k) {
    hubs.append_slices(bundles[k], slices);
    bundle_of.resize(slices.size(), k);
    label_of.resize(slices.size(), hub_of[bundles[k].front()]);
  }
  const BoxTree tree(slices);
  std::vector<TrianglePair> found =
      compare_pairs(tree, tree.common_labels(label_of), comparisons,
                    [&](std::uint32_t p, std::uint32_t q, std::vector<TrianglePair>& pairs) {
                      const Hubs::Bundle& a = bundles[bundle_of[p]];
                      const Hubs::Bundle& b = bundles[bundle_of[q]];
                      const std::uint32_t hub = hub_of[a.front()];
                      if (&a == &b || (hub != BoxTree::kMixed && hub == hub_of[b.front()])) {
                        return std::size_t{1};
                      }
                      for (const std::uint32_t i : a) {
                        for (const std::uint32_t j : b) {
                          if (!meet_wrongly(points, triangles[i], triangles[j])) continue;
                          pairs.push_back({std::min(i, j), std::max(i, j)});
                        }
                      }
                      return a.size() * b.size();
                    });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const std::vector<TrianglePair> of_hubs = hubs.find_wrong_pairs(comparisons);
  found.insert(found.end(), of_hubs.begin(), of_hubs.end());
  return found;
}

}  // namespace

SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Corners> triangles,
                                          const BoxTree& boxes) {
  SelfIntersections found;
  std::size_t comparisons = kMostComparisons + kMostComparisonsPerTriangle * triangles.size();
  for (const TrianglePair& pair : find_wrong_pairs(points, triangles, boxes, comparisons)) {
    if (found.pairs.count() == kMostSelfIntersections) break;
    found.pairs.add(pair);
  }
  found.are_all = comparisons > 0 && found.pairs.count() < kMostSelfIntersections;
  return found;
}

MeetingTriangles find_meeting_triangles(std::span<const Vec3> points,
                                        std::span<const Corners> triangles, const BoxTree& boxes) {
  std::size_t comparisons = kMostComparisons + kMostComparisonsPerTriangle * triangles.size();
  MeetingTriangles meeting{find_wrong_pairs(points, triangles, boxes, comparisons), true};
  meeting.are_all = comparisons > 0 && meeting.pairs.size() < kMostSelfIntersections;
  return meeting;
}

std::vector<TrianglePair> find_new_self_intersections(std::span<const Vec3> points,
                                                      std::span<const Corners> triangles,
                                                      const SomeBoxes& changed,
                                                      std::span<const JudgedBoxes> judged) {
  std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  if (!Hubs(points, triangles).hub_of().empty()) {
    // Boxes around a hub all overlap; the search among all triangles knows a way around that.
    return find_wrong_pairs(points, triangles, box_tree_of(points, triangles), unlimited);
  }
  const auto are_wrong = [&](std::uint32_t t, std::uint32_t u) {
    return meet_wrongly(points, triangles[t], triangles[u]);
  };
  std::vector<TrianglePair> found =
      find_pairs(changed.boxes, unlimited, [&](std::uint32_t i, std::uint32_t j) {
        return are_wrong(changed.triangles[i], changed.triangles[j]);
      });
  for (auto& [i, j] : found) {
    i = changed.triangles[i];
    j = changed.triangles[j];
  }
  std::vector<std::vector<TrianglePair>> parts((changed.triangles.size() + kQueriesPerTask - 1) /
                                               kQueriesPerTask);
  parallel_for(parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min(changed.triangles.size(), (part + 1) * kQueriesPerTask);
    for (std::size_t k = part * kQueriesPerTask; k < end; ++k) {
      const std::uint32_t t = changed.triangles[k];
      const auto& [a, b, c] = triangles[t];
      for (const JudgedBoxes& others : judged) {
        others.boxes->visit_overlapping(
            box_around(points[a], points[b], points[c]), [&](std::uint32_t box) {
              const std::uint32_t u = others.triangles.empty() ? box : others.triangles[box];
              if (others.is_outdated[u] == 0 && parts[part].size() < kQueriesPerTask &&
                  are_wrong(t, u)) {
                parts[part].push_back({t, u});
              }
            });
      }
    }
  });
  for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
  return found;
}

SomeBoxes boxes_of(std::span<const Vec3> points, std::span<const Corners> triangles,
                   std::vector<std::uint32_t> some) {
  std::vector<Corners> corners;
  corners.reserve(some.size());
  for (const std::uint32_t t : some) corners.push_back(triangles[t]);
  return {std::move(some), box_tree_of(points, corners)};
}

BoxTree box_tree_of(std::span<const Vec3> points, std::span<const Corners> triangles) {
  std::vector<Box> boxes(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t i) {
    const Corners& t = triangles[i];
    boxes[i] = box_around(points[t[0]], points[t[1]], points[t[2]]);
  });
  return BoxTree(boxes);
}

}  // namespace spoctree
