// Planes that nearly meet in corners, as equations to be solved together -> planes that do.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "server/solid/fit_jointly.hpp"
#include "server/solid/flat_groups.hpp"

namespace spoctree {

/// The planes of some groups and the corners of these, of which no other group that may move has
/// any.
///
/// Gauss and Newton's method for the equations "corner lies on plane", each step the damped
/// least-norm solution. What is eliminated one by one decides how much is left to be factored
/// (sparse Cholesky). Planes of few corners are: what is left of them is that their corners lie in
/// some plane, a single unknown for four corners. Planes of many corners stay, with three unknowns
/// each, and their equations are eliminated corner by corner. Time grows like that of factoring the
/// graph of neighbouring groups.
class JointFitter {
 public:
  /// `number_of_vertex` is scratch, kNone for the corners concerned before and after.
  JointFitter(const FlatSurface& surface, const FlatGroups& groups,
              const std::vector<std::uint32_t>& members,
              std::vector<std::uint32_t>& number_of_vertex);

  /// Solves the equations; returns what speaks against the solution.
  std::vector<CornerConflict> solve(double most_move);
  /// Moves the planes and fills in the ways of the corners.
  void apply(FlatGroups& groups, JointFit& fit) const;

 private:
  // A plane that turns about two axes through its centre and shifts along its normal.
  struct MovablePlane {
    std::uint32_t group = 0;
    GridPoint centre{};
    double radius = 0;                // of the group around the centre
    std::array<double, 3> axis[2]{};  // of unit length, across the normal
    std::array<double, 3> turn{};     // added to the normal so far
    double shift = 0;                 // of the plane at the centre, so far
  };

  // "This corner lies on this plane."
  struct Equation {
    std::uint32_t plane = kNone;  // kNone: it is fixed
    std::uint32_t group = 0;
    std::array<double, 3> normal{};
    std::array<double, 3> arm{};    // from the plane's centre to the corner
    std::array<double, 3> lever{};  // by how much the plane rises at the corner by shift and turns
    double missing = 0;             // height of the plane above the corner before anything moves
    std::size_t weights = 0;        // of an eliminated plane: those in its combinations
  };

  // Combinations of a plane's equations out of which the plane drops, or in which it is soft: where
  // its corners are nearly on a line, turning it about that costs more than moving the corners. The
  // unknowns say how much each combination pulls.
  struct Elimination {
    std::vector<std::size_t> equations;  // of the plane; empty if it stays
    std::uint32_t pulls = 0;
    std::vector<double> softness;               // of each pull
    std::vector<std::array<double, 3>> yields;  // how each pull moves the plane
    Eigen::Matrix<double, 3, Eigen::Dynamic>
        rises_to;  // corners' heights -> the plane through them
  };

  // A corner's equations with planes that stay or are fixed come first.
  struct Corner {
    std::size_t first = 0;
    std::size_t first_eliminated = 0;
    std::size_t end = 0;
    Eigen::MatrixXd inverse;  // of the first equations' products of normals, damped
  };

  static MovablePlane movable_plane(const FlatSurface& surface, const FlatGroups& groups,
                                    std::uint32_t number);
  void collect_equations(const std::vector<std::uint32_t>& members);
  void eliminate_planes();
  void factor();
  double find_missing();
  void step();
  std::vector<CornerConflict> find_conflicts(double most_move, double most_missing) const;
  void move_plane(const MovablePlane& movable, GridPlane& plane) const;

  template <class Visit>
  void visit_pulls(const Corner& corner, Visit visit) const;

  const FlatSurface& surface_;
  const FlatGroups& groups_;
  std::vector<std::uint32_t> vertices_;      // the corners with equations
  std::vector<std::array<double, 3>> ways_;  // of these
  std::vector<MovablePlane> planes_;         // by group
  std::vector<Equation> equations_;          // those of a corner together
  std::vector<Corner> corners_;
  std::vector<double> missing_;               // of each equation now
  std::vector<Elimination> eliminations_;     // of each plane
  std::vector<std::uint32_t> first_unknown_;  // of each plane
  std::uint32_t unknowns_ = 0;
  std::vector<double> weights_;  // of equations in combinations
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> coupling_;
};

}  // namespace spoctree
