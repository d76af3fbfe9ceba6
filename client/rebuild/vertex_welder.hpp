// Points -> vertices: points that differ by less than the tolerance become one vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// Gives points of the universe cube numbers; a point nearer than the tolerance to a vertex is that
/// vertex (the nearest one), otherwise it is a new one. A hash table over a grid far coarser than
/// the tolerance: one look-up per point as a rule.
class VertexWelder {
 public:
  /// `tolerance` in universe units, below 2^-21.
  explicit VertexWelder(double tolerance);

  std::uint32_t weld(Vec3 point);
  /// The same for many; faster, because it does not wait for each of them.
  void weld(std::span<const Vec3> points, std::vector<std::uint32_t>& ids);

  /// Gives a vertex a better position; points near the old one still become this vertex.
  void move(std::uint32_t vertex, Vec3 point);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  double tolerance() const { return tolerance_; }

 private:
  struct Slot {
    Vec3 point{0.0};
    std::uint32_t id = kEmpty;
  };
  static constexpr std::uint32_t kEmpty = static_cast<std::uint32_t>(-1);

  std::size_t slot_of(const std::int64_t (&cell)[3]) const;
  std::uint32_t find_in_cell(const std::int64_t (&cell)[3], Vec3 point, double& best) const;
  void insert(Vec3 point, std::uint32_t id);
  void place(Vec3 point, std::uint32_t id);
  void grow();

  double tolerance_;
  std::vector<Slot> slots_;  // a power of two, at most half filled
  std::size_t filled_ = 0;
  std::vector<Vec3> vertices_;
};

}  // namespace spoctree
