#include "server/build/certify.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <queue>

#include "common/tree/pieces.hpp"
#include "server/solid/triangle_distance.hpp"

namespace spoctree {

namespace {

/// Distances are computed to better than this; it is added to every bound (universe units).
constexpr double kDistanceRounding = 1e-12;

/// Distance queries spent on one level at most.
constexpr std::size_t kQueriesPerLevel = 20000;

/// Sums volumes, and keeps the GREY pieces that may hold a level's largest error.
class LevelSurvey : public PieceVisitor {
 public:
  struct Candidate {
    double bound;
    Polyhedron piece;
  };

  LevelSurvey(const BuiltOctree& built, const Solid& solid, const SolidQueries& queries)
      : built_(built),
        solid_(solid),
        queries_(queries),
        grey_volume(built.tree.levels.size(), 0.0),
        attained(built.tree.levels.size(), 0.0),
        candidates(built.tree.levels.size()) {}

  void piece(const NodeAddress&, NodeKind, std::uint32_t, const Polyhedron&) override {}

  void inner(const NodeAddress& address, const Polyhedron& region) override {
    grey_volume[address.level] += volume(region);
    const std::uint32_t grey = built_.tree.levels[address.level].first_child[address.index] / 8;
    const SolidTriangle& witness = solid_.triangles[built_.witnesses[address.level][grey]];
    const MeasuredTriangle triangle(solid_.vertices[witness.vertex[0]],
                                    solid_.vertices[witness.vertex[1]],
                                    solid_.vertices[witness.vertex[2]]);
    double bound = 0;
    const PolyhedronVertex* farthest = nullptr;
    for (const PolyhedronVertex& vertex : region.vertices) {
      const double distance = std::sqrt(triangle.squared_distance(vertex.position)) + vertex.error;
      if (distance >= bound) {
        bound = distance;
        farthest = &vertex;
      }
    }
    double& reached = attained[address.level];
    if (bound <= kErrorBoundRatio * reached) return;
    // A distance that is attained, from the corner that looks farthest, keeps the list short.
    consider(*farthest, reached);
    if (bound > kErrorBoundRatio * reached) candidates[address.level].push_back({bound, region});
  }

  /// A certified bound of the level's error, in universe units.
  double bound(std::uint32_t level) {
    struct Box {
      double bound;
      Vec3 centre;
      Vec3 half;
      const Polyhedron* piece;
      bool operator<(const Box& other) const { return bound < other.bound; }
    };
    std::priority_queue<Box> open;
    double& reached = attained[level];
    for (const Candidate& candidate : candidates[level]) {
      if (candidate.bound <= kErrorBoundRatio * reached) continue;
      const auto& vertices = candidate.piece.vertices;
      Vec3 lower = vertices.front().position;
      Vec3 upper = lower;
      for (const PolyhedronVertex& vertex : vertices) {
        lower = glm::min(lower, vertex.position);
        upper = glm::max(upper, vertex.position);
      }
      open.push({candidate.bound, 0.5 * (lower + upper), 0.5 * (upper - lower), &candidate.piece});
    }
    const PlaneSet planes = built_.tree.plane_set();
    std::size_t queries = 0;
    while (!open.empty() && open.top().bound > kErrorBoundRatio * reached &&
           queries < kQueriesPerLevel) {
      const Box box = open.top();
      open.pop();
      for (unsigned octant = 0; octant < 8; ++octant) {
        Box part = box;
        part.half = 0.5 * box.half;
        for (int axis = 0; axis < 3; ++axis) {
          part.centre[axis] += ((octant >> axis) & 1) ? part.half[axis] : -part.half[axis];
        }
        bool centre_in_piece = true;
        if (!may_meet(*box.piece, planes, part.centre, part.half, centre_in_piece)) continue;
        ++queries;
        const double radius = glm::length(part.half);
        const double distance = queries_.distance(part.centre);
        if (distance > radius || (centre_in_piece && distance > reached)) {
          const bool in_solid = is_in_solid(part.centre);
          if (in_solid && distance > radius) continue;  // all of the part is material
          if (!in_solid && centre_in_piece) reached = std::max(reached, distance);
        }
        part.bound = std::min(box.bound, distance + radius);
        if (part.bound > kErrorBoundRatio * reached) open.push(part);
      }
    }
    const double bound =
        std::max(kErrorBoundRatio * reached, open.empty() ? 0.0 : open.top().bound);
    return bound + kDistanceRounding;
  }

 private:
  bool is_in_solid(Vec3 point) const { return queries_.side_of(point) == SolidQueries::Side::In; }

  /// Raises `reached` to the distance of a corner of a piece from the solid.
  void consider(const PolyhedronVertex& vertex, double& reached) const {
    const double distance = queries_.distance(vertex.position) - vertex.error;
    if (distance > reached && !is_in_solid(vertex.position)) reached = distance;
  }

  static bool may_meet(const Polyhedron& piece, const PlaneSet& planes, Vec3 centre, Vec3 half,
                       bool& centre_in_piece) {
    constexpr double kRounding = 1e-14;
    for (const Polyhedron::Face& face : piece.faces) {
      const Plane plane = planes[face.plane];
      const double value = glm::dot(plane.normal, centre) - plane.offset;
      if (value - glm::dot(glm::abs(plane.normal), half) > kRounding) return false;
      if (value > 0) centre_in_piece = false;
    }
    return true;
  }

  const BuiltOctree& built_;
  const Solid& solid_;
  const SolidQueries& queries_;

 public:
  std::vector<double> grey_volume;  ///< of the GREY nodes' regions per level, universe units
  std::vector<double> attained;     ///< a distance that some point of T_k has
  std::vector<std::vector<Candidate>> candidates;
};

}  // namespace

void certify(BuiltOctree& built, const Solid& solid, const SolidQueries& queries) {
  LevelSurvey survey(built, solid, queries);
  WalkOptions options;
  options.inner_nodes_only = true;
  walk_pieces(built.tree, options, survey);
  const double unit = built.tree.universe.scale();
  const double unit_volume = unit * unit * unit;
  double inner = 0;
  double inner_area = 0;
  const double whole_area = std::accumulate(built.leaf_areas.begin(), built.leaf_areas.end(), 0.0);
  double bound = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < built.tree.levels.size(); ++k) {
    Level& level = built.tree.levels[k];
    inner += built.leaf_volumes[k];
    level.statement.inner_volume = inner * unit_volume;
    level.statement.outer_volume = (inner + survey.grey_volume[k]) * unit_volume;
    inner_area += built.leaf_areas[k];
    level.statement.inner_area = inner_area * (unit * unit);
    level.statement.outer_area = whole_area * (unit * unit);
    // T_k lies in T_k-1: what bounds the one bounds the other, whichever was found more tightly.
    bound = level.grey_count == 0 ? 0 : std::min(bound, survey.bound(k) * unit);
    level.statement.error_bound = bound;
  }
}

}  // namespace spoctree
