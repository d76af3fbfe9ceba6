#include "tests/support/seen_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "tests/support/cgal_mesh.hpp"
#include "tests/support/exact_determinant.hpp"
#include "tests/support/near_parts.hpp"
#include "tests/support/picture_grid.hpp"

namespace spoctree {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Points closer together than this are one point in the picture (fraction of the diagonal).
constexpr double kPointInPicture = 1e-12;
/// A face narrower than this has no direction worth the name.
constexpr double kSliver = 1e-8;

PlainMesh with_points_once(const PlainMesh& mesh) {
  PlainMesh once;
  std::map<std::tuple<double, double, double>, std::uint32_t> places;
  std::vector<std::uint32_t> place_of;
  for (const Vec3 p : mesh.points) {
    const auto [place, is_new] =
        places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(once.points.size()));
    if (is_new) once.points.push_back(p);
    place_of.push_back(place->second);
  }
  for (const auto& face : mesh.faces) {
    auto& corners = once.faces.emplace_back();
    for (const std::uint32_t corner : face) corners.push_back(place_of[corner]);
  }
  return once;
}

/// How bent the surface is at the edges, each face against each neighbour.
class Bends {
 public:
  explicit Bends(const PlainMesh& mesh) : mesh_(mesh), diagonal_(diagonal_of(mesh)) {
    for (std::uint32_t k = 0; k < mesh.faces.size(); ++k) {
      const auto& face = mesh.faces[k];
      const Vec3 origin = mesh.points[face[0]];
      Vec3 area{0.0};
      double longest = 0;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t a = face[i];
        const std::uint32_t b = face[(i + 1) % face.size()];
        area += glm::cross(mesh.points[a] - origin, mesh.points[b] - origin);
        longest = std::max(longest, glm::distance(mesh.points[a], mesh.points[b]));
        faces_at_[std::minmax(a, b)].push_back(k);
      }
      const double length = glm::length(area);
      normals_.push_back(length > 0 ? area / length : Vec3{0.0});
      is_sliver_.push_back(length < kSliver * diagonal_ * longest);
    }
  }

  const auto& faces_at() const { return faces_at_; }
  bool is_beside_sliver(const std::vector<std::uint32_t>& faces) const {
    return std::any_of(faces.begin(), faces.end(), [&](auto k) { return is_sliver_[k]; });
  }

  Vec3 normal(std::uint32_t face) const { return normals_[face]; }
  double between(std::uint32_t one, std::uint32_t other) const {
    return std::min(farthest_off(one, other), farthest_off(other, one)) / diagonal_;
  }

 private:
  double farthest_off(std::uint32_t plane, std::uint32_t face) const {
    const Vec3 origin = mesh_.points[mesh_.faces[plane][0]];
    double most = 0;
    for (const std::uint32_t corner : mesh_.faces[face]) {
      const double off = std::abs(glm::dot(normals_[plane], mesh_.points[corner] - origin));
      most = std::max(most, off);
    }
    return most;
  }

  const PlainMesh& mesh_;
  double diagonal_;
  std::vector<Vec3> normals_;
  std::vector<bool> is_sliver_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> faces_at_;
};

class Scene {
 public:
  Scene(const PlainMesh& mesh, const JudgeView& view)
      : points_(mesh.points),
        view_(view),
        triangles_(triangles_of(mesh)),
        grid_(outlines(), 0, view.half_width()) {}

  /// Pushes the parts of the edge that something hides.
  Parts hidden_parts(std::uint32_t a, std::uint32_t b, const PictureOutline& outline) {
    Parts hidden[2];
    for (const std::uint32_t k : grid_.near(outline)) {
      if (facing_[k] != 0) hide_behind(a, b, k, hidden);
    }
    return common_of(united(std::move(hidden[0])), united(std::move(hidden[1])));
  }

 private:
  static std::vector<Triangle> triangles_of(const PlainMesh& mesh) {
    std::vector<Triangle> triangles;
    for (const auto& face : mesh.faces) {
      const auto found = triangulate_with_cgal(mesh.points, face);
      triangles.insert(triangles.end(), found.begin(), found.end());
    }
    return triangles;
  }

  /// From a point to the viewer.
  ExactDifference sight(Vec3 from) const {
    return {view_.viewer(), view_.is_perspective() ? from : Vec3{0.0}};
  }
  /// Positive where, in the picture, x is to the left of the way from u to v.
  ExactDeterminant side(Vec3 u, Vec3 v, Vec3 x) const { return {{v, u}, {x, u}, sight(u)}; }

  /// Triangles seen edge-on and those behind the eye have outlines without corners.
  std::vector<PictureOutline> outlines() {
    std::vector<PictureOutline> result;
    for (const Triangle& triangle : triangles_) {
      const Vec3 p[3] = {points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]};
      facing_.push_back(side(p[0], p[1], p[2]).sign());
      PictureOutline& outline = result.emplace_back();
      if (facing_.back() == 0) continue;
      const double least = view_.is_perspective() ? 1e-7 * glm::distance(p[0], view_.viewer()) : 0;
      for (int i = 0; i < 3; ++i) {
        const Vec3 from = p[i];
        const Vec3 to = p[(i + 1) % 3];
        const double here = view_.depth(from) - least;
        const double there = view_.depth(to) - least;
        if (here > 0) outline.corners.at(outline.count++) = view_.project(from);
        if ((here > 0) == (there > 0)) continue;
        const Vec3 cut = glm::mix(from, to, here / (here - there));
        if (view_.depth(cut) > 0) outline.corners.at(outline.count++) = view_.project(cut);
      }
    }
    return result;
  }

  void hide_behind(std::uint32_t ia, std::uint32_t ib, std::uint32_t k, Parts (&hidden)[2]) {
    const Triangle& corners = triangles_[k];
    const auto has = [&](std::uint32_t v) {
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    };
    const bool has_a = has(ia);
    const bool has_b = has(ib);
    if (has_a && has_b) return;
    const Vec3 a = points_[ia];
    const Vec3 b = points_[ib];
    const Vec3 p[3] = {points_[corners[0]], points_[corners[1]], points_[corners[2]]};
    const int facing = facing_[k];
    double from = 0;
    double to = 1;
    // Keeps the part of the edge where a linear function has the sign that is wanted. False if
    // nothing is left.
    const auto keep = [&](const ExactDeterminant& at_a, const ExactDeterminant& at_b, int wanted) {
      const int sign_a = wanted * at_a.sign();
      const int sign_b = wanted * at_b.sign();
      if (sign_a <= 0 && sign_b <= 0) return false;
      if (sign_a < 0) from = std::max(from, ExactDeterminant::root(at_a, at_b));
      if (sign_b < 0) to = std::min(to, ExactDeterminant::root(at_a, at_b));
      return from < to;
    };
    // The edge is behind the triangle's plane.
    const auto height = [&](Vec3 x) {
      return ExactDeterminant({p[1], p[0]}, {p[2], p[0]}, {x, p[0]});
    };
    const Vec3 base = p[0];
    if (!keep(has_a ? ExactDeterminant({base, base}, {a, a}, {a, a}) : height(a),
              has_b ? ExactDeterminant({base, base}, {b, b}, {b, b}) : height(b), -facing)) {
      return;
    }
    int only_side = 0;  // +1: to the left of the edge only, -1: to the right only
    for (int i = 0; i < 3; ++i) {
      const Vec3 u = p[i];
      const Vec3 v = p[(i + 1) % 3];
      const ExactDeterminant at_a = side(u, v, a);
      const ExactDeterminant at_b = side(u, v, b);
      if (at_a.sign() == 0 && at_b.sign() == 0) {
        only_side = side(a, b, p[(i + 2) % 3]).sign();
        if (only_side == 0) return;  // the edge is a point in the picture
      } else if (!keep(at_a, at_b, facing)) {
        return;
      }
    }
    if (only_side >= 0) hidden[0].emplace_back(from, to);
    if (only_side <= 0) hidden[1].emplace_back(from, to);
  }

  const std::vector<Vec3>& points_;
  const JudgeView view_;
  std::vector<Triangle> triangles_;
  std::vector<int> facing_;
  PictureGrid grid_;
};

enum class Wanted { No, Perhaps, Yes };

/// Whether an edge between two faces is one for who leaves out where the surface hardly turns.
/// Perhaps: so near to the angle, or with a face so near to being seen edge-on.
Wanted is_wanted(Vec3 p, Vec3 q, Vec3 point, const JudgeView& view, double angle_deg) {
  constexpr double kNearAngle = 0.01;
  constexpr double kNearEdgeOn = 1e-7;
  const double turn = 2 * std::asin(std::min(1.0, 0.5 * glm::length(p - q))) * 57.29577951308232;
  if (turn > angle_deg + kNearAngle) return Wanted::Yes;
  const Vec3 toward = glm::normalize(view.is_perspective() ? view.viewer() - point : view.viewer());
  const double one = glm::dot(p, toward);
  const double other = glm::dot(q, toward);
  const bool is_clear = std::min(std::abs(one), std::abs(other)) > kNearEdgeOn;
  if (is_clear && (one > 0) != (other > 0)) return Wanted::Yes;
  return is_clear && turn < angle_deg - kNearAngle ? Wanted::No : Wanted::Perhaps;
}

}  // namespace

std::vector<SeenEdge> seen_edges(const PlainMesh& given, const JudgeView& view,
                                 const SeenEdgesOptions& options) {
  const PlainMesh mesh = with_points_once(given);
  const double diagonal = diagonal_of(mesh);
  const Bends bends(mesh);
  Scene scene(mesh, view);
  std::vector<SeenEdge> edges;
  for (const auto& [ends, faces] : bends.faces_at()) {
    SeenEdge edge;
    edge.a = mesh.points[ends.first];
    edge.b = mesh.points[ends.second];
    if (faces.size() == 2) {
      const double bend = bends.between(faces[0], faces[1]);
      const bool is_flat = bend <= options.flat;
      edge.is_doubtful = bend <= options.bent;
      if (is_flat && !bends.is_beside_sliver(faces)) continue;
      const Wanted wanted = is_wanted(bends.normal(faces[0]), bends.normal(faces[1]), edge.a, view,
                                      options.crease_angle_deg);
      if (wanted == Wanted::No) continue;
      edge.is_doubtful |= options.crease_angle_deg > 0 && wanted == Wanted::Perhaps;
    }
    const auto window = view.clip(edge.a, edge.b);
    if (!window) continue;
    const glm::dvec2 from = view.project(glm::mix(edge.a, edge.b, window->first));
    const glm::dvec2 to = view.project(glm::mix(edge.a, edge.b, window->second));
    if (glm::distance(from, to) < kPointInPicture * diagonal) continue;
    const Parts hidden = scene.hidden_parts(ends.first, ends.second, {{from, to, {}, {}}, 2});
    edge.visible = without(*window, hidden);
    edge.hidden = common_of(hidden, {*window});
    edges.push_back(std::move(edge));
  }
  return edges;
}

std::vector<double> edge_bends(const PlainMesh& given) {
  const PlainMesh mesh = with_points_once(given);
  const Bends bends(mesh);
  std::vector<double> result;
  for (const auto& [ends, faces] : bends.faces_at()) {
    if (faces.size() == 2) result.push_back(bends.between(faces[0], faces[1]));
  }
  return result;
}

}  // namespace spoctree
