// Convex outlines in a picture -> those near a place.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace spoctree {

/// A point, a segment, a triangle or a quadrangle.
struct PictureOutline {
  std::array<glm::dvec2, 4> corners{};
  std::uint32_t count = 0;
};

class PictureGrid {
 public:
  /// `pad`: outlines nearer than this to a place are found there. What lies farther than
  /// `half_width` from the picture's origin may be found anywhere at its rim.
  PictureGrid(const std::vector<PictureOutline>& outlines, double pad, double half_width);

  /// The outlines in the cells that `place` touches, a superset of those nearer than `pad`; each
  /// once, in no order. Not for several threads.
  const std::vector<std::uint32_t>& near(const PictureOutline& place);

 private:
  template <class Visit>
  void for_cells(const PictureOutline& outline, double pad, const Visit& visit) const;

  glm::dvec2 lower_{0.0};
  double cell_ = 1;
  std::uint32_t columns_ = 1;
  std::uint32_t rows_ = 1;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> stamp_;
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> found_;
};

}  // namespace spoctree
