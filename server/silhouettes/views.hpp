// The thirteen directions in which a universe cube is seen -> where a point of the cube is in the
// picture (Ahuja and Veenstra, PAMI 1989, section II).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spoctree {

enum class ViewKind : std::uint8_t { Face, Edge, Corner };

/// One of the thirteen orthographic views. All vectors are sums of axes.
///
/// A view's picture is the rectangle that just contains the cube's silhouette, stretched to any
/// number of pixels: of a cube with side S, a face view's is S by S, an edge view's sqrt(2) S wide
/// and S high, a corner view's sqrt(2) S wide and sqrt(8/3) S high.
struct View {
  std::string_view name;  ///< such as "face-x", "edge-37", "corner-7"
  ViewKind kind = ViewKind::Face;
  glm::ivec3 towards_viewer{0};
  glm::ivec3 right{0};  ///< in the picture
  glm::ivec3 up{0};     ///< in the picture
  int right_reach =
      1;             ///< the largest right . p in the cube [-1, 1]^3, at the picture's right side
  int up_reach = 1;  ///< the same for up

  /// Where p of the cube [-1, 1]^3 is: 0 to 1 from left to right.
  double across(const glm::dvec3& p) const { return 0.5 + 0.5 * along(right, p) / right_reach; }
  /// Where p of the cube [-1, 1]^3 is: 0 to 1 from top to bottom.
  double down(const glm::dvec3& p) const { return 0.5 - 0.5 * along(up, p) / up_reach; }

 private:
  static double along(const glm::ivec3& axis, const glm::dvec3& p) {
    return axis.x * p.x + axis.y * p.y + axis.z * p.z;
  }
};

inline constexpr std::size_t kViewCount = 13;

/// The size of a view's picture in which pixels are as large as those of a face view with `size`
/// by `size` pixels, rounded to whole pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};
PictureSize size_with_square_pixels(const View& view, int size);

/// All views: faces x, y, z as seen in the paper's figures 3 and 4; edges named by the two octants
/// that meet in the edge nearest to the viewer, the edge upright in the picture (figure 6);
/// corners named by the octant nearest to the viewer, z upwards (figure 8).
std::span<const View, kViewCount> all_views();

/// The view of that name; nullptr if there is none.
const View* find_view(std::string_view name);

/// Indices in all_views() of a list such as "face", "all", "corner,face" or "face-x,edge-37", in
/// the order of the list. Throws UsageError for a word that is no view and for a view named twice.
std::vector<std::size_t> parse_views(std::string_view list);

/// The octant's centre seen from that of its parent: its bits x + 2y + 4z as -1 (lower) and +1.
inline glm::ivec3 towards_octant(int octant) {
  return {(octant & 1) * 2 - 1, (octant >> 1 & 1) * 2 - 1, (octant >> 2 & 1) * 2 - 1};
}

inline int dot(const glm::ivec3& a, const glm::ivec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace spoctree
