#include "tools/benchmark/query_samples.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace spoctree {

namespace {

/// The distributions of <random> differ between libraries; its engines do not.
class Sampler {
 public:
  explicit Sampler(const Solid& solid) : solid_(solid), lower_(solid.vertices.at(0)) {
    upper_ = lower_;
    for (const Vec3 vertex : solid.vertices) {
      lower_ = glm::min(lower_, vertex);
      upper_ = glm::max(upper_, vertex);
    }
  }

  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double diagonal() const { return glm::length(upper_ - lower_); }
  Vec3 centre() const { return 0.5 * (lower_ + upper_); }
  Vec3 in_box() { return lower_ + (upper_ - lower_) * Vec3(unit(), unit(), unit()); }

  Vec3 direction() {
    while (true) {
      const Vec3 v{2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1};
      const double length = glm::length(v);
      if (length > 0.01 && length <= 1) return v / length;
    }
  }

  Vec3 near_surface() {
    const auto& t = solid_.triangles[engine_() % solid_.triangles.size()];
    const Vec3 a = solid_.vertices[t.vertex[0]];
    const Vec3 ab = solid_.vertices[t.vertex[1]] - a;
    const Vec3 ac = solid_.vertices[t.vertex[2]] - a;
    double u = unit();
    double v = unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3 normal = glm::cross(ab, ac);
    const double length = glm::length(normal);
    const double distance = diagonal() * std::pow(10.0, -6 + 4 * unit());
    const Vec3 away = length > 0 ? normal / length : Vec3(0.0);
    return a + u * ab + v * ac + away * (unit() < 0.5 ? distance : -distance);
  }

 private:
  const Solid& solid_;
  Vec3 lower_;
  Vec3 upper_;
  std::mt19937_64 engine_{1};
};

Vec3 on_grid(Vec3 y) {
  for (int axis = 0; axis < 3; ++axis) y[axis] = std::nearbyint(y[axis] * 0x1p52) * 0x1p-52;
  return y;
}

}  // namespace

std::vector<Vec3> sample_points(const Solid& solid, std::size_t count) {
  Sampler sampler(solid);
  std::vector<Vec3> points;
  while (points.size() < count) {
    points.push_back(on_grid(points.size() % 2 == 0 ? sampler.in_box() : sampler.near_surface()));
  }
  return points;
}

std::vector<Ray> sample_rays(const Solid& solid, std::size_t count) {
  Sampler sampler(solid);
  std::vector<Ray> rays;
  while (rays.size() < count) {
    if (rays.size() % 2 == 0) {
      const Vec3 origin =
          on_grid(sampler.centre() + sampler.direction() * (0.75 * sampler.diagonal()));
      rays.push_back({origin, sampler.in_box() - origin});
    } else {
      const Vec3 origin = on_grid(sampler.in_box());
      rays.push_back({origin, sampler.direction()});
    }
  }
  return rays;
}

}  // namespace spoctree
