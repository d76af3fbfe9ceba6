// A cell with planes and what is material between them -> the corners of that material.
//
// The corners are the points of the planes' arrangement in the cube: where an edge of the cube
// meets a plane, a face two, the inside three. No polyhedron is made. On a line whose two ends are
// known to lie on different sides of a plane there is one point of that plane; with respect to the
// planes that do not separate the ends it lies where they do. So almost all signs follow from
// others, and those that do not are found exactly.
//
// How often a point is a corner of the material is the alternating sum over the sectors of its
// three planes: minus once per plane that the sector is outside of, if the sector is material.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/corner_sum.hpp"
#include "client/rebuild/material_table.hpp"
#include "common/base/plain_vector.hpp"
#include "common/tree/node_address.hpp"

namespace spoctree {

/// How often the boundary has a corner in each corner of a cube (by one bit per axis), if its walls
/// are taken in the order of the axes: see CornerCount.
using CubeCorners = std::array<std::int32_t, 8>;

/// Those of a cube full of material.
inline constexpr CubeCorners kFullCube = {-1, 1, 1, -1, 1, -1, -1, 1};

/// Finds corners cell by cell. Holds working memory: use one per thread.
class CellCorners {
 public:
  CellCorners(const Octree& tree, const Carriers& carriers)
      : planes_(tree.plane_set()), carriers_(carriers) {
    points_.resize_unset(kMostPoints);
    found_.resize_unset(kMostPoints + kMostInside + 1);
  }

  /// The corners of the material in a cell, those in corners of the cube as `cube`, others added to
  /// `sum`. The material is, of the region inside all planes of `bounds`, that part that a node of
  /// this kind takes (GREY: all inside its planes). If anything
  /// of the region is in the cell, the first `near_bounds` of the bounds bound it. False, and
  /// nothing is added, if the cell is not for this: planes that meet where they need not (four in a
  /// point, or one in a corner of the cube), or too many planes.
  /// O(the points of the arrangement).
  bool find(const NodeAddress& cell, NodeKind kind, std::span<const std::uint32_t> planes,
            std::span<const std::uint32_t> expression, std::span<const std::uint32_t> bounds,
            std::size_t near_bounds, CubeCorners& cube, CornerSum& sum);

 private:
  /// Cells with more planes are left to others.
  static constexpr unsigned kMaxPlanes = 14;
  static_assert(kMaxPlanes % 2 == 0);
  /// On the edges and on the faces of the cube, and inside.
  static constexpr unsigned kMostPoints = 12 * kMaxPlanes + 6 * (kMaxPlanes * (kMaxPlanes - 1) / 2);
  static constexpr unsigned kMostInside = kMaxPlanes * (kMaxPlanes - 1) * (kMaxPlanes - 2) / 6;

  struct Point {
    Sides sides;   ///< of the planes that do not meet here; 0 for those that do
    double error;  ///< bound for all values
    /// Pairs of them, so there may be a meaningless one behind the last plane's.
    double values[kMaxPlanes];
  };
  /// Where a line enters the cube and where it leaves, as numbers of points.
  struct Ends {
    std::uint32_t entry;
    std::uint32_t exit;
  };
  struct Found {
    std::uint32_t planes[3];
    std::int32_t count;
  };
  static constexpr signed char kUnknownSign = 2;
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);

  bool take_planes(NodeKind kind, std::span<const std::uint32_t> planes,
                   std::span<const std::uint32_t> expression,
                   std::span<const std::uint32_t> bounds);
  void take_walls(const NodeAddress& cell);
  bool find_sides_of_cube();
  void drop_far_bounds(unsigned near, std::size_t own);
  bool find_on_edges();
  bool find_on_faces();
  bool find_inside();
  Sides interpolate(const Point& from, const Point& to, unsigned k, Point& point) const;
  bool cross(const Point& from, const Point& to, unsigned k, PlaneRef on, PlaneRef also_on,
             Point& point) const;
  std::optional<int> sum_inside(const Point& from, const Point& to, unsigned k, unsigned l,
                                unsigned m, MaterialTable::SidesSet counts);
  int side_inside(unsigned k, unsigned l, unsigned m, bool is_positive, unsigned j);
  void put_end(Ends& ends, bool is_exit, std::uint32_t point) const;

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, int count) {
    found_[found_count_] = {{a, b, c}, count};
    found_count_ += count != 0 ? 1 : 0;
  }

  const PlaneSet planes_;
  const Carriers& carriers_;
  // Of the cell at hand; the node's own planes come first.
  unsigned count_ = 0;
  PlaneRef refs_[kMaxPlanes];
  Plane coefficients_[kMaxPlanes];
  std::uint32_t numbers_[kMaxPlanes];
  MaterialTable material_;
  PlaneRef walls_[6];  // lower and upper by axis, outwards
  std::uint32_t wall_numbers_[6];
  double at_[6];
  double longest_ = 0;  ///< no two points of the cell have values that differ by more
  Point corners_[8];
  PlainVector<Point> points_;  // room for all: an array
  unsigned point_count_ = 0;
  Ends on_face_[6][kMaxPlanes];          // the line of a face and a plane
  Ends inside_[kMaxPlanes][kMaxPlanes];  // the line of two planes, the first one first
  PlainVector<Found> found_;             // likewise, and for one more
  unsigned found_count_ = 0;
  /// Signs of determinants of four planes, by the set of the four; kUnknownSign if not asked for.
  signed char signs_[kMaxPlanes * (kMaxPlanes - 1) * (kMaxPlanes - 2) * (kMaxPlanes - 3) / 24];
};

}  // namespace spoctree
