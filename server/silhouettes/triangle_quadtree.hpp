// The hexagon as which a corner view shows the universe cube -> six triangles, each divided into
// four again and again (Ahuja and Veenstra, PAMI 1989, section II-C, figure 8).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "server/silhouettes/mask.hpp"

namespace spoctree {

/// The six quadtrees of one corner view.
///
/// Clockwise from the left one, the major triangles are 0 to 5; triangle p lies between spokes p
/// and p + 1 of the hexagon, spoke 0 pointing to the lower left, 2 upwards. A triangle's parts are
/// labelled 0 for the one in its middle, 2 for the one in its lower corner, and 1 and 3 so that 1,
/// 3, 2 go clockwise: 1 is the upper corner of a triangle that points to the right and the left one
/// of one that points to the left.
class TriangleQuadtrees {
 public:
  /// Divides triangles until neighbours' centres are no farther apart than two pixels' centres (in
  /// the direction in which these are nearer to each other); then each is black if the pixel
  /// nearest to its centre is. A triangle of one colour is not divided, and none more than ten
  /// times. O(pixels).
  explicit TriangleQuadtrees(const Mask& mask);

  using Triangle = std::uint32_t;
  Triangle root(int major) const { return roots_[static_cast<std::size_t>(major)]; }
  /// The part of a triangle; a triangle that is not divided is of the same colour everywhere.
  Triangle part(Triangle triangle, int label) const {
    const std::uint32_t first = triangles_[triangle].first_part;
    return first == 0 ? triangle : first + static_cast<std::uint32_t>(label);
  }
  /// How much of the triangle's area is black, 0 to 1.
  double black_share(Triangle triangle) const { return triangles_[triangle].black_share; }

 private:
  struct Node {
    float black_share = 0;
    std::uint32_t first_part = 0;  ///< of four; 0: not divided
  };
  struct Point {
    double right = 0;  ///< -1 to 1 over the picture
    double up = 0;
  };
  struct Corners {
    std::array<Point, 3> labelled;  ///< 1, 2, 3
    bool points_right = false;
  };

  Node build(const Mask& mask, const Corners& corners, int depth);
  static Corners part_corners(const Corners& corners, std::size_t label);

  int depth_ = 0;
  std::array<Triangle, 6> roots_{};
  std::vector<Node> triangles_;
};

/// The labels of a triangle's three corner parts where it is triangle p of a hexagon: in the
/// hexagon's centre, at the end of spoke p, and at that of spoke p + 1.
struct CornerLabels {
  int centre;
  int first;
  int second;
};
inline constexpr std::array<CornerLabels, 6> kCornerLabels{
    {{3, 2, 1}, {2, 1, 3}, {2, 1, 3}, {1, 3, 2}, {1, 3, 2}, {3, 2, 1}}};

}  // namespace spoctree
