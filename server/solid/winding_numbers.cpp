#include "server/solid/winding_numbers.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "server/solid/face_groups.hpp"

namespace spoctree {

namespace {

// A side of a piece along an edge: it runs from the smaller to the larger point, or back.
struct EdgeSide {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t piece;
  std::uint32_t apex;
  bool runs_up;
};

std::vector<EdgeSide> file_sides(std::span<const Piece> pieces) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * pieces.size());
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    const Corners& c = pieces[p].corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = c[i];
      const std::uint32_t to = c[(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), p, c[(i + 2) % 3], from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.piece < b.piece;
  });
  return sides;
}

// In the order in which they stand around the edge, counter-clockwise as it comes at the viewer.
void sort_around_edge(const ExactPoints& points, std::span<EdgeSide> sides) {
  const ExactPoint from = points[sides[0].low];
  const ExactPoint to = points[sides[0].high];
  struct Spoke {
    EdgeSide side;
    ExactPoint apex;
    int sector;  // 0: the first, 1: on its left, 2: opposite, 3: on its right
  };
  std::vector<Spoke> spokes;
  for (const EdgeSide& side : sides) {
    Spoke spoke{side, points[side.apex], 0};
    if (!spokes.empty()) {
      const auto turn = CGAL::orientation(from, to, spokes[0].apex, spoke.apex);
      spoke.sector = turn == CGAL::POSITIVE ? 1 : turn == CGAL::NEGATIVE ? 3 : 2;
    }
    spokes.push_back(std::move(spoke));
  }
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
    if (a.sector != b.sector) return a.sector < b.sector;
    if (a.sector % 2 == 0) return false;
    return CGAL::orientation(from, to, a.apex, b.apex) == CGAL::POSITIVE;
  });
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = spokes[i].side;
}

// The triangles above a point, as in UpwardRay: shifted by less than any number to the right, and
// by far less than that upwards as seen from above.
class ExactRay {
 public:
  explicit ExactRay(ExactPoint start) : start_(std::move(start)) {}

  // How much larger the winding number is before the ray crosses the triangle than behind it.
  int step(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) const {
    if (!(is_left_of_edge(a, b) ^ is_left_of_edge(b, c) ^ is_left_of_edge(c, a))) return 0;
    const auto side = CGAL::orientation(a, b, c, start_);
    const auto turn = CGAL::orientation(above(a), above(b), above(c));
    if (side == CGAL::COPLANAR || (side == CGAL::POSITIVE) == (turn == CGAL::LEFT_TURN)) return 0;
    return turn == CGAL::LEFT_TURN ? 1 : -1;
  }

 private:
  static ExactKernel::Point_2 above(const ExactPoint& p) { return {p.x(), p.y()}; }
  bool is_left_of_edge(const ExactPoint& a, const ExactPoint& b) const {
    if ((a.y() > start_.y()) == (b.y() > start_.y())) return false;
    const bool is_up = a.y() < b.y();
    return CGAL::orientation(above(is_up ? a : b), above(is_up ? b : a), above(start_)) ==
           CGAL::LEFT_TURN;
  }

  ExactPoint start_;
};

// Sides of pieces are numbered 2 p (front) and 2 p + 1 (back); those that bound one cell are
// joined.
class Cells {
 public:
  Cells(const Arrangement& arrangement, std::span<const Vec3> given,
        std::span<const Corners> triangles, const BoxTree& boxes)
      : points_(arrangement.points),
        pieces_(arrangement.pieces),
        given_(given),
        triangles_(triangles),
        boxes_(boxes),
        cells_(2 * arrangement.pieces.size()) {}

  // False: there is a border.
  bool join_around_edges() {
    std::vector<EdgeSide> sides = file_sides(pieces_);
    for (std::size_t begin = 0; begin < sides.size();) {
      std::size_t end = begin;
      std::int64_t sum = 0;
      for (; end < sides.size() && sides[end].low == sides[begin].low &&
             sides[end].high == sides[begin].high;
           ++end) {
        sum +=
            sides[end].runs_up ? pieces_[sides[end].piece].times : -pieces_[sides[end].piece].times;
      }
      if (sum != 0) return false;
      const std::span<EdgeSide> around(sides.data() + begin, end - begin);
      if (around.size() > 2) sort_around_edge(points_, around);
      for (std::size_t i = 0; i < around.size(); ++i) {
        const EdgeSide& next = around[i + 1 < around.size() ? i + 1 : 0];
        // A piece that runs up has its front ahead of it.
        cells_.join(2 * around[i].piece + (around[i].runs_up ? 0 : 1),
                    2 * next.piece + (next.runs_up ? 1 : 0));
      }
      begin = end;
    }
    return true;
  }

  std::vector<Winding> wind() {
    std::vector<std::uint32_t> begin(2 * pieces_.size() + 1, 0);
    for (std::uint32_t s = 0; s < 2 * pieces_.size(); ++s) ++begin[cells_.group_of(s) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<std::uint32_t> sides_of(2 * pieces_.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t s = 0; s < 2 * pieces_.size(); ++s) {
      sides_of[next[cells_.group_of(s)]++] = s;
    }
    std::vector<std::int32_t> number(2 * pieces_.size(), 0);  // of cells
    std::vector<std::uint8_t> is_known(2 * pieces_.size(), 0);
    std::vector<std::uint32_t> reached;
    for (std::uint32_t first = 0; first < pieces_.size(); ++first) {
      if (is_known[cells_.group_of(2 * first)] != 0) continue;
      // Numbers relative to the first cell, then as the ray says.
      reached.assign(1, cells_.group_of(2 * first));
      is_known[reached[0]] = 1;
      for (std::size_t i = 0; i < reached.size(); ++i) {
        const std::uint32_t cell = reached[i];
        for (std::uint32_t k = begin[cell]; k < begin[cell + 1]; ++k) {
          const std::uint32_t side = sides_of[k];
          const std::uint32_t beyond = cells_.group_of(side ^ 1u);
          const std::int32_t times = pieces_[side / 2].times;
          const std::int32_t there = number[cell] + (side % 2 == 0 ? times : -times);
          if (is_known[beyond] == 0) {
            is_known[beyond] = 1;
            number[beyond] = there;
            reached.push_back(beyond);
          } else if (number[beyond] != there) {
            throw std::logic_error("the winding numbers of an arrangement contradict each other");
          }
        }
      }
      const std::int32_t shift = shift_of(reached, begin, sides_of, number);
      for (const std::uint32_t cell : reached) number[cell] += shift;
    }
    std::vector<Winding> winding(pieces_.size());
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      winding[p] = {number[cells_.group_of(2 * p)], number[cells_.group_of(2 * p + 1)]};
    }
    return winding;
  }

 private:
  // What is to be added to the numbers of these cells, seen from a piece that is not upright. Where
  // all are, the surface encloses nothing.
  std::int32_t shift_of(const std::vector<std::uint32_t>& cells,
                        const std::vector<std::uint32_t>& begin,
                        const std::vector<std::uint32_t>& sides_of,
                        const std::vector<std::int32_t>& number) {
    for (const std::uint32_t cell : cells) {
      for (std::uint32_t k = begin[cell]; k < begin[cell + 1]; ++k) {
        const std::uint32_t piece = sides_of[k] / 2;
        const Corners& c = pieces_[piece].corners;
        const ExactPoint corners[] = {points_[c[0]], points_[c[1]], points_[c[2]]};
        const auto turn = CGAL::orientation(ExactKernel::Point_2(corners[0].x(), corners[0].y()),
                                            ExactKernel::Point_2(corners[1].x(), corners[1].y()),
                                            ExactKernel::Point_2(corners[2].x(), corners[2].y()));
        if (turn == CGAL::COLLINEAR) continue;
        const std::uint32_t upper = 2 * piece + (turn == CGAL::LEFT_TURN ? 0 : 1);
        return number_above(CGAL::centroid(corners[0], corners[1], corners[2])) -
               number[cells_.group_of(upper)];
      }
    }
    return 0;
  }

  std::int32_t number_above(const ExactPoint& start) const {
    const ExactRay ray(start);
    constexpr double kMargin = 0x1p-40;  // far more than what to_double may be off
    const Vec3 p{CGAL::to_double(start.x()), CGAL::to_double(start.y()),
                 CGAL::to_double(start.z())};
    std::int32_t number = 0;
    boxes_.visit_overlapping({p - kMargin, {p.x + kMargin, p.y + kMargin, 4.0}},
                             [&](std::uint32_t t) {
                               const auto& [a, b, c] = triangles_[t];
                               number += ray.step(points_[a], points_[b], points_[c]);
                             });
    return number;
  }

  const ExactPoints& points_;
  std::span<const Piece> pieces_;
  std::span<const Vec3> given_;
  std::span<const Corners> triangles_;
  const BoxTree& boxes_;
  FaceGroups cells_;
};

}  // namespace

std::optional<std::vector<Winding>> find_winding_numbers(const Arrangement& arrangement,
                                                         std::span<const Vec3> points,
                                                         std::span<const Corners> triangles,
                                                         const BoxTree& boxes) {
  Cells cells(arrangement, points, triangles, boxes);
  if (!cells.join_around_edges()) return std::nullopt;
  return cells.wind();
}

}  // namespace spoctree
