#include "server/solid/meeting_lines.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <map>

namespace spoctree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

using Edge = std::array<std::uint32_t, 2>;

// What a constructed point is named by: an edge, and the other edge or triangle that it meets.
struct Name {
  Edge edge;
  Edge other{0, 0};            // a second edge, the larger one of the two
  std::uint32_t triangle = 0;  // 0: a second edge; else a triangle's number + 1
  auto operator<=>(const Name&) const = default;
};

Edge edge_of(const Corners& t, std::size_t i) {
  const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
  return {low, high};
}

bool has(const Corners& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

class Finder {
 public:
  Finder(ExactPoints& points, std::span<const Vec3> given, std::span<const Corners> triangles)
      : points_(points), given_(given), triangles_(triangles) {}

  void meet(std::uint32_t a, std::uint32_t b) {
    const std::array<int, 3> of_a = sides(a, b);
    if (of_a == std::array{0, 0, 0}) {
      found_.in_plane.push_back({a, b});
      return;
    }
    hits_.clear();
    cross(a, b, of_a);
    cross(b, a, sides(b, a));
    std::sort(hits_.begin(), hits_.end());
    hits_.erase(std::unique(hits_.begin(), hits_.end()), hits_.end());
    if (hits_.empty()) return;
    const Edge ends = {hits_.front(), hits_.back()};
    found_.lines.push_back({a, ends});
    found_.lines.push_back({b, ends});
  }

  MeetingLines finish() {
    std::sort(found_.lines.begin(), found_.lines.end(),
              [](const MeetingLine& p, const MeetingLine& q) {
                return p.triangle != q.triangle ? p.triangle < q.triangle : p.ends < q.ends;
              });
    return std::move(found_);
  }

 private:
  Point at(std::uint32_t v) const { return {given_[v].x, given_[v].y, given_[v].z}; }

  // On which sides of the plane of b the corners of a lie.
  std::array<int, 3> sides(std::uint32_t a, std::uint32_t b) const {
    const Corners& plane = triangles_[b];
    std::array<int, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangles_[a][i];
      if (has(plane, v)) continue;
      sides[i] = CGAL::orientation(at(plane[0]), at(plane[1]), at(plane[2]), at(v));
    }
    return sides;
  }

  // The points of edges of a, not in the plane of b, that are in b.
  void cross(std::uint32_t a, std::uint32_t b, const std::array<int, 3>& side_of) {
    const Corners& t = triangles_[a];
    const Corners& u = triangles_[b];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (side_of[i] * side_of[next] > 0 || (side_of[i] == 0 && side_of[next] == 0)) continue;
      // The line passes every edge of b on the same side, or through it.
      std::array<int, 3> turns{};
      bool is_left = false;
      bool is_right = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge e = {u[k], u[(k + 1) % 3]};
        if (e[0] == t[i] || e[1] == t[i] || e[0] == t[next] || e[1] == t[next]) continue;
        turns[k] = CGAL::orientation(at(t[i]), at(t[next]), at(e[0]), at(e[1]));
        is_left = is_left || turns[k] > 0;
        is_right = is_right || turns[k] < 0;
      }
      if (is_left && is_right) continue;
      if (side_of[i] == 0) {
        hits_.push_back(t[i]);
      } else if (side_of[next] == 0) {
        hits_.push_back(t[next]);
      } else {
        hits_.push_back(point_on(edge_of(t, i), b, turns));
      }
    }
  }

  std::uint32_t point_on(const Edge& edge, std::uint32_t b, const std::array<int, 3>& turns) {
    const Corners& u = triangles_[b];
    const auto zeros = std::count(turns.begin(), turns.end(), 0);
    if (zeros >= 2) {  // at the corner between two edges
      for (std::size_t k = 0; k < 3; ++k) {
        if (turns[k] == 0 && turns[(k + 2) % 3] == 0) return u[k];
      }
    }
    Name name{edge, {0, 0}, b + 1};
    if (zeros == 1) {
      const auto k =
          static_cast<std::size_t>(std::find(turns.begin(), turns.end(), 0) - turns.begin());
      name = {edge, edge_of(u, k), 0};
      if (name.other < name.edge) std::swap(name.edge, name.other);
    }
    const auto [place, is_new] = number_of_.try_emplace(name, 0);
    if (is_new) place->second = points_.add(construct(edge, u));
    return place->second;
  }

  ExactPoint construct(const Edge& edge, const Corners& u) const {
    const ExactPoint p = points_[edge[0]];
    const ExactPoint q = points_[edge[1]];
    const ExactPoint origin = points_[u[0]];
    const auto normal = CGAL::cross_product(points_[u[1]] - origin, points_[u[2]] - origin);
    const ExactKernel::FT at_p = normal * (p - origin);
    const ExactKernel::FT at_q = normal * (q - origin);
    return p + (at_p / (at_p - at_q)) * (q - p);
  }

  ExactPoints& points_;
  std::span<const Vec3> given_;
  std::span<const Corners> triangles_;
  std::map<Name, std::uint32_t> number_of_;
  std::vector<std::uint32_t> hits_;
  MeetingLines found_;
};

}  // namespace

MeetingLines find_meeting_lines(ExactPoints& points, std::span<const Vec3> given,
                                std::span<const Corners> triangles,
                                std::span<const std::array<std::uint32_t, 2>> pairs) {
  Finder finder(points, given, triangles);
  for (const auto& [a, b] : pairs) finder.meet(a, b);
  return finder.finish();
}

}  // namespace spoctree
