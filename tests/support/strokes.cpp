#include "tests/support/strokes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

namespace spoctree {

namespace {

PictureOutline outline_of(const Segment& picture) {
  return {{glm::dvec2(picture.a), glm::dvec2(picture.b), {}, {}}, 2};
}

std::vector<PictureOutline> outlines_of(const std::vector<Stroke>& strokes) {
  std::vector<PictureOutline> result;
  for (const Stroke& stroke : strokes) result.push_back(outline_of(stroke.picture));
  return result;
}

std::vector<Stroke> longest_first(std::vector<Stroke> strokes) {
  std::stable_sort(strokes.begin(), strokes.end(), [](const Stroke& one, const Stroke& other) {
    return one.length() > other.length();
  });
  return strokes;
}

}  // namespace

double Stroke::length() const { return glm::distance(picture.a, picture.b); }

Strokes::Strokes(std::vector<Stroke> strokes, double pad, double half_width)
    : strokes_(longest_first(std::move(strokes))), grid_(outlines_of(strokes_), pad, half_width) {}

Parts Strokes::near(const Stroke& stroke, double distance) {
  return near_as(&Stroke::picture, stroke, distance);
}

Parts Strokes::near_in_space(const Stroke& stroke, double distance) {
  return near_as(&Stroke::space, stroke, distance);
}

Parts Strokes::near_as(Segment Stroke::*segment, const Stroke& stroke, double distance) {
  Parts parts;
  for (const std::uint32_t k : grid_.near(outline_of(stroke.picture))) {
    const auto part = part_near(stroke.*segment, strokes_[k].*segment, distance);
    if (part) parts.push_back(*part);
  }
  return united(std::move(parts));
}

Parts Strokes::along(const Stroke& stroke, double distance, std::size_t count) {
  Parts parts;
  for (const std::uint32_t k : grid_.near(outline_of(stroke.picture))) {
    if (k >= count) continue;
    const auto part = part_along(stroke.picture, strokes_[k].picture, distance);
    if (part && part->first < part->second) parts.push_back(*part);
  }
  return united(std::move(parts));
}

std::size_t Strokes::count_runs(double distance) {
  std::vector<std::uint32_t> parent(strokes_.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::uint32_t k = 0; k < strokes_.size(); ++k) {
    const Segment& shorter = strokes_[k].picture;
    for (const std::uint32_t other : grid_.near(outline_of(shorter))) {
      if (other >= k) continue;
      const Segment& longer = strokes_[other].picture;
      const Vec3 axis = glm::normalize(longer.b - longer.a);
      const auto off = [&](Vec3 p) { return glm::length(glm::cross(axis, p - longer.a)); };
      if (off(shorter.a) > distance || off(shorter.b) > distance) continue;
      if (part_along(longer, shorter, distance)) parent[root(k)] = root(other);
    }
  }
  std::size_t runs = 0;
  for (std::uint32_t k = 0; k < parent.size(); ++k) runs += parent[k] == k;
  return runs;
}

}  // namespace spoctree
