#include "server/solid/repair_needles.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A triangle without area: its points, the middle one second. Its longest edge joins the others.
struct Needle {
  std::uint32_t face;
  std::array<std::uint32_t, 3> points;
};

// The sides of an edge; empty if there is none.
std::span<const SoupSide> sides_of(std::span<const SoupSide> sides, std::uint32_t a,
                                   std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  const auto begin = std::lower_bound(sides.begin(), sides.end(), SoupSide{low, high, 0, 0});
  const auto end = std::upper_bound(begin, sides.end(), SoupSide{low, high, kNone, kNone});
  return {begin, end};
}

// One round: every needle is a branch of a tree that grows from the face beyond its longest edge.
class Round {
 public:
  Round(PolygonSoup& soup, const std::vector<Needle>& needles, FirstFound<FacePlace>& found)
      : soup_(soup), needles_(needles), found_(found), sides_(sides_by_edge(soup)) {
    needle_of_.assign(soup.face_count(), kNone);
    for (std::uint32_t i = 0; i < needles.size(); ++i) needle_of_[needles[i].face] = i;
    is_dropped_.assign(soup.face_count(), false);
  }

  // Whether anything was changed.
  bool run() {
    std::map<std::uint32_t, std::vector<Insertion>> by_face;
    for (const Needle& needle : needles_) {
      const auto edge = sides_of(sides_, needle.points[0], needle.points[2]);
      if (edge.size() > 2) continue;
      if (edge.size() == 1) {
        drop(collect(needle.points[0], needle).needles);
        continue;
      }
      const SoupSide& beyond = edge[0].face == needle.face ? edge[1] : edge[0];
      if (const std::uint32_t other = needle_of_[beyond.face]; other != kNone) {
        if (longest_edge(needles_[other]) == longest_edge(needle))
          pairs_.push_back({&needle - needles_.data(), other});
        continue;
      }
      by_face[beyond.face].push_back({beyond.corner, &needle});
    }
    for (const auto& [face, insertions] : by_face) hand_over(face, insertions);
    turn_pairs();
    if (!is_any_) return false;
    rebuild();
    return true;
  }

 private:
  struct Insertion {
    std::uint32_t corner;  // after which the points go
    const Needle* needle;
  };
  struct Branch {
    std::vector<std::uint32_t> points;  // in order
    std::vector<std::uint32_t> needles;
  };

  static std::pair<std::uint32_t, std::uint32_t> longest_edge(const Needle& needle) {
    return std::minmax(needle.points[0], needle.points[2]);
  }

  // All that lies between `from` and the other end of the needle's longest edge.
  Branch collect(std::uint32_t from, const Needle& root) const {
    Branch branch;
    struct Step {
      std::uint32_t from;
      const Needle* needle;  // null: `from` is a point to be added
    };
    std::vector<Step> steps{{from, &root}};
    while (!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      if (step.needle == nullptr) {
        branch.points.push_back(step.from);
        continue;
      }
      const Needle& needle = *step.needle;
      branch.needles.push_back(needle.face);
      const std::uint32_t middle = needle.points[1];
      const std::uint32_t to = needle.points[0] == step.from ? needle.points[2] : needle.points[0];
      if (const Needle* next = branch_at(needle, middle, to)) steps.push_back({middle, next});
      steps.push_back({middle, nullptr});
      if (const Needle* next = branch_at(needle, step.from, middle)) {
        steps.push_back({step.from, next});
      }
    }
    return branch;
  }

  const Needle* branch_at(const Needle& trunk, std::uint32_t a, std::uint32_t b) const {
    const auto edge = sides_of(sides_, a, b);
    if (edge.size() != 2) return nullptr;
    const std::uint32_t face = edge[0].face == trunk.face ? edge[1].face : edge[0].face;
    const std::uint32_t other = needle_of_[face];
    if (other == kNone || is_dropped_[face]) return nullptr;
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(a, b);
    return longest_edge(needles_[other]) == ends ? &needles_[other] : nullptr;
  }

  void hand_over(std::uint32_t face, const std::vector<Insertion>& insertions) {
    const auto corners = soup_.face(face);
    std::set<std::uint32_t> all(corners.begin(), corners.end());
    for (const Insertion& insertion : insertions) {
      Branch branch = collect(soup_.corners[insertion.corner], *insertion.needle);
      std::size_t added = 0;
      while (added < branch.points.size() && all.insert(branch.points[added]).second) ++added;
      if (added < branch.points.size()) {
        // The face would touch itself.
        while (added > 0) all.erase(branch.points[--added]);
        continue;
      }
      drop(branch.needles);
      added_after_[insertion.corner] = std::move(branch.points);
    }
  }

  void drop(const std::vector<std::uint32_t>& faces) {
    for (const std::uint32_t face : faces) {
      if (is_dropped_[face]) continue;
      is_dropped_[face] = true;
      found_.add(place_of_face(soup_, face));
      is_any_ = true;
    }
  }

  // Two needles that share their longest edge, a-m-b and a-n-b, become a-m-n and m-n-b: these have
  // their longest edges elsewhere.
  void turn_pairs() {
    for (const auto& [i, j] : pairs_) {
      const Needle& needle = needles_[static_cast<std::size_t>(i)];
      const Needle& other = needles_[j];
      const std::uint32_t m = needle.points[1];
      const std::uint32_t n = other.points[1];
      if (needle.face > other.face || is_dropped_[needle.face] || is_dropped_[other.face]) continue;
      if (m == n || !sides_of(sides_, m, n).empty()) continue;
      const std::uint32_t a = needle.points[0];
      const std::uint32_t b = needle.points[2];
      const auto replace = [&](std::uint32_t face, std::uint32_t from, std::uint32_t to) {
        std::replace(soup_.corners.begin() + soup_.first_corner[face],
                     soup_.corners.begin() + soup_.first_corner[face + 1], from, to);
      };
      replace(needle.face, b, n);
      replace(other.face, a, m);
      is_any_ = true;
    }
  }

  // The new soup: without the faces dropped, with corners put in.
  void rebuild() {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first_corner{0};
    for (std::size_t f = 0; f < soup_.face_count(); ++f) {
      if (is_dropped_[f]) continue;
      for (std::uint32_t c = soup_.first_corner[f]; c < soup_.first_corner[f + 1]; ++c) {
        corners.push_back(soup_.corners[c]);
        const auto added = added_after_.find(c);
        if (added == added_after_.end()) continue;
        corners.insert(corners.end(), added->second.begin(), added->second.end());
      }
      first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    soup_.corners = std::move(corners);
    soup_.first_corner = std::move(first_corner);
  }

  PolygonSoup& soup_;
  const std::vector<Needle>& needles_;
  FirstFound<FacePlace>& found_;
  std::vector<SoupSide> sides_;
  std::vector<std::uint32_t> needle_of_;  // by face
  std::vector<bool> is_dropped_;
  std::vector<std::pair<std::ptrdiff_t, std::uint32_t>> pairs_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> added_after_;  // by corner
  bool is_any_ = false;
};

}  // namespace

std::optional<std::array<std::uint32_t, 3>> exact_line(const PolygonSoup& soup,
                                                       std::span<const std::uint32_t> face) {
  const auto point = [&](std::uint32_t i) {
    return Kernel::Point_3(soup.points[i].x, soup.points[i].y, soup.points[i].z);
  };
  const Kernel::Point_3 p = point(face[0]);
  const Kernel::Point_3 q = point(face[1]);
  const Kernel::Point_3 r = point(face[2]);
  if (!CGAL::collinear(p, q, r)) return std::nullopt;
  if (CGAL::collinear_are_ordered_along_line(p, q, r)) return {{face[0], face[1], face[2]}};
  if (CGAL::collinear_are_ordered_along_line(q, r, p)) return {{face[1], face[2], face[0]}};
  return {{face[2], face[0], face[1]}};
}

FirstFound<FacePlace> drop_needles(PolygonSoup& soup, const LineOfTriangle& line_of) {
  FirstFound<FacePlace> found;
  for (int round = 0; round < kMostNeedleRounds; ++round) {
    std::vector<Needle> needles;
    for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
      if (soup.face(f).size() != 3) continue;
      if (const auto line = line_of(soup.face(f))) needles.push_back({f, *line});
    }
    if (needles.empty() || !Round(soup, needles, found).run()) break;
  }
  return found;
}

FirstFound<FacePlace> drop_needles(PolygonSoup& soup) {
  return drop_needles(soup,
                      [&](std::span<const std::uint32_t> face) { return exact_line(soup, face); });
}

}  // namespace spoctree
