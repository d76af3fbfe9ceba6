#include "server/solid/joint_fitter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace spoctree {

namespace {

using Vector = std::array<double, 3>;
using SparseMatrix = Eigen::SparseMatrix<double>;

// Corners of more groups are left to the caller: each couples all its groups with each other.
constexpr std::size_t kMostGroupsOfCorner = 16;

// Added to the diagonal of the equations of a corner: what can only be fulfilled by moving the
// corner more than about 10^4 times as far as planes are apart is fulfilled slowly, step by step.
constexpr double kDamping = 1e-8;

// What moving a plane costs, beside moving the corners on it.
constexpr double kPlaneCost = 1e-2;

constexpr int kMostSteps = 10;
// From here on, steps do not change anything that rounding to the grid leaves.
constexpr double kFulfilled = 0x1p-55;
// After all steps, equations have to be fulfilled to this.
constexpr double kNearlyFulfilled = 0.75 * 0x1p-49;
// After this step, ways are known well enough to see which are too long.
constexpr int kTellingStep = 2;
// What is not fulfilled then to this fraction of the longest way never will be.
constexpr double kTellingFraction = 0x1p-6;

double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Vector difference(const GridPoint& p, const GridPoint& q) {
  return {static_cast<double>(p[0] - q[0]) * 0x1p-52, static_cast<double>(p[1] - q[1]) * 0x1p-52,
          static_cast<double>(p[2] - q[2]) * 0x1p-52};
}

Vector normal_of(const GridPlane& plane) { return difference(plane.normal, {0, 0, 0}); }

// Of the plane above the point, in units of 2^-104.
Int128 height_above(const GridPlane& plane, const GridPoint& point) {
  return (static_cast<Int128>(plane.offset) << kGridBits) - plane.height(point);
}

}  // namespace

JointFitter::MovablePlane JointFitter::movable_plane(const FlatSurface& surface,
                                                     const FlatGroups& groups,
                                                     std::uint32_t number) {
  const FlatGroup& group = groups.groups[number];
  MovablePlane plane;
  plane.group = number;
  const GridPoint base = surface.points[surface.triangles[group.triangles.front()][0]];
  Vector lower{};
  Vector upper{};
  for (const std::uint32_t t : group.triangles) {
    for (const std::uint32_t v : surface.triangles[t]) {
      const Vector d = difference(surface.points[v], base);
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = std::min(lower[i], d[i]);
        upper[i] = std::max(upper[i], d[i]);
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    plane.centre[i] = base[i] + std::llrint(0.5 * (lower[i] + upper[i]) * 0x1p52);
  }
  const Vector size = {upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]};
  plane.radius = 0.5 * std::sqrt(dot(size, size));
  const Vector normal = normal_of(group.plane);
  Vector across{};
  across[static_cast<std::size_t>(
      std::min_element(normal.begin(), normal.end(),
                       [](double p, double q) { return std::abs(p) < std::abs(q); }) -
      normal.begin())] = 1;
  plane.axis[0] = cross(normal, across);
  const double length = std::sqrt(dot(plane.axis[0], plane.axis[0]));
  for (double& x : plane.axis[0]) x /= length;
  plane.axis[1] = cross(normal, plane.axis[0]);
  return plane;
}

JointFitter::JointFitter(const FlatSurface& surface, const FlatGroups& groups,
                         const std::vector<std::uint32_t>& members,
                         std::vector<std::uint32_t>& number_of_vertex)
    : surface_(surface), groups_(groups) {
  for (const std::uint32_t g : members) {
    planes_.push_back(movable_plane(surface, groups, g));
    for (const std::uint32_t t : groups.groups[g].triangles) {
      for (const std::uint32_t v : surface.triangles[t]) {
        if (number_of_vertex[v] != kNone) continue;
        number_of_vertex[v] = 0;
        vertices_.push_back(v);
      }
    }
  }
  for (const std::uint32_t v : vertices_) number_of_vertex[v] = kNone;
  ways_.assign(vertices_.size(), Vector{});
  collect_equations(members);
}

void JointFitter::collect_equations(const std::vector<std::uint32_t>& members) {
  std::vector<std::uint32_t> around;
  begin_.assign(1, 0);
  for (const std::uint32_t vertex : vertices_) {
    collect_groups_around(surface_, groups_, vertex, around);
    if (around.size() > kMostGroupsOfCorner) around.clear();
    const GridPoint& corner = surface_.points[vertex];
    for (const std::uint32_t g : around) {
      Equation equation;
      equation.group = g;
      equation.normal = normal_of(groups_.groups[g].plane);
      equation.missing =
          static_cast<double>(height_above(groups_.groups[g].plane, corner)) * 0x1p-104;
      const auto member = std::lower_bound(members.begin(), members.end(), g);
      if (member != members.end() && *member == g) {
        equation.plane = static_cast<std::uint32_t>(member - members.begin());
        const MovablePlane& plane = planes_[equation.plane];
        equation.arm = difference(corner, plane.centre);
        equation.lever = {1, -dot(equation.arm, plane.axis[0]) / plane.radius,
                          -dot(equation.arm, plane.axis[1]) / plane.radius};
      }
      equations_.push_back(equation);
    }
    begin_.push_back(equations_.size());
  }
  missing_.resize(equations_.size());
}

// A corner's way is N' y, N its planes' normals and y = (N N' + damping)^-1 (missing + what its
// planes rise); what is left is to move the planes so that the y pull at none of them.
void JointFitter::factor() {
  inverses_.resize(corner_count());
  for (std::size_t c = 0; c < corner_count(); ++c) {
    const Eigen::Index n = count_of(c);
    Eigen::MatrixXd normals(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vector& normal = equations_[begin_[c] + static_cast<std::size_t>(i)].normal;
      normals.row(i) << normal[0], normal[1], normal[2];
    }
    Eigen::MatrixXd own = normals * normals.transpose();
    own.diagonal().array() += kDamping;
    inverses_[c] = own.inverse();
  }
  std::vector<Eigen::Triplet<double, std::uint32_t>> entries;
  for (std::size_t c = 0; c < corner_count(); ++c) {
    for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      for (std::size_t j = begin_[c]; j <= i; ++j) {
        const Equation& p = equations_[i];
        const Equation& q = equations_[j];
        if (p.plane == kNone || q.plane == kNone) continue;
        const double factor = inverses_[c](static_cast<Eigen::Index>(i - begin_[c]),
                                           static_cast<Eigen::Index>(j - begin_[c]));
        for (std::uint32_t k = 0; k < 3; ++k) {
          for (std::uint32_t l = 0; l < 3; ++l) {
            entries.emplace_back(3 * p.plane + k, 3 * q.plane + l,
                                 p.lever[k] * factor * q.lever[l]);
          }
        }
      }
    }
  }
  const auto size = static_cast<std::uint32_t>(3 * planes_.size());
  for (std::uint32_t i = 0; i < size; ++i) entries.emplace_back(i, i, kPlaneCost);
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  coupling_.compute(matrix);  // from its lower half
}

// Exactly enough: what is computed in doubles are differences of the size of the ways.
double JointFitter::find_missing() {
  double most = 0;
  for (std::size_t c = 0; c < corner_count(); ++c) {
    for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      const Equation& equation = equations_[i];
      missing_[i] = equation.missing - dot(equation.normal, ways_[c]);
      if (equation.plane != kNone) {
        const MovablePlane& plane = planes_[equation.plane];
        missing_[i] += plane.shift - dot(plane.turn, equation.arm) - dot(plane.turn, ways_[c]);
      }
      most = std::max(most, std::abs(missing_[i]));
    }
  }
  return most;
}

void JointFitter::step() {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * planes_.size()));
  const auto missing_of = [&](std::size_t c) {
    return Eigen::Map<const Eigen::VectorXd>(missing_.data() + begin_[c], count_of(c));
  };
  for (std::size_t c = 0; c < corner_count(); ++c) {
    const Eigen::VectorXd y = inverses_[c] * missing_of(c);
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const Equation& equation = equations_[begin_[c] + static_cast<std::size_t>(i)];
      if (equation.plane == kNone) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        pull[3 * equation.plane + k] -= equation.lever[k] * y[i];
      }
    }
  }
  const Eigen::VectorXd motion = coupling_.solve(pull);
  for (std::size_t c = 0; c < corner_count(); ++c) {
    Eigen::VectorXd missing = missing_of(c);
    for (Eigen::Index i = 0; i < missing.size(); ++i) {
      const Equation& equation = equations_[begin_[c] + static_cast<std::size_t>(i)];
      if (equation.plane == kNone) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        missing[i] += equation.lever[k] * motion[3 * equation.plane + k];
      }
    }
    const Eigen::VectorXd y = inverses_[c] * missing;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const Vector& normal = equations_[begin_[c] + static_cast<std::size_t>(i)].normal;
      for (std::size_t k = 0; k < 3; ++k) ways_[c][k] += y[i] * normal[k];
    }
  }
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    MovablePlane& plane = planes_[p];
    const auto at = static_cast<Eigen::Index>(3 * p);
    plane.shift += motion[at];
    for (std::size_t i = 0; i < 3; ++i) {
      plane.turn[i] +=
          (motion[at + 1] * plane.axis[0][i] + motion[at + 2] * plane.axis[1][i]) / plane.radius;
    }
  }
}

// The longest ways first, and of those with a group in common only one.
std::vector<CornerConflict> JointFitter::find_conflicts(double most_move,
                                                        double most_missing) const {
  std::vector<std::pair<double, std::size_t>> corners;
  for (std::size_t c = 0; c < corner_count(); ++c) {
    const double way = std::sqrt(dot(ways_[c], ways_[c]));
    double missing = 0;
    for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      missing = std::max(missing, std::abs(missing_[i]));
    }
    if (!(way < most_move) || missing > most_missing) corners.emplace_back(-way, c);
  }
  std::sort(corners.begin(), corners.end());
  std::vector<CornerConflict> conflicts;
  std::vector<std::uint32_t> reduced;
  for (const auto& [way, c] : corners) {
    bool can_wait = false;
    std::uint32_t smallest = kNone;
    for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      const std::uint32_t g = equations_[i].group;
      can_wait = can_wait || std::find(reduced.begin(), reduced.end(), g) != reduced.end();
      if (smallest == kNone || groups_.groups[g].area < groups_.groups[smallest].area) smallest = g;
    }
    if (can_wait || smallest == kNone) continue;
    reduced.push_back(smallest);
    conflicts.push_back({vertices_[c], smallest});
  }
  return conflicts;
}

std::vector<CornerConflict> JointFitter::solve(double most_move) {
  factor();
  double missing_before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kMostSteps; ++k) {
    const double missing = find_missing();
    if (missing < kFulfilled || (missing < kNearlyFulfilled && 2 * missing > missing_before)) break;
    missing_before = missing;
    if (k == kTellingStep) {
      auto conflicts = find_conflicts(most_move, kTellingFraction * most_move);
      if (!conflicts.empty()) return conflicts;
    }
    step();
  }
  find_missing();
  return find_conflicts(most_move, kNearlyFulfilled);
}

void JointFitter::apply(FlatGroups& groups, JointFit& fit) const {
  for (const MovablePlane& plane : planes_) move_plane(plane, groups.groups[plane.group].plane);
  for (std::size_t c = 0; c < corner_count(); ++c) fit.ways[vertices_[c]] = ways_[c];
}

void JointFitter::move_plane(const MovablePlane& movable, GridPlane& plane) const {
  long double normal[3];
  long double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    normal[i] = static_cast<long double>(plane.normal[i]) * 0x1p-52L + movable.turn[i];
    squared += normal[i] * normal[i];
  }
  const long double rise =
      (static_cast<long double>(height_above(plane, movable.centre)) * 0x1p-104L + movable.shift) /
      std::sqrt(squared);
  plane.normal = round_direction(normal[0], normal[1], normal[2]);
  // Through the right point over the centre, so that the rounded normal errs least at the rim.
  const Int128 height = plane.height(movable.centre) + static_cast<Int128>(rise * 0x1p104L);
  plane.offset = std::llrint(static_cast<long double>(height) * 0x1p-52L);
}

}  // namespace spoctree
