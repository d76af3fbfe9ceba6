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

// Planes of more corners stay: they leave more combinations than the three unknowns of a plane.
constexpr std::size_t kMostCornersEliminated = 6;
// A plane that moves so easily with its corners is taken to do so freely.
constexpr double kFree = 4;

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
  std::vector<std::uint32_t> count(planes_.size(), 0);
  corners_.reserve(vertices_.size());
  for (const std::uint32_t vertex : vertices_) {
    Corner made;
    made.first = equations_.size();
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
        ++count[equation.plane];
        const MovablePlane& plane = planes_[equation.plane];
        equation.arm = difference(corner, plane.centre);
        equation.lever = {1, -dot(equation.arm, plane.axis[0]) / plane.radius,
                          -dot(equation.arm, plane.axis[1]) / plane.radius};
      }
      equations_.push_back(equation);
    }
    made.end = equations_.size();
    corners_.push_back(std::move(made));
  }
  missing_.resize(equations_.size());

  eliminations_.resize(planes_.size());
  for (Corner& corner : corners_) {
    const auto begin = equations_.begin() + static_cast<std::ptrdiff_t>(corner.first);
    const auto end = equations_.begin() + static_cast<std::ptrdiff_t>(corner.end);
    const auto middle = std::stable_partition(begin, end, [&](const Equation& equation) {
      return equation.plane == kNone || count[equation.plane] > kMostCornersEliminated;
    });
    corner.first_eliminated = static_cast<std::size_t>(middle - equations_.begin());
    for (std::size_t i = corner.first_eliminated; i < corner.end; ++i) {
      eliminations_[equations_[i].plane].equations.push_back(i);
    }
  }
}

// The levers of a plane's k corners, U S V' with U square: the combinations in U's columns. In the
// first three the plane moves by V S^-1 of them, where its cost does not hold it back; in the
// others it does not occur.
void JointFitter::eliminate_planes() {
  first_unknown_.resize(planes_.size());
  unknowns_ = 0;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    first_unknown_[p] = unknowns_;
    Elimination& plane = eliminations_[p];
    if (plane.equations.empty()) {
      unknowns_ += 3;
      continue;
    }
    const auto k = static_cast<Eigen::Index>(plane.equations.size());
    Eigen::MatrixXd levers(k, 3);
    for (Eigen::Index i = 0; i < k; ++i) {
      const Vector& lever = equations_[plane.equations[static_cast<std::size_t>(i)]].lever;
      levers.row(i) << lever[0], lever[1], lever[2];
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(levers, Eigen::ComputeFullU | Eigen::ComputeFullV);
    plane.rises_to.setZero(3, k);
    std::vector<Eigen::Index> combinations;
    for (Eigen::Index i = 0; i < k; ++i) {
      const double s = i < 3 ? svd.singularValues()[i] : 0;
      if (s * s >= kFree * kPlaneCost) {
        plane.rises_to += svd.matrixV().col(i) * svd.matrixU().col(i).transpose() / s;
        continue;
      }
      combinations.push_back(i);
      plane.softness.push_back(s * s / kPlaneCost);
      Vector yields{};
      for (std::size_t j = 0; i < 3 && j < 3; ++j) {
        yields[j] = -s / kPlaneCost * svd.matrixV()(static_cast<Eigen::Index>(j), i);
      }
      plane.yields.push_back(yields);
    }
    plane.pulls = static_cast<std::uint32_t>(combinations.size());
    unknowns_ += plane.pulls;
    for (Eigen::Index i = 0; i < k; ++i) {
      equations_[plane.equations[static_cast<std::size_t>(i)]].weights = weights_.size();
      for (const Eigen::Index j : combinations) weights_.push_back(svd.matrixU()(i, j));
    }
  }
}

// Calls visit(unknown, equation, weight) for the pulls at a corner.
template <class Visit>
void JointFitter::visit_pulls(const Corner& corner, Visit visit) const {
  for (std::size_t i = corner.first_eliminated; i < corner.end; ++i) {
    const Equation& equation = equations_[i];
    for (std::uint32_t k = 0; k < eliminations_[equation.plane].pulls; ++k) {
      visit(first_unknown_[equation.plane] + k, equation, weights_[equation.weights + k]);
    }
  }
}

// A corner's way is N' y + g, N the normals of the planes that stay, g the pulls of the others
// along their normals, y = (N N' + damping)^-1 (missing + what the planes rise - N g). What is left
// is to move the planes so that the y pull at none of them, and to pull so that what is combined
// fits. The signs of the former are reversed: that makes the matrix symmetric, and quasi-definite,
// so that every order of elimination is as good.
void JointFitter::factor() {
  eliminate_planes();
  struct Part {
    std::uint32_t unknown;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of a pull
    std::size_t equation;  // of a plane that stays, and what it rises by
    double lever;
  };
  std::vector<Eigen::Triplet<double, std::uint32_t>> entries;
  const auto add = [&](std::uint32_t i, std::uint32_t j, double value) {
    entries.emplace_back(std::max(i, j), std::min(i, j), value);
  };
  std::vector<Part> pulls;
  std::vector<Part> levers;
  for (Corner& corner : corners_) {
    const auto n = static_cast<Eigen::Index>(corner.first_eliminated - corner.first);
    pulls.clear();
    levers.clear();
    visit_pulls(corner, [&](std::uint32_t unknown, const Equation& equation, double weight) {
      const Vector& normal = equation.normal;
      pulls.push_back({unknown, weight * Eigen::Vector3d(normal[0], normal[1], normal[2]), 0, 0});
    });
    Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
    Eigen::MatrixXd along;  // from what is missing to the corner's way
    if (n > 0) {
      Eigen::MatrixXd normals(n, 3);
      for (Eigen::Index i = 0; i < n; ++i) {
        const Equation& equation = equations_[corner.first + static_cast<std::size_t>(i)];
        normals.row(i) << equation.normal[0], equation.normal[1], equation.normal[2];
        if (equation.plane == kNone) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
          levers.push_back({first_unknown_[equation.plane] + k, Eigen::Vector3d::Zero(),
                            static_cast<std::size_t>(i), equation.lever[k]});
        }
      }
      Eigen::MatrixXd own = normals * normals.transpose();
      own.diagonal().array() += kDamping;
      corner.inverse = own.inverse();
      along = normals.transpose() * corner.inverse;
      free -= along * normals;
    }
    for (std::size_t i = 0; i < pulls.size(); ++i) {
      const Eigen::Vector3d pulled = free * pulls[i].direction;
      for (std::size_t j = 0; j <= i; ++j) {
        add(pulls[i].unknown, pulls[j].unknown, pulled.dot(pulls[j].direction));
      }
      for (const Part& lever : levers) {
        add(pulls[i].unknown, lever.unknown,
            lever.lever *
                pulls[i].direction.dot(along.col(static_cast<Eigen::Index>(lever.equation))));
      }
    }
    for (std::size_t i = 0; i < levers.size(); ++i) {
      for (std::size_t j = 0; j < levers.size(); ++j) {
        if (levers[j].unknown > levers[i].unknown) continue;  // once
        add(levers[i].unknown, levers[j].unknown,
            -levers[i].lever * levers[j].lever *
                corner.inverse(static_cast<Eigen::Index>(levers[i].equation),
                               static_cast<Eigen::Index>(levers[j].equation)));
      }
    }
  }
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    const std::uint32_t first = first_unknown_[p];
    if (eliminations_[p].equations.empty()) {
      for (std::uint32_t k = 0; k < 3; ++k) add(first + k, first + k, -kPlaneCost);
      continue;
    }
    for (std::uint32_t k = 0; k < eliminations_[p].pulls; ++k) {
      add(first + k, first + k, eliminations_[p].softness[k] + kDamping);
    }
  }
  SparseMatrix matrix(unknowns_, unknowns_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  coupling_.compute(matrix);  // from its lower half
}

// Exactly enough: what is computed in doubles are differences of the size of the ways.
double JointFitter::find_missing() {
  double most = 0;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    for (std::size_t i = corners_[c].first; i < corners_[c].end; ++i) {
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
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_));
  const auto count_of = [](const Corner& corner) {
    return static_cast<Eigen::Index>(corner.first_eliminated - corner.first);
  };
  const auto missing_of = [&](const Corner& corner) {
    return Eigen::Map<const Eigen::VectorXd>(missing_.data() + corner.first, count_of(corner));
  };
  for (const Corner& corner : corners_) {
    Vector way{};
    if (count_of(corner) > 0) {
      const Eigen::VectorXd y = corner.inverse * missing_of(corner);
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        const Equation& equation = equations_[corner.first + static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < 3; ++k) way[k] += y[i] * equation.normal[k];
        if (equation.plane == kNone) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
          pull[first_unknown_[equation.plane] + k] += equation.lever[k] * y[i];
        }
      }
    }
    visit_pulls(corner, [&](std::uint32_t unknown, const Equation& equation, double weight) {
      const auto i = static_cast<std::size_t>(&equation - equations_.data());
      pull[unknown] += weight * (missing_[i] - dot(equation.normal, way));
    });
  }
  const Eigen::VectorXd motion = coupling_.solve(pull);
  std::vector<double> risen = missing_;  // by how far corners come up to planes, and down again
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const Corner& corner = corners_[c];
    Vector way{};
    visit_pulls(corner, [&](std::uint32_t unknown, const Equation& equation, double weight) {
      for (std::size_t k = 0; k < 3; ++k) way[k] += motion[unknown] * weight * equation.normal[k];
    });
    if (count_of(corner) > 0) {
      Eigen::VectorXd missing = missing_of(corner);
      for (Eigen::Index i = 0; i < missing.size(); ++i) {
        const Equation& equation = equations_[corner.first + static_cast<std::size_t>(i)];
        missing[i] -= dot(equation.normal, way);
        if (equation.plane == kNone) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
          missing[i] += equation.lever[k] * motion[first_unknown_[equation.plane] + k];
        }
      }
      const Eigen::VectorXd y = corner.inverse * missing;
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        const Vector& normal = equations_[corner.first + static_cast<std::size_t>(i)].normal;
        for (std::size_t k = 0; k < 3; ++k) way[k] += y[i] * normal[k];
      }
    }
    for (std::size_t i = corner.first_eliminated; i < corner.end; ++i) {
      risen[i] = dot(equations_[i].normal, way) - missing_[i];
    }
    for (std::size_t k = 0; k < 3; ++k) ways_[c][k] += way[k];
  }
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    MovablePlane& plane = planes_[p];
    const Elimination& eliminated = eliminations_[p];
    const std::uint32_t first = first_unknown_[p];
    Vector moved{};
    if (eliminated.equations.empty()) {
      for (std::uint32_t k = 0; k < 3; ++k) moved[k] = motion[first + k];
    }
    for (std::size_t i = 0; i < eliminated.equations.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        moved[k] +=
            eliminated.rises_to(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) *
            risen[eliminated.equations[i]];
      }
    }
    for (std::uint32_t j = 0; j < eliminated.pulls; ++j) {
      for (std::size_t k = 0; k < 3; ++k) moved[k] += eliminated.yields[j][k] * motion[first + j];
    }
    plane.shift += moved[0];
    for (std::size_t i = 0; i < 3; ++i) {
      plane.turn[i] += (moved[1] * plane.axis[0][i] + moved[2] * plane.axis[1][i]) / plane.radius;
    }
  }
}

// The longest ways first, and of those with a group in common only one.
std::vector<CornerConflict> JointFitter::find_conflicts(double most_move,
                                                        double most_missing) const {
  std::vector<std::pair<double, std::size_t>> corners;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const double way = std::sqrt(dot(ways_[c], ways_[c]));
    double missing = 0;
    for (std::size_t i = corners_[c].first; i < corners_[c].end; ++i) {
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
    for (std::size_t i = corners_[c].first; i < corners_[c].end; ++i) {
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
  for (std::size_t c = 0; c < corners_.size(); ++c) fit.ways[vertices_[c]] = ways_[c];
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
