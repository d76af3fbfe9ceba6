#include "tests/support/sight_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

namespace spoctree {

namespace {

using glm::dvec2;

/// Far less than any feature of a test scene, far more than any rounding.
constexpr double kBeside = 1e-11;
constexpr double kStart = 1e-8;

double distance_to_segment(dvec2 p, dvec2 a, dvec2 b) {
  const dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? glm::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * along);
}

std::string text_of(const char* what, Vec3 point) {
  std::ostringstream text;
  text.precision(12);
  text << what << " at (" << point.x << ", " << point.y << ", " << point.z << ")";
  return text.str();
}

}  // namespace

SightOracle::SightOracle(const Surface& surface, const PlaneSet& planes, Vec3 toward_viewer)
    : surface_(surface), planes_(planes), toward_viewer_(glm::normalize(toward_viewer)) {
  // Any two axes across the direction will do.
  const Vec3 other = std::abs(toward_viewer_.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  x_axis_ = glm::normalize(glm::cross(toward_viewer_, other));
  y_axis_ = glm::cross(toward_viewer_, x_axis_);
}

glm::dvec2 SightOracle::project(Vec3 point) const {
  return {glm::dot(x_axis_, point), glm::dot(y_axis_, point)};
}

bool SightOracle::is_inside(const Surface::Face& face, Vec3 point, Vec3 x_axis, Vec3 y_axis) const {
  const auto flat = [&](Vec3 q) { return dvec2{glm::dot(x_axis, q), glm::dot(y_axis, q)}; };
  const dvec2 p = flat(point);
  bool inside = false;  // even-odd, over all loops
  for (const Surface::Loop& loop : surface_.loops_of(face)) {
    const auto corners = surface_.vertices_of(loop);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const dvec2 a = flat(surface_.vertices[corners[k]]);
      const dvec2 b = flat(surface_.vertices[corners[(k + 1) % corners.size()]]);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

bool SightOracle::ray_is_free(Vec3 from) const {
  for (const Surface::Face& face : surface_.faces) {
    const Plane plane = planes_[face.plane];
    const double slope = glm::dot(plane.normal, toward_viewer_);
    if (std::abs(slope) < 1e-12) continue;
    const double ahead = (plane.offset - glm::dot(plane.normal, from)) / slope;
    if (ahead > kStart && is_inside(face, from, x_axis_, y_axis_)) return false;
  }
  return true;
}

bool SightOracle::touches_flat_face(const Surface::Edge& edge) const {
  const Vec3 a = surface_.vertices[edge.a];
  const Vec3 b = surface_.vertices[edge.b];
  for (std::uint32_t k = 0; k < surface_.faces.size(); ++k) {
    const Plane plane = planes_[surface_.faces[k].plane];
    const auto on_plane = [&](Vec3 p) {
      return std::abs(glm::dot(plane.normal, p) - plane.offset) < 1e-9;
    };
    const auto sides = surface_.sides_of(edge);
    const bool is_beside = std::any_of(sides.begin(), sides.end(),
                                       [&](const Surface::Side& side) { return side.face == k; });
    if (is_beside || !on_plane(a) || !on_plane(b)) continue;
    const Vec3 x_axis = glm::normalize(b - a);
    const Vec3 y_axis = glm::cross(plane.normal, x_axis);
    const Vec3 beside = 1e-9 * y_axis;
    const Vec3 middle = 0.5 * (a + b);
    if (is_inside(surface_.faces[k], middle + beside, x_axis, y_axis) ||
        is_inside(surface_.faces[k], middle - beside, x_axis, y_axis)) {
      return true;
    }
  }
  return false;
}

bool SightOracle::is_visible(Vec3 point, Vec3 direction) const {
  const Vec3 beside = kBeside * glm::normalize(glm::cross(toward_viewer_, direction));
  return ray_is_free(point + beside) || ray_is_free(point - beside);
}

bool SightOracle::is_near_other_crease(Vec3 point, Vec3 direction, double distance) const {
  const dvec2 p = project(point);
  const dvec2 along = glm::normalize(project(direction));
  for (const Surface::Edge& edge : surface_.edges) {
    const dvec2 a = project(surface_.vertices[edge.a]);
    const dvec2 b = project(surface_.vertices[edge.b]);
    const dvec2 ab = b - a;
    const bool on_the_line = std::abs(along.x * ab.y - along.y * ab.x) < 1e-9 * glm::length(ab) &&
                             std::abs(along.x * (p.y - a.y) - along.y * (p.x - a.x)) < 1e-9;
    if (on_the_line) {
      // It begins and ends somewhere, though.
      if (glm::distance(a, p) < distance || glm::distance(b, p) < distance) return true;
    } else if (distance_to_segment(p, a, b) < distance) {
      return true;
    }
  }
  return false;
}

std::vector<std::string> compare(const VisibleLines& lines, const SightOracle& oracle, int samples,
                                 std::size_t& tried) {
  constexpr double kMargin = 1e-7;
  constexpr double kOnLine = 1e-8;
  // Of lines so close to each other only one is drawn: a millionth of the universe's diagonal.
  constexpr double kClose = 4e-6;
  constexpr std::size_t kMost = 10;
  std::vector<std::string> errors;
  const Surface& surface = oracle.surface();
  // Irregular places, so that symmetric scenes are not sampled at their symmetric points only.
  const auto place = [&](int k) { return (k + 0.381966) / samples; };
  // The direction of a short step is known up to `near` only.
  const auto is_drawn = [&](dvec2 p, const VisibleLine* except, dvec2 step, double near) {
    const dvec2 along = glm::normalize(step);
    const double bend = 1e-6 + 2 * near / glm::length(step);
    for (const VisibleLine& line : lines) {
      if (&line == except) continue;
      const dvec2 a = oracle.project(line.a);
      const dvec2 b = oracle.project(line.b);
      const dvec2 ab = b - a;
      if (std::abs(along.x * ab.y - along.y * ab.x) > bend * glm::length(ab)) continue;
      if (distance_to_segment(p, a, b) < near) return true;
    }
    return false;
  };
  for (const Surface::Edge& edge : surface.edges) {
    const Vec3 a = surface.vertices[edge.a];
    const Vec3 step = surface.vertices[edge.b] - a;
    const dvec2 step_seen = oracle.project(step);
    if (glm::length(step_seen) < 1e-6 || oracle.touches_flat_face(edge)) continue;
    for (int k = 0; k < samples && errors.size() < kMost; ++k) {
      const Vec3 point = a + place(k) * step;
      if (oracle.is_near_other_crease(point, step, kMargin)) continue;
      ++tried;
      if (oracle.is_visible(point, step) &&
          !is_drawn(oracle.project(point), nullptr, step_seen, kClose)) {
        errors.push_back(text_of("a crease that is seen is not drawn", point));
      }
    }
  }
  for (const VisibleLine& line : lines) {
    const Vec3 step = line.b - line.a;
    for (int k = 0; k < samples && errors.size() < kMost; ++k) {
      const Vec3 point = line.a + place(k) * step;
      if (oracle.is_near_other_crease(point, step, kMargin)) continue;
      ++tried;
      if (!oracle.is_visible(point, step)) {
        errors.push_back(text_of("a line is drawn that is not seen", point));
      }
      if (is_drawn(oracle.project(point), &line, oracle.project(step), kOnLine)) {
        errors.push_back(text_of("two lines lie on each other", point));
      }
    }
  }
  return errors;
}

}  // namespace spoctree
