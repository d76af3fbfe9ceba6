#include "server/silhouettes/views.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

glm::ivec3 cross(const glm::ivec3& a, const glm::ivec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

int reach(const glm::ivec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

View make_view(std::string_view name, ViewKind kind, const glm::ivec3& viewer, glm::ivec3 up) {
  View view;
  view.name = name;
  view.kind = kind;
  view.towards_viewer = viewer;
  view.right = cross(up, viewer);
  if (kind == ViewKind::Corner) up = 3 * up - dot(up, viewer) * viewer;  // across the line of sight
  view.up = up;
  view.right_reach = reach(view.right);
  view.up_reach = reach(view.up);
  return view;
}

constexpr ViewKind kFace = ViewKind::Face;
constexpr ViewKind kEdge = ViewKind::Edge;
constexpr ViewKind kCorner = ViewKind::Corner;

const std::array<View, kViewCount> kViews{
    make_view("face-x", kFace, {1, 0, 0}, {0, 0, 1}),
    make_view("face-y", kFace, {0, 1, 0}, {0, 0, 1}),
    make_view("face-z", kFace, {0, 0, 1}, {-1, 0, 0}),
    make_view("edge-37", kEdge, {1, 1, 0}, {0, 0, 1}),
    make_view("edge-15", kEdge, {1, -1, 0}, {0, 0, 1}),
    make_view("edge-57", kEdge, {1, 0, 1}, {0, 1, 0}),
    make_view("edge-46", kEdge, {-1, 0, 1}, {0, 1, 0}),
    make_view("edge-67", kEdge, {0, 1, 1}, {1, 0, 0}),
    make_view("edge-45", kEdge, {0, -1, 1}, {1, 0, 0}),
    make_view("corner-7", kCorner, {1, 1, 1}, {0, 0, 1}),
    make_view("corner-6", kCorner, {-1, 1, 1}, {0, 0, 1}),
    make_view("corner-5", kCorner, {1, -1, 1}, {0, 0, 1}),
    make_view("corner-4", kCorner, {-1, -1, 1}, {0, 0, 1}),
};

bool is_in_group(const View& view, std::string_view word) {
  switch (view.kind) {
    case ViewKind::Face:
      return word == "all" || word == "face";
    case ViewKind::Edge:
      return word == "all" || word == "edge";
    case ViewKind::Corner:
      return word == "all" || word == "corner";
  }
  return false;
}

}  // namespace

std::span<const View, kViewCount> all_views() { return kViews; }

const View* find_view(std::string_view name) {
  const auto found = std::find_if(kViews.begin(), kViews.end(),
                                  [&](const View& view) { return view.name == name; });
  return found == kViews.end() ? nullptr : &*found;
}

PictureSize size_with_square_pixels(const View& view, int size) {
  // The cube's reach along a sum of axes, in sides: |right|_1 / |right|_2.
  const auto pixels = [size](const glm::ivec3& axis) {
    return static_cast<int>(std::lround(size * reach(axis) / std::sqrt(dot(axis, axis))));
  };
  return {pixels(view.right), pixels(view.up)};
}

std::vector<std::size_t> parse_views(std::string_view list) {
  std::vector<std::size_t> views;
  while (true) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view word = list.substr(0, comma);
    bool is_view = false;
    for (std::size_t i = 0; i < kViewCount; ++i) {
      if (kViews[i].name != word && !is_in_group(kViews[i], word)) continue;
      is_view = true;
      if (std::find(views.begin(), views.end(), i) != views.end())
        throw UsageError("view " + std::string(kViews[i].name) + " is named twice");
      views.push_back(i);
    }
    if (!is_view) {
      std::string names;
      for (const View& view : kViews) names += ", " + std::string(view.name);
      throw UsageError("no view is called '" + std::string(word) +
                       "'; there are all, face, edge, corner" + names);
    }
    if (comma == list.size()) return views;
    list.remove_prefix(comma + 1);
  }
}

}  // namespace spoctree
