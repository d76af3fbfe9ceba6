#include "tests/support/compare_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/support/near_parts.hpp"
#include "tests/support/picture_grid.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kFaultsTold = 3;

std::vector<Segment> in_picture(const VisibleLines& lines, const Camera& camera,
                                const Rectangle& frame) {
  std::vector<Segment> segments;
  for (const VisibleLine& line : lines) {
    const Segment whole{Vec3(camera.project(line.a), 0), Vec3(camera.project(line.b), 0)};
    double from = 0;
    double to = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double way = whole.b[axis] - whole.a[axis];
      for (const double sign : {1.0, -1.0}) {
        // Where it is inside one side of the frame.
        const double room =
            sign > 0 ? frame.upper[axis] - whole.a[axis] : whole.a[axis] - frame.lower[axis];
        const double step = sign * way;
        if (step == 0 && room < 0) to = -1;
        if (step > 0) to = std::min(to, room / step);
        if (step < 0) from = std::max(from, room / step);
      }
    }
    if (from < to) segments.push_back({whole.at(from), whole.at(to)});
  }
  return segments;
}

/// The length of what is in the first drawing only.
double length_only_in(const std::vector<Segment>& first, const std::vector<Segment>& second,
                      double tolerance, const char* name, std::vector<std::string>& faults) {
  const auto outline_of = [](const Segment& segment) {
    PictureOutline outline;
    outline.count = 2;
    outline.corners[0] = {segment.a.x, segment.a.y};
    outline.corners[1] = {segment.b.x, segment.b.y};
    return outline;
  };
  std::vector<PictureOutline> outlines;
  double half_width = 0;
  for (const Segment& segment : second) {
    outlines.push_back(outline_of(segment));
    for (const Vec3 end : {segment.a, segment.b}) {
      half_width = std::max({half_width, std::abs(end.x), std::abs(end.y)});
    }
  }
  PictureGrid grid(outlines, 2 * tolerance, half_width + 1);
  std::vector<std::pair<double, std::string>> found;
  double sum = 0;
  for (const Segment& segment : first) {
    const double length = glm::distance(segment.a, segment.b);
    Parts covered;
    for (const std::uint32_t other : grid.near(outline_of(segment))) {
      if (const auto part = part_near(segment, second[other], tolerance)) covered.push_back(*part);
    }
    for (const auto& [from, to] : without({0, 1}, united(std::move(covered)))) {
      if ((to - from) * length < tolerance) continue;
      sum += (to - from) * length;
      char text[160];
      const Vec3 a = segment.at(from);
      const Vec3 b = segment.at(to);
      std::snprintf(text, sizeof text, "only %s: %.3g from (%.9f, %.9f) to (%.9f, %.9f)", name,
                    (to - from) * length, a.x, a.y, b.x, b.y);
      found.emplace_back((to - from) * length, text);
    }
  }
  std::sort(found.rbegin(), found.rend());
  for (std::size_t k = 0; k < std::min(found.size(), kFaultsTold); ++k) {
    faults.push_back(found[k].second);
  }
  return sum;
}

}  // namespace

DrawingDifference compare_drawings(const VisibleLines& first, const VisibleLines& second,
                                   const Camera& camera, const Rectangle& frame, double tolerance) {
  const std::vector<Segment> one = in_picture(first, camera, frame);
  const std::vector<Segment> other = in_picture(second, camera, frame);
  DrawingDifference difference;
  for (const Segment& segment : one) difference.length += glm::distance(segment.a, segment.b);
  difference.only_first = length_only_in(one, other, tolerance, "first", difference.faults);
  difference.only_second = length_only_in(other, one, tolerance, "second", difference.faults);
  return difference;
}

}  // namespace spoctree
