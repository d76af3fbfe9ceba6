#include "common/tree/query_index.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/geometry/predicates.hpp"

namespace spoctree {

QueryIndex::QueryIndex(const Octree& tree, std::uint32_t level)
    : tree_(&tree),
      level_(std::min(level, static_cast<std::uint32_t>(tree.levels.size() - 1))),
      graph_(make_decision_graph(tree, level_)) {}

PointClass QueryIndex::classify(Vec3 point) const {
  const double half_side = tree_->universe.half_side;
  const double finest_per_unit = 0x1p29 / half_side;
  const auto ask_exactly = [&] { return classify_point(*tree_, point, level_); };
  // The finest cell that the point lies in, and which of that cell's lower walls it lies on.
  std::uint32_t cell[3];
  bool on_wall[3];
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const double y = point[static_cast<int>(axis)];
    if (!(std::abs(y) < half_side)) {
      return std::abs(y) == half_side ? ask_exactly() : PointClass::Out;
    }
    auto index = static_cast<std::uint32_t>((y + half_side) * finest_per_unit);
    while (y < wall_coordinate(half_side, index)) --index;
    while (y >= wall_coordinate(half_side, index + 1)) ++index;
    cell[axis] = index;
    on_wall[axis] = y == wall_coordinate(half_side, index);
  }
  Step step = graph_.root;
  std::uint32_t size = std::uint32_t{1} << kMaxDepth;
  while (!DecisionGraph::is_answer(step)) {
    if (DecisionGraph::is_test(step)) {
      const PlaneTest& test = graph_.test(step);
      const Plane& plane = tree_->planes[test.plane];
      const double value = glm::dot(plane.normal, point) - plane.offset;
      int side = value < 0 ? -1 : 1;
      if (std::abs(value) <= kSideError) {
        side = side_of_any_point(plane, point);
        if (side == 0) return ask_exactly();
      }
      step = side < 0 ? test.inside : test.outside;
    } else {
      size /= 2;
      const std::uint32_t octant = ((cell[0] & size) != 0 ? 1u : 0u) |
                                   ((cell[1] & size) != 0 ? 2u : 0u) |
                                   ((cell[2] & size) != 0 ? 4u : 0u);
      step = graph_.cell(step)[octant];
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (on_wall[axis] && (cell[axis] & (size - 1)) == 0) return ask_exactly();
  }
  constexpr PointClass kAnswers[] = {PointClass::Out, PointClass::In, PointClass::Unknown};
  return kAnswers[step];
}

}  // namespace spoctree
