#include "client/rebuild/vertex_welder.hpp"

#include <glm/geometric.hpp>

#include "client/rebuild/flat_index.hpp"

namespace spoctree {

namespace {

/// The cells of the hash grid have side 2^-kCellBits.
constexpr int kCellBits = 20;

/// Counts from -2, so that truncation rounds down.
std::int64_t cell_coordinate(double x) {
  return static_cast<std::int64_t>((x + 2.0) * static_cast<double>(1 << kCellBits));
}

}  // namespace

VertexWelder::VertexWelder(double tolerance) : tolerance_(tolerance), slots_(1024) {}

std::size_t VertexWelder::slot_of(const std::int64_t (&cell)[3]) const {
  std::uint64_t key = 0;
  for (const std::int64_t coordinate : cell) {
    key = (key << 22) ^ static_cast<std::uint64_t>(coordinate);
  }
  return mix_bits(key) & (slots_.size() - 1);
}

std::uint32_t VertexWelder::find_in_cell(const std::int64_t (&cell)[3], Vec3 point,
                                         double& best) const {
  std::uint32_t found = kEmpty;
  for (std::size_t i = slot_of(cell); slots_[i].id != kEmpty; i = (i + 1) & (slots_.size() - 1)) {
    const Vec3 difference = slots_[i].point - point;
    const double squared = glm::dot(difference, difference);
    if (squared < best) {
      best = squared;
      found = slots_[i].id;
    }
  }
  return found;
}

std::uint32_t VertexWelder::weld(Vec3 point) {
  std::int64_t lower[3];
  std::int64_t upper[3];
  std::int64_t own[3];
  bool on_border = false;
  for (int i = 0; i < 3; ++i) {
    own[i] = cell_coordinate(point[i]);
    lower[i] = cell_coordinate(point[i] - tolerance_);
    upper[i] = cell_coordinate(point[i] + tolerance_);
    on_border |= lower[i] != upper[i];
  }
  double best = tolerance_ * tolerance_;
  std::uint32_t found = kEmpty;
  if (!on_border) {
    found = find_in_cell(own, point, best);
  } else {
    for (std::int64_t x = lower[0]; x <= upper[0]; ++x) {
      for (std::int64_t y = lower[1]; y <= upper[1]; ++y) {
        for (std::int64_t z = lower[2]; z <= upper[2]; ++z) {
          const std::uint32_t nearer = find_in_cell({x, y, z}, point, best);
          if (nearer != kEmpty) found = nearer;
        }
      }
    }
  }
  if (found != kEmpty) return found;
  const auto id = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back(point);
  insert(point, id);
  return id;
}

void VertexWelder::weld(std::span<const Vec3> points, std::vector<std::uint32_t>& ids) {
  constexpr std::size_t kAhead = 8;
  ids.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i + kAhead < points.size()) {
      const Vec3 point = points[i + kAhead];
      __builtin_prefetch(&slots_[slot_of(
          {cell_coordinate(point.x), cell_coordinate(point.y), cell_coordinate(point.z)})]);
    }
    ids[i] = weld(points[i]);
  }
}

void VertexWelder::move(std::uint32_t vertex, Vec3 point) {
  const Vec3 step = point - vertices_[vertex];
  vertices_[vertex] = point;
  // A small step leaves the vertex within reach of its old entry.
  if (glm::dot(step, step) > 1e-6 * tolerance_ * tolerance_) insert(point, vertex);
}

void VertexWelder::insert(Vec3 point, std::uint32_t id) {
  if (2 * ++filled_ > slots_.size()) grow();
  place(point, id);
}

void VertexWelder::place(Vec3 point, std::uint32_t id) {
  std::size_t i =
      slot_of({cell_coordinate(point.x), cell_coordinate(point.y), cell_coordinate(point.z)});
  while (slots_[i].id != kEmpty) i = (i + 1) & (slots_.size() - 1);
  slots_[i] = {point, id};
}

void VertexWelder::grow() {
  std::vector<Slot> old(2 * slots_.size());
  old.swap(slots_);
  for (const Slot& slot : old) {
    if (slot.id != kEmpty) place(slot.point, slot.id);
  }
}

}  // namespace spoctree
