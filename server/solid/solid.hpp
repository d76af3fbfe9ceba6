// The solid a tree is built from: triangles on the grid of its universe cube, grouped into plane
// facets. Incidence (which vertex lies on which plane) is knowledge here, not a computed number.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/geometry/plane.hpp"
#include "common/geometry/universe.hpp"
#include "server/mesh/precision.hpp"

namespace spoctree {

/// A triangle, counter-clockwise seen from outside. Edge i runs from vertex[i] to vertex[i + 1].
struct SolidTriangle {
  std::uint32_t vertex[3];
  std::uint32_t neighbour[3];  ///< the triangle across edge i
  std::uint32_t facet;
};

/// What counted as flat, and why.
struct FlatToleranceTaken {
  double fraction = 0;     ///< of the diagonal of the bounding box
  double spread = 0;       ///< the same in model units; corners of a face lie between two parallel
                           ///< planes so far apart
  bool was_given = false;  ///< by ImportOptions
  /// What the file's coordinates along each axis were rounded to, in model units, where that tells
  /// more than `spread`; 0 else. Then faces are also what was one before rounding, whose corners
  /// lie up to `rounded_spread` apart.
  glm::dvec3 rounding{};
  double rounded_spread = 0;  ///< model units, for the direction in which it is largest
  Precision precision;        ///< of the file, for which they are taken to be rounded

  bool is_by_rounding() const { return rounded_spread > 0; }
};

/// What import found and did, for the summary of `build`.
struct SolidReport {
  std::size_t input_faces = 0;
  std::size_t triangulated_faces = 0;  ///< polygons with more than three corners
  std::size_t uneven_faces = 0;        ///< those of them that are not flat, but for rounding
  double largest_unevenness = 0;  ///< of those, the largest distance of a corner from the polygon's
                                  ///< mean plane, as a fraction of the bounding box's diagonal
  bool was_turned = false;        ///< all faces pointed inwards and were reversed
  std::size_t turned_shells = 0;  ///< reversed because of how they nest
  std::size_t merged_points = 0;     ///< because the grid could not tell them from others
  std::vector<std::string> settled;  ///< what the grid could not tell apart: settle_on_grid
  std::size_t planes_before_merging = 0;  ///< distinct planes with flat tolerance 0
  double largest_move = 0;  ///< of a corner onto the planes of merged faces, model units
  FlatToleranceTaken flat_tolerance;
};

/// A closed, oriented, 2-manifold, not self-intersecting polyhedral solid (possibly of several
/// shells). All coordinates are universe coordinates on the grid.
struct Solid {
  Universe universe;
  std::vector<Vec3> vertices;
  std::vector<SolidTriangle> triangles;
  /// A facet is a connected set of triangles in one plane; several facets may share it. Its
  /// triangles' corners are within rounding to the grid of the plane, see largest_incidence_gap.
  std::vector<std::uint32_t> facet_plane;         ///< index in `planes`
  std::vector<std::uint32_t> facet_vertex_begin;  ///< facets + 1 offsets into facet_vertices
  std::vector<std::uint32_t> facet_vertices;      ///< sorted per facet
  /// Every vertex of a facet satisfies normal . v <= offset exactly: offsets are rounded outwards.
  std::vector<Plane> planes;
  /// No vertex is farther than this inside a plane of a facet it belongs to (universe units).
  double largest_incidence_gap = 0;
  double volume = 0;  ///< model units
  SolidReport report;

  std::size_t facet_count() const { return facet_plane.size(); }
  std::span<const std::uint32_t> vertices_of_facet(std::uint32_t facet) const {
    return {facet_vertices.data() + facet_vertex_begin[facet],
            facet_vertex_begin[facet + 1] - facet_vertex_begin[facet]};
  }
};

}  // namespace spoctree
