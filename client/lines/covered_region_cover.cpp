// How polygons get into the covered region.
#include <algorithm>
#include <cmath>

#include "client/lines/covered_region.hpp"

namespace spoctree {

namespace {

/// Partitions are not made deeper than this: what would need more stays uncovered, so the worst a
/// hostile tree can get is a line too many. Pictures of solids stay below 100.
constexpr std::size_t kDeepestPartition = 800;

/// From here on more is done to keep partitions balanced.
constexpr std::size_t kDeepPath = 40;

/// Where an outline is smaller than this fraction of the uncovered space around it, or has more
/// edges than this there, the space is halved first: that keeps partitions balanced.
constexpr double kSmallOutline = 0.3;
constexpr std::size_t kManyEdges = 8;

}  // namespace

void CoveredRegion::cover(std::span<const Vec2> polygon) {
  corners_.clear();
  for (const Vec2 at : polygon) {
    if (corners_.empty() || glm::distance(corners_.back().at, at) > tolerance_) {
      corners_.push_back({at, static_cast<std::int32_t>(corners_.size())});
    }
  }
  while (corners_.size() > 1 &&
         glm::distance(corners_.back().at, corners_.front().at) <= tolerance_) {
    corners_.pop_back();
  }
  if (corners_.size() < 3) return;
  Rectangle box{corners_[0].at, corners_[0].at};
  for (const Corner& corner : corners_) {
    box.lower = glm::min(box.lower, corner.at);
    box.upper = glm::max(box.upper, corner.at);
  }
  if (is_full(box)) return;
  edges_.clear();
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Vec2 from = corners_[k].at;
    const Vec2 along = corners_[k + 1 == corners_.size() ? 0 : k + 1].at - from;
    const Vec2 normal = Vec2{-along.y, along.x} / glm::length(along);
    edges_.push_back({normal, glm::dot(normal, from)});
  }
  cover_tiles(tiles_touched(box), {0, corners_.size()});
}

void CoveredRegion::split(Polygon polygon, const Line& line, Polygon& negative, Polygon& positive) {
  negative = positive = {};
  bool any_negative = false;
  bool any_positive = false;
  distances_.resize(polygon.count + 1);
  for (std::size_t k = 0; k < polygon.count; ++k) {
    const double distance = line(corners_[polygon.first + k].at);
    any_negative |= distance < -tolerance_;
    any_positive |= distance > tolerance_;
    distances_[k] = distance;
  }
  distances_[polygon.count] = distances_[0];
  if (any_negative != any_positive) {
    for (std::size_t k = 0; k < polygon.count; ++k) {
      if (std::abs(distances_[k]) <= tolerance_ && std::abs(distances_[k + 1]) <= tolerance_) {
        corners_[polygon.first + k].edge = kNoEdge;
      }
    }
    (any_negative ? negative : positive) = polygon;
    return;
  }
  if (!any_negative) return;  // all on the line: nothing that could cover
  for (const double sign : {-1.0, 1.0}) {
    Polygon& part = sign < 0 ? negative : positive;
    part.first = corners_.size();
    for (std::size_t k = 0; k < polygon.count; ++k) {
      const Corner corner = corners_[polygon.first + k];
      const double here = sign * distances_[k];
      const double there = sign * distances_[k + 1];
      if (here > tolerance_ || (here >= -tolerance_ && there > tolerance_)) {
        corners_.push_back(corner);
      } else if (here >= -tolerance_) {
        corners_.push_back({corner.at, kNoEdge});
      }
      if ((here > tolerance_ && there < -tolerance_) ||
          (here < -tolerance_ && there > tolerance_)) {
        const Vec2 next = corners_[polygon.first + (k + 1 == polygon.count ? 0 : k + 1)].at;
        const Vec2 at = corner.at + (next - corner.at) * (here / (here - there));
        corners_.push_back({at, here > 0 ? kNoEdge : corner.edge});
      }
    }
    part.count = corners_.size() - part.first;
  }
}

void CoveredRegion::cover_tiles(const Tiles& tiles, Polygon polygon) {
  if (polygon.count < 3) return;
  const std::uint32_t width = tiles.upper[0] - tiles.lower[0];
  const std::uint32_t height = tiles.upper[1] - tiles.lower[1];
  if (width == 1 && height == 1) {
    cover_tile(tiles.lower[0], tiles.lower[1], polygon);
    return;
  }
  const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(polygon.first);
  if (std::all_of(first, first + static_cast<std::ptrdiff_t>(polygon.count),
                  [](const Corner& corner) { return corner.edge == kNoEdge; })) {
    mark_full(tiles);
    return;
  }
  const int axis = width >= height ? 0 : 1;
  const std::uint32_t middle = (tiles.lower[axis] + tiles.upper[axis]) / 2;
  const std::size_t mark = corners_.size();
  Polygon negative;
  Polygon positive;
  split(polygon, boundary(axis, middle), negative, positive);
  Tiles half = tiles;
  half.upper[axis] = middle;
  cover_tiles(half, negative);
  half = tiles;
  half.lower[axis] = middle;
  cover_tiles(half, positive);
  corners_.resize(mark);
}

void CoveredRegion::cover_tile(std::uint32_t column, std::uint32_t row, Polygon polygon) {
  Child& root = roots_[std::size_t{row} * tiles_per_side_ + column];
  if (root == kCovered) return;
  // The tile's sides are where the path begins. Edges along them must not split it.
  path_ = {{boundary(0, column), 1},
           {boundary(0, column + 1), -1},
           {boundary(1, row), 1},
           {boundary(1, row + 1), -1}};
  for (const HalfPlane& side : path_) {
    for (std::size_t k = 0; k < polygon.count; ++k) {
      Corner& corner = corners_[polygon.first + k];
      const Corner& next = corners_[polygon.first + (k + 1 == polygon.count ? 0 : k + 1)];
      if (std::abs(side.line(corner.at)) <= tolerance_ &&
          std::abs(side.line(next.at)) <= tolerance_) {
        corner.edge = kNoEdge;
      }
    }
  }
  root = cover_node(root, polygon);
  if (root == kCovered) mark_full({{column, row}, {column + 1, row + 1}});
}

CoveredRegion::Child CoveredRegion::cover_node(Child child, Polygon polygon) {
  if (child == kCovered || polygon.count < 3) return child;
  if (child == kUncovered) return cover_leaf(polygon);
  const auto index = static_cast<std::size_t>(child);
  const Line line = nodes_[index].line;
  const std::size_t mark = corners_.size();
  Polygon negative;
  Polygon positive;
  split(polygon, line, negative, positive);
  path_.push_back({line, -1});
  const Child below = cover_node(nodes_[index].negative, negative);
  path_.back().sign = 1;
  const Child above = cover_node(nodes_[index].positive, positive);
  path_.pop_back();
  corners_.resize(mark);
  if (below == kCovered && above == kCovered) {
    free_nodes_.push_back(child);
    return kCovered;
  }
  nodes_[index].negative = below;
  nodes_[index].positive = above;
  return child;
}

CoveredRegion::Child CoveredRegion::cover_leaf(Polygon polygon) {
  if (path_.size() > kDeepestPartition) return kUncovered;
  Rectangle box{corners_[polygon.first].at, corners_[polygon.first].at};
  std::size_t edge_count = 0;
  for (std::size_t k = 0; k < polygon.count; ++k) {
    const Corner& corner = corners_[polygon.first + k];
    box.lower = glm::min(box.lower, corner.at);
    box.upper = glm::max(box.upper, corner.at);
    if (corner.edge != kNoEdge) ++edge_count;
  }
  if (edge_count == 0) return kCovered;
  const Vec2 size = box.upper - box.lower;
  const bool is_deep = path_.size() > kDeepPath;
  const double largest = std::max(size.x, size.y);
  if (is_deep || largest < kSmallOutline * tile_size_ || edge_count > kManyEdges) {
    const Rectangle extent = extent_of_leaf();
    const Vec2 space = extent.upper - extent.lower;
    // Deep down, across the direction in which the outline is smallest: that helps with needles.
    int axis = space.x >= space.y ? 0 : 1;
    if (is_deep) axis = size.x * space.y <= size.y * space.x ? 0 : 1;
    const double fill = is_deep ? size[axis] : largest;
    if ((fill < kSmallOutline * space[axis] || edge_count > kManyEdges) &&
        space[axis] > 64 * tolerance_) {
      Line middle;
      middle.normal[axis] = 1;
      middle.offset = 0.5 * (extent.lower[axis] + extent.upper[axis]);
      return cover_node(new_node(middle), polygon);
    }
  }
  Child inside = kCovered;
  for (std::size_t k = 0; k < polygon.count; ++k) {
    const std::int32_t edge = corners_[polygon.first + k].edge;
    if (edge == kNoEdge) continue;
    const Child node = new_node(edges_[static_cast<std::size_t>(edge)]);
    nodes_[static_cast<std::size_t>(node)].positive = inside;
    inside = node;
  }
  return inside;
}

Rectangle CoveredRegion::extent_of_leaf() {
  // The tile, cut by what lies on the way down; the first four half-planes are its sides.
  region_.assign(1, {path_[0].line.offset, path_[2].line.offset});
  region_.push_back({path_[1].line.offset, path_[2].line.offset});
  region_.push_back({path_[1].line.offset, path_[3].line.offset});
  region_.push_back({path_[0].line.offset, path_[3].line.offset});
  for (std::size_t k = 4; k < path_.size(); ++k) {
    cut_region_.clear();
    for (std::size_t i = 0; i < region_.size(); ++i) {
      const Vec2 a = region_[i];
      const Vec2 b = region_[i + 1 == region_.size() ? 0 : i + 1];
      const double at_a = path_[k].sign * path_[k].line(a);
      const double at_b = path_[k].sign * path_[k].line(b);
      if (at_a >= 0) cut_region_.push_back(a);
      if ((at_a < 0) != (at_b < 0)) cut_region_.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    std::swap(region_, cut_region_);
  }
  Rectangle extent;
  if (region_.empty()) return extent;
  extent = {region_.front(), region_.front()};
  for (const Vec2 corner : region_) {
    extent.lower = glm::min(extent.lower, corner);
    extent.upper = glm::max(extent.upper, corner);
  }
  return extent;
}

CoveredRegion::Child CoveredRegion::new_node(const Line& line) {
  Child child;
  if (free_nodes_.empty()) {
    child = static_cast<Child>(nodes_.size());
    nodes_.emplace_back();
  } else {
    child = free_nodes_.back();
    free_nodes_.pop_back();
  }
  nodes_[static_cast<std::size_t>(child)] = {line, kUncovered, kUncovered};
  return child;
}

}  // namespace spoctree
