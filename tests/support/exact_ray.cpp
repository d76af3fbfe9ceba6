#include "tests/support/exact_ray.hpp"

#include <set>
#include <stdexcept>

#include "tests/support/tree_definition.hpp"

namespace spoctree {

std::vector<ExactSegment> segments_of_definition(const Octree& tree, std::uint32_t level,
                                                 const RationalPoint& origin,
                                                 const RationalPoint& direction) {
  std::set<Rational> times;
  const auto add = [&](const RationalPoint& normal, const Rational& offset) {
    Rational slope = 0;
    Rational ahead = offset;
    for (std::size_t i = 0; i < 3; ++i) {
      slope += normal[i] * direction[i];
      ahead -= normal[i] * origin[i];
    }
    if (slope == 0 && ahead == 0) throw std::logic_error("a ray within a plane");
    if (slope != 0 && ahead / slope > 0) times.insert(ahead / slope);
  };
  for (const Plane& plane : tree.planes) add(to_rational(plane.normal), Rational(plane.offset));
  const std::size_t depth = std::min<std::size_t>(level, tree.levels.size() - 1);
  const Rational half(tree.universe.half_side);
  const int cells = 1 << depth;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RationalPoint normal{0, 0, 0};
    normal[axis] = 1;
    for (int wall = 0; wall <= cells; ++wall) add(normal, half * (2 * wall - cells) / cells);
  }
  std::vector<ExactSegment> segments;
  Rational from = 0;
  const auto look_between = [&](const Rational& middle) {
    RationalPoint point;
    for (std::size_t i = 0; i < 3; ++i) point[i] = origin[i] + middle * direction[i];
    const TreeValue value = value_of_definition(tree, static_cast<std::uint32_t>(depth), point,
                                                {1, Rational(1, 3), Rational(1, 7)});
    using Content = ExactSegment::Content;
    const Content content = !value.is_known     ? Content::Unknown
                            : value.is_material ? Content::In
                                                : Content::Out;
    if (segments.empty() || segments.back().content != content) segments.push_back({content, from});
  };
  for (const Rational& time : times) {
    look_between((from + time) / 2);
    from = time;
  }
  look_between(from + 1);
  return segments;
}

}  // namespace spoctree
