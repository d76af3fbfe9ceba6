#include "server/solid/split_in_plane.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <limits>

#include "server/solid/box_tree.hpp"

namespace spoctree {

namespace {

constexpr std::uint32_t kUnnamed = std::numeric_limits<std::uint32_t>::max();

struct VertexName {
  std::uint32_t number = kUnnamed;
};

using Point2 = ExactKernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexName, ExactKernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<ExactKernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<ExactKernel, Structure,
                                                            CGAL::Exact_intersections_tag>;

/// A plane seen along the axis nearest to its normal.
class PlaneView {
 public:
  PlaneView(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c)
      : origin_(a), normal_(CGAL::cross_product(b - a, c - a)) {
    double largest = -1;
    for (int i = 0; i < 3; ++i) {
      const double size = std::abs(CGAL::to_double(normal_[i]));
      if (size <= largest || CGAL::is_zero(normal_[i])) continue;
      largest = size;
      axis_ = i;
    }
  }

  int axis() const { return axis_; }
  Point2 seen(const ExactPoint& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }

  ExactPoint on_plane(const Point2& p) const {
    const int u = (axis_ + 1) % 3;
    const int v = (axis_ + 2) % 3;
    ExactKernel::FT coordinates[3];
    coordinates[u] = p.x();
    coordinates[v] = p.y();
    coordinates[axis_] =
        origin_[axis_] -
        (normal_[u] * (p.x() - origin_[u]) + normal_[v] * (p.y() - origin_[v])) / normal_[axis_];
    return {coordinates[0], coordinates[1], coordinates[2]};
  }

 private:
  ExactPoint origin_;
  ExactKernel::Vector_3 normal_;
  int axis_ = 0;
};

/// Which triangles of a plane a point of it lies in.
class Members {
 public:
  Members(const PlaneView& view, const ExactPoints& points, std::span<const Vec3> given,
          std::span<const Corners> triangles, std::span<const std::uint32_t> members)
      : boxes_(boxes_of(view.axis(), given, triangles, members)) {
    for (const std::uint32_t m : members) {
      Member member{m,
                    {view.seen(points[triangles[m][0]]), view.seen(points[triangles[m][1]]),
                     view.seen(points[triangles[m][2]])},
                    true};
      member.is_left = CGAL::orientation(member.corners[0], member.corners[1], member.corners[2]) ==
                       CGAL::LEFT_TURN;
      if (!member.is_left) std::swap(member.corners[1], member.corners[2]);
      members_.push_back(std::move(member));
    }
  }

  /// `times` is 0 and `triangle` unchanged if there are none; the smallest one of several.
  /// REQUIRES: the point is on no edge of a member.
  bool find(const Point2& p, Piece& piece) const {
    const double x = CGAL::to_double(p.x());
    const double y = CGAL::to_double(p.y());
    constexpr double kMargin = 0x1p-40;  // far more than what to_double may be off
    const Box near{{x - kMargin, y - kMargin, 0}, {x + kMargin, y + kMargin, 0}};
    bool is_any = false;
    piece.times = 0;
    boxes_.visit_overlapping(near, [&](std::uint32_t i) {
      const Member& member = members_[i];
      for (std::size_t k = 0; k < 3; ++k) {
        if (CGAL::orientation(member.corners[k], member.corners[(k + 1) % 3], p) !=
            CGAL::LEFT_TURN) {
          return;
        }
      }
      if (!is_any || member.triangle < piece.triangle) piece.triangle = member.triangle;
      is_any = true;
      piece.times += member.is_left ? 1 : -1;
    });
    return is_any;
  }

 private:
  struct Member {
    std::uint32_t triangle;
    std::array<Point2, 3> corners;  // to the left
    bool is_left;                   // it is seen from the side that it faces
  };

  static BoxTree boxes_of(int axis, std::span<const Vec3> given, std::span<const Corners> triangles,
                          std::span<const std::uint32_t> members) {
    const auto flat = [&](std::uint32_t v) {
      return Vec3{given[v][(axis + 1) % 3], given[v][(axis + 2) % 3], 0};
    };
    std::vector<Box> boxes;
    for (const std::uint32_t m : members) {
      const auto& [a, b, c] = triangles[m];
      boxes.push_back(box_around(flat(a), flat(b), flat(c)));
    }
    return BoxTree(boxes);
  }

  BoxTree boxes_;
  std::vector<Member> members_;
};

}  // namespace

void split_in_plane(ExactPoints& points, std::span<const Vec3> given,
                    std::span<const Corners> triangles, std::span<const std::uint32_t> members,
                    std::span<const MeetingLine> lines, std::vector<Piece>& pieces,
                    std::vector<std::array<std::uint32_t, 2>>& same) {
  const Corners& first = triangles[members.front()];
  const PlaneView view(points[first[0]], points[first[1]], points[first[2]]);
  Delaunay delaunay;
  const auto vertex_at = [&](std::uint32_t number) {
    const auto vertex = delaunay.insert(view.seen(points[number]));
    std::uint32_t& name = vertex->info().number;
    if (name == kUnnamed) name = number;
    if (name != number) same.push_back({name, number});
    return vertex;
  };
  const auto insert = [&](std::uint32_t p, std::uint32_t q) {
    const auto from = vertex_at(p);
    const auto to = vertex_at(q);
    if (from != to) delaunay.insert_constraint(from, to);
    if (points.size() - points.given() + delaunay.number_of_vertices() > kMostConstructedPoints) {
      throw TooEntangled("they would have more than " + std::to_string(kMostConstructedPoints) +
                         " points in common");
    }
  };
  for (const std::uint32_t m : members) {
    const Corners& t = triangles[m];
    for (std::size_t i = 0; i < 3; ++i) insert(t[i], t[(i + 1) % 3]);
  }
  for (const MeetingLine& line : lines) insert(line.ends[0], line.ends[1]);

  const bool faces_along_axis =
      CGAL::orientation(view.seen(points[first[0]]), view.seen(points[first[1]]),
                        view.seen(points[first[2]])) == CGAL::LEFT_TURN;
  std::vector<Members> several;
  if (members.size() > 1) several.emplace_back(view, points, given, triangles, members);
  for (const auto face : delaunay.finite_face_handles()) {
    Piece piece{{}, members.front(), faces_along_axis ? 1 : -1};
    if (!several.empty()) {
      const Point2 middle = CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(),
                                           face->vertex(2)->point());
      if (!several.front().find(middle, piece)) continue;
    }
    for (int i = 0; i < 3; ++i) {
      std::uint32_t& number = face->vertex(i)->info().number;
      if (number == kUnnamed) number = points.add(view.on_plane(face->vertex(i)->point()));
      piece.corners[static_cast<std::size_t>(i)] = number;
    }
    pieces.push_back(piece);
  }
}

}  // namespace spoctree
