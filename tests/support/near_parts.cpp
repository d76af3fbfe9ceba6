#include "tests/support/near_parts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace spoctree {

namespace {

using Part = std::pair<double, double>;

/// Where |offset + t * step| <= distance.
std::optional<Part> where_short(Vec3 offset, Vec3 step, double distance) {
  const double square = glm::dot(step, step);
  if (square < 1e-300) {
    if (glm::length(offset) > distance) return {};
    return Part(-1e300, 1e300);
  }
  const double nearest = -glm::dot(offset, step) / square;
  const Vec3 rest = offset + nearest * step;
  const double room = distance * distance - glm::dot(rest, rest);
  if (room < 0) return {};
  const double half = std::sqrt(room / square);
  return Part(nearest - half, nearest + half);
}

}  // namespace

std::optional<Part> part_near(const Segment& of, const Segment& to, double distance) {
  const Vec3 step = of.b - of.a;
  Part result{2, -1};
  const auto include = [&](double from, double till) {
    from = std::max(from, 0.0);
    till = std::min(till, 1.0);
    if (from > till) return;
    result = {std::min(result.first, from), std::max(result.second, till)};
  };
  // The points near a segment are those near its ends and those in a cylinder.
  for (const Vec3 end : {to.a, to.b}) {
    if (const auto ball = where_short(of.a - end, step, distance))
      include(ball->first, ball->second);
  }
  const double length = glm::distance(to.a, to.b);
  if (length > 0) {
    const Vec3 axis = (to.b - to.a) / length;
    const Vec3 offset = of.a - to.a;
    const double start = glm::dot(axis, offset);
    const double slope = glm::dot(axis, step);
    if (const auto round = where_short(offset - start * axis, step - slope * axis, distance)) {
      double from = round->first;
      double till = round->second;
      if (slope == 0) {
        if (start < 0 || start > length) from = 2;
      } else {
        const double at_a = -start / slope;
        const double at_b = (length - start) / slope;
        from = std::max(from, std::min(at_a, at_b));
        till = std::min(till, std::max(at_a, at_b));
      }
      include(from, till);
    }
  }
  if (result.first > result.second) return {};
  return result;
}

std::optional<Part> part_along(const Segment& of, const Segment& on, double distance) {
  const double length = glm::distance(of.a, of.b);
  if (!(length > 0)) return {};
  const Vec3 axis = (of.b - of.a) / length;
  double s[2] = {glm::dot(axis, on.a - of.a), glm::dot(axis, on.b - of.a)};
  Vec3 off[2] = {on.a - of.a - s[0] * axis, on.b - of.a - s[1] * axis};
  if (s[0] > s[1]) {
    std::swap(s[0], s[1]);
    std::swap(off[0], off[1]);
  }
  const double from = std::max(s[0], 0.0);
  const double to = std::min(s[1], length);
  if (from > to + distance || s[1] - s[0] <= 0) return {};
  for (const double place : {from, to}) {
    const double weight = (place - s[0]) / (s[1] - s[0]);
    if (glm::length((1 - weight) * off[0] + weight * off[1]) > distance) return {};
  }
  return Part(from / length, to / length);
}

Parts united(Parts parts) {
  std::sort(parts.begin(), parts.end());
  Parts result;
  for (const auto& [from, to] : parts) {
    if (!result.empty() && from <= result.back().second) {
      result.back().second = std::max(result.back().second, to);
    } else {
      result.emplace_back(from, to);
    }
  }
  return result;
}

Parts common_of(const Parts& one, const Parts& other) {
  Parts result;
  for (auto a = one.begin(), b = other.begin(); a != one.end() && b != other.end();) {
    const double from = std::max(a->first, b->first);
    const double to = std::min(a->second, b->second);
    if (from < to) result.emplace_back(from, to);
    if (a->second < b->second) {
      ++a;
    } else {
      ++b;
    }
  }
  return result;
}

Parts without(Part whole, const Parts& parts) {
  Parts result;
  double from = whole.first;
  for (const Part& part : parts) {
    if (part.first > from && from < whole.second) {
      result.emplace_back(from, std::min(part.first, whole.second));
    }
    from = std::max(from, part.second);
  }
  if (from < whole.second) result.emplace_back(from, whole.second);
  return result;
}

}  // namespace spoctree
