#include "tests/support/query_judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>

#include "client/queries/measure.hpp"
#include "common/tree/model_queries.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/mesh_judge.hpp"
#include "tests/support/random.hpp"
#include "tests/support/ray_judge.hpp"
#include "tests/support/solid_mesh.hpp"

namespace spoctree {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFlat = 1e-12;

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = glm::length(v);
    if (length > 0.1 && length <= 1) return v / length;
  }
}

struct AskedRay {
  Vec3 origin{0.0};
  Vec3 direction{0.0};
  bool is_aimed_at_edge = false;
};

/// Parts of the surface that hang together in vertices, by the sign of what they enclose.
std::pair<std::uint32_t, std::uint32_t> count_parts(const PlainMesh& mesh) {
  std::vector<std::size_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t corner : face) parent[find(corner)] = find(face[0]);
  }
  std::map<std::size_t, double> volumes;
  for (const auto& face : mesh.faces) {
    const std::size_t part = find(face[0]);
    const Vec3 origin = mesh.points[part];
    const Vec3 a = mesh.points[face[0]] - origin;
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      volumes[part] +=
          glm::dot(a, glm::cross(mesh.points[face[k]] - origin, mesh.points[face[k + 1]] - origin));
    }
  }
  std::uint32_t components = 0;
  std::uint32_t cavities = 0;
  for (const auto& [part, volume] : volumes) ++(volume < 0 ? cavities : components);
  return {components, cavities};
}

class QueryJudgement {
 public:
  QueryJudgement(const Octree& tree, const PlainMesh& mesh, const QueryJudgementOptions& options)
      : tree_(tree), mesh_(mesh), options_(options), judge_(mesh), rays_(mesh) {
    for (std::uint32_t k = 0; k < tree.levels.size(); ++k) indices_.emplace_back(tree, k);
  }

  void judge_points(Random& random) {
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < options_.points; ++i) {
      const Vec3 point = i % 2 == 0 ? point_in_box(random) : point_near_surface(random);
      if (judge_.distance(point) < 1e-10 * judge_.diagonal()) continue;
      const PointClass right = judge_.is_inside(point) ? PointClass::In : PointClass::Out;
      PointClass before = PointClass::Unknown;
      for (const QueryIndex& index : indices_) {
        const PointClass now = classify_in_model(index, point);
        unknown += now == PointClass::Unknown;
        EXPECT_TRUE(now == right || (now == PointClass::Unknown && before == now))
            << "level " << index.level() << " point " << text_of(point) << " "
            << static_cast<int>(now);
        before = now;
      }
      EXPECT_EQ(before, right) << text_of(point);
    }
    if (indices_.size() > 3) {
      EXPECT_GT(unknown, 0u);
    }
  }

  void judge_rays(Random& random) {
    for (std::size_t i = 0; i < options_.rays; ++i) {
      const AskedRay ray = draw_ray(i, random);
      if (judge_.distance(ray.origin) < 1e-10 * judge_.diagonal()) continue;
      const auto right = rays_.first_crossing(ray.origin, ray.direction);
      for (const QueryIndex& index : indices_) {
        const RayAnswer answer = first_hit_in_model(index, ray.origin, ray.direction);
        std::string fault = fault_of(ray, answer, right);
        if (!fault.empty() && ray.is_aimed_at_edge) {
          // Within rounding of an edge: right for one of the rays beside it will do. Few of them
          // meet a sharp corner.
          for (int k = 0; k < 500 && !fault.empty(); ++k) {
            AskedRay beside = ray;
            beside.origin += 1e-11 * judge_.diagonal() * random_direction(random);
            fault = fault_of(ray, answer, rays_.first_crossing(beside.origin, beside.direction));
          }
        }
        EXPECT_EQ(fault, "") << "level " << index.level() << " of " << indices_.size() - 1
                             << " ray " << i << " " << text_of(ray.origin) << " + t "
                             << text_of(ray.direction);
        const bool is_last = index.level() + 1 == indices_.size();
        EXPECT_FALSE(is_last && answer.kind == RayAnswer::Kind::Between);
      }
    }
  }

  void judge_measures() {
    const double volume = volume_of(mesh_);
    const double area = area_of(mesh_);
    const double slack = 1e-9;
    std::optional<Measures> before;
    for (std::uint32_t k = 0; k < tree_.levels.size(); ++k) {
      SCOPED_TRACE(testing::Message() << "measures of level " << k);
      const Measures now = measure(tree_, k);
      EXPECT_EQ(now.is_exact, k + 1 == tree_.levels.size());
      EXPECT_LE(now.volume.lower, volume * (1 + slack));
      EXPECT_GE(now.volume.upper, volume * (1 - slack));
      EXPECT_LE(now.area.lower, area * (1 + slack));
      EXPECT_GE(now.area.upper, area * (1 - slack));
      ASSERT_TRUE(now.outer_box);
      for (int axis = 0; axis < 3; ++axis) {
        // Rounded planes that are nearly parallel meet far from where they met before.
        const double off = 1e-9 * tree_.universe.side();
        EXPECT_LE(now.outer_box->lower[axis], judge_.lower()[axis] + off);
        EXPECT_GE(now.outer_box->upper[axis], judge_.upper()[axis] - off);
        if (!now.inner_box) continue;
        EXPECT_GE(now.inner_box->lower[axis], judge_.lower()[axis] - off);
        EXPECT_LE(now.inner_box->upper[axis], judge_.upper()[axis] + off);
      }
      if (before) {
        EXPECT_GE(now.volume.lower, before->volume.lower - slack * volume);
        EXPECT_LE(now.volume.upper, before->volume.upper + slack * volume);
        EXPECT_GE(now.area.lower, before->area.lower - slack * area);
        EXPECT_LE(now.area.upper, before->area.upper + slack * area);
      }
      before = now;
    }
    EXPECT_EQ(before->volume.lower, before->volume.upper);
    EXPECT_EQ(before->area.lower, before->area.upper);
    EXPECT_NEAR(before->volume.lower / volume, 1, slack);
    EXPECT_NEAR(before->area.lower / area, 1, slack);
    const double off = 1e-9 * tree_.universe.side();
    EXPECT_LE(glm::length(before->outer_box->lower - judge_.lower()), off);
    EXPECT_LE(glm::length(before->outer_box->upper - judge_.upper()), off);
    const auto [components, cavities] = count_parts(mesh_);
    EXPECT_EQ(before->components, components);
    EXPECT_EQ(before->cavities, cavities);
  }

 private:
  static std::string text_of(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
  }
  static std::string text_of(Vec3 p) {
    char text[100];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g", p.x, p.y, p.z);
    return text;
  }

  Vec3 point_in_box(Random& random) const {
    const Vec3 size = judge_.upper() - judge_.lower();
    return judge_.lower() + size * Vec3(random.unit(), random.unit(), random.unit());
  }

  Vec3 point_near_surface(Random& random) const {
    const auto sample = random.chance(0.5) ? judge_.sample(random) : judge_.sample_triangle(random);
    const double off = std::pow(10.0, random.between(-6, -2)) * judge_.diagonal();
    return sample.point + sample.normal * (random.chance(0.5) ? off : -off);
  }

  AskedRay draw_ray(std::size_t i, Random& random) const {
    const Vec3 centre = 0.5 * (judge_.lower() + judge_.upper());
    const Vec3 outside = centre + random_direction(random) * judge_.diagonal();
    const double length = std::pow(10.0, random.between(-3, 3));
    switch (i % 4) {
      case 0:
        return {outside, (point_in_box(random) - outside) * length};
      case 1:
        return {point_in_box(random), random_direction(random) * length};
      case 2:
        return {point_near_surface(random), random_direction(random) * length};
      default: {
        // At a vertex, or a point of an edge.
        const auto& face =
            mesh_.faces[random.below(static_cast<std::uint32_t>(mesh_.faces.size()))];
        const Vec3 a = mesh_.points[face[0]];
        const Vec3 b = mesh_.points[face[1]];
        const Vec3 target = random.chance(0.5) ? a : a + random.unit() * (b - a);
        return {outside, (target - outside) * length, true};
      }
    }
  }

  /// What is wrong with an answer; empty if nothing is.
  std::string fault_of(const AskedRay& ray, const RayAnswer& answer,
                       const std::optional<RayJudge::Crossing>& right) const {
    const std::string truth = right ? "hit at " + text_of(right->time) : "a miss";
    switch (answer.kind) {
      case RayAnswer::Kind::Miss:
        return right ? "says miss, is " + truth : "";
      case RayAnswer::Kind::Between:
        if (right ? answer.first <= right->time && right->time <= answer.last
                  : answer.last == kInfinity) {
          return "";
        }
        return "says between " + text_of(answer.first) + " and " + text_of(answer.last) + ", is " +
               truth;
      case RayAnswer::Kind::Hit:
        break;
    }
    // Along the normal, in fractions of the diagonal.
    const double unit = glm::length(ray.direction) / judge_.diagonal();
    const double allowed = ray.is_aimed_at_edge ? 1e-10 : 1e-12;
    if (!right || std::abs(answer.first - right->time) * unit * std::abs(right->slope) > allowed) {
      return "says hit at " + text_of(answer.first) + ", is " + truth;
    }
    if (!ray.is_aimed_at_edge && glm::length(answer.normal - right->normal) > 1e-6) {
      return "the normal is " + text_of(answer.normal) + ", should be " + text_of(right->normal);
    }
    return "";
  }

  const Octree& tree_;
  const PlainMesh& mesh_;
  const QueryJudgementOptions& options_;
  const MeshJudge judge_;
  const RayJudge rays_;
  std::vector<QueryIndex> indices_;
};

}  // namespace

void judge_queries(const std::string& name, const PolygonSoup& soup,
                   const QueryJudgementOptions& options) {
  SCOPED_TRACE(name);
  ImportOptions import_options;
  import_options.flat_tolerance = kFlat;
  const Solid solid = import_solid(soup, name, import_options);
  const SolidQueries queries(solid);
  BuiltOctree built = build_octree(solid, queries, {});
  certify(built, solid, queries);
  const PlainMesh mesh = mesh_of(solid);
  QueryJudgement judgement(built.tree, mesh, options);
  Random random(7);
  judgement.judge_points(random);
  judgement.judge_rays(random);
  std::size_t nodes = 0;
  for (const Level& level : built.tree.levels) nodes += level.size();
  if (nodes <= options.measure_up_to) judgement.judge_measures();
}

}  // namespace spoctree
