// A closed mesh and a view -> which parts of its edges are seen, without any notion of a tree, a
// piece or a covered region.
//
// A point of an edge is seen if on one of the edge's two sides in the picture, however near to the
// edge, no triangle lies strictly in front of it. Along the edge, each triangle is in front over
// one interval for each side; its ends are roots of linear functions whose signs are exact, so that
// edges that lie on each other in the picture and faces seen edge-on are nothing special. For
// closed meshes that is the visibility of the solid's edges: a line of sight that begins in
// material leaves it through some triangle.
#pragma once

#include <utility>
#include <vector>

#include "tests/support/judge_view.hpp"
#include "tests/support/plain_mesh.hpp"

namespace spoctree {

struct SeenEdgesOptions {
  /// Faces that differ from one plane by less than this have no edge between them (fractions of
  /// the diagonal).
  double flat = 1e-12;
  /// Those that differ by more than this have one; in between, a drawing may show it or not.
  double bent = 1e-9;
  /// Edges at which two faces turn by less are none, unless one of the faces faces the viewer and
  /// the other does not.
  double crease_angle_deg = 0;
};

struct SeenEdge {
  Vec3 a{0.0};
  Vec3 b{0.0};
  bool is_doubtful = false;
  /// The parts a + t (b - a) that are in the view's window and seen, and those hidden there: pairs
  /// of t, ascending, disjoint.
  std::vector<std::pair<double, double>> visible;
  std::vector<std::pair<double, double>> hidden;
};

/// The edges between faces of different planes; edges that are points in the picture are left out.
/// Faces of any number of corners, flat or nearly so, nowhere through each other. About
/// O(n sqrt(n)) for surfaces.
std::vector<SeenEdge> seen_edges(const PlainMesh& mesh, const JudgeView& view,
                                 const SeenEdgesOptions& options = {});

/// How far the faces at each edge are from one plane, as `flat` and `bent` ask; for two faces only.
std::vector<double> edge_bends(const PlainMesh& mesh);

}  // namespace spoctree
