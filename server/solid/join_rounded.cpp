#include "server/solid/join_rounded.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <map>
#include <queue>
#include <unordered_set>

#include "server/solid/fit_plane.hpp"

namespace spoctree {

namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;

// What is no longer than this many units across, and so many times longer, may have its normal
// from rounding.
constexpr double kSliverHeight = 1.5;
constexpr double kSliverAspect = 8;

// Other faces have to face the same way, within 60 degrees.
constexpr double kSmallestCosine = 0.5;

// The variance of a number that was rounded to multiples of 1.
constexpr double kVariance = 1.0 / 12;

// Beyond the limit by so much, a pair is bent without looking closer.
constexpr double kSurelyBent = 1.1;

// Wider along an axis than this (units), what is rounded may have been at an angle to it.
constexpr double kFlatToAxis = 1.01;

// Where joining saves less than one face in so many, the surface stays as it was.
constexpr std::size_t kLeastGain = 64;

// Planes that are looked at for being one differ less than this in each component of their normals,
// and where they are apart, by less than so many units.
constexpr double kNormalCell = 1.0 / 16;
constexpr double kFarthestShared = 8;

/// The value that chi-squared of so many degrees of freedom exceeds with a chance of about 0.1 %
/// (Wilson and Hilferty 1931).
double largest_chi_squared(double degrees) {
  constexpr double kDeviations = 3;
  const double spread = 2 / (9 * degrees);
  const double root = 1 - spread + kDeviations * std::sqrt(spread);
  return degrees * root * root * root;
}

/// Sums over points.
struct Moments {
  double count = 0;
  Vector sum = Vector::Zero();
  Matrix squares = Matrix::Zero();

  void add(const Vector& p) {
    ++count;
    sum += p;
    squares += p * p.transpose();
  }
  Moments& operator+=(const Moments& other) {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
  Moments& operator-=(const Moments& other) {
    count -= other.count;
    sum -= other.sum;
    squares -= other.squares;
    return *this;
  }
  double degrees_of_freedom() const { return std::max(0.0, count - 3); }
};

/// A plane of least squares.
struct Fit {
  Vector middle;
  Vector normal;
  double chi_squared = 0;  ///< of distances from it, if points were rounded to multiples of 1
};

Fit fit_to(const Moments& moments) {
  const auto count = static_cast<Real>(moments.count);
  Fit fit;
  fit.middle = moments.sum / count;
  const Matrix about_middle = moments.squares - moments.sum * fit.middle.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(about_middle);
  fit.normal = solver.eigenvectors().col(0);
  if (moments.count > 3) {
    fit.chi_squared = std::max(0.0, static_cast<double>(solver.eigenvalues()[0]) / kVariance);
  }
  return fit;
}

/// Triangles that are to be in one plane. Points are in units of the rounding.
struct Cluster {
  Moments corners;  // each once
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> triangles;
  Vector lower = Vector::Zero();
  Vector upper = Vector::Zero();
  std::array<double, 3> area{};  // vector, universe units
  double chi_squared = 0;
  bool is_sliver = false;
  std::uint32_t patch = kNone;  // the one that it begins as
  std::uint32_t version = 0;    // new whenever it grows, no other has the same

  bool has(std::uint32_t vertex) const {
    if (vertices.size() > kMostSearched) return index.contains(vertex);
    return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
  }
  void add(std::uint32_t vertex) {
    vertices.push_back(vertex);
    if (vertices.size() == kMostSearched + 1) index.insert(vertices.begin(), vertices.end());
    if (vertices.size() > kMostSearched) index.insert(vertex);
  }

 private:
  static constexpr std::size_t kMostSearched = 16;
  std::unordered_set<std::uint32_t> index;  // of the vertices, where these are more
};

class Joiner {
 public:
  Joiner(const FlatSurface& surface, const FlatTolerance& tolerance);
  bool run(std::vector<PlanarPatch>& patches);

 private:
  struct Pair {
    double cost;
    std::uint32_t triangle;
    std::uint32_t edge;
    std::uint32_t version;        // of the triangle's cluster
    std::uint32_t other_version;  // of that beyond the edge
    bool operator>(const Pair& other) const {
      if (cost != other.cost) return cost > other.cost;
      if (triangle != other.triangle) return triangle > other.triangle;
      return edge > other.edge;
    }
  };

  Vector scaled(std::uint32_t vertex) const;
  void begin_clusters(const std::vector<PlanarPatch>& patches);
  void add_triangle(Cluster& cluster, std::uint32_t number, std::uint32_t triangle);
  bool is_sliver(std::uint32_t triangle) const;
  bool are_bent(const Cluster& a, const Cluster& b) const;
  double cost_of(std::uint32_t a, std::uint32_t b) const;
  void push(std::uint32_t triangle, std::uint32_t edge);
  void push_all();
  bool join_all();
  std::vector<std::uint32_t> join(std::uint32_t a, std::uint32_t b);
  void share_planes();
  PlanarPatch to_patch(const Cluster& cluster) const;

  const FlatSurface& surface_;
  std::array<Real, 3> per_unit_;
  std::array<bool, 3> is_rounded_;
  std::vector<Cluster> clusters_;
  std::vector<std::uint32_t> cluster_of_;  // triangles
  std::uint32_t next_version_ = 0;
  std::size_t joined_ = 0;  // clusters that went into others
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue_;
};

Joiner::Joiner(const FlatSurface& surface, const FlatTolerance& tolerance)
    : surface_(surface), cluster_of_(surface.triangles.size(), kNone) {
  for (std::size_t i = 0; i < 3; ++i) {
    // Along an axis without rounding, the tolerance stands for it.
    const double least = tolerance.spread / std::sqrt(3.0);
    is_rounded_[i] = tolerance.rounding[i] > least;
    per_unit_[i] = 0x1p-52L / static_cast<Real>(std::max(tolerance.rounding[i], least));
  }
}

Vector Joiner::scaled(std::uint32_t vertex) const {
  const GridPoint& p = surface_.points[vertex];
  return {static_cast<Real>(p[0]) * per_unit_[0], static_cast<Real>(p[1]) * per_unit_[1],
          static_cast<Real>(p[2]) * per_unit_[2]};
}

bool Joiner::is_sliver(std::uint32_t triangle) const {
  const Corners& c = surface_.triangles[triangle];
  const Vector p[] = {scaled(c[0]), scaled(c[1]), scaled(c[2])};
  const Real longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  const Real height = (p[1] - p[0]).cross(p[2] - p[0]).norm() / longest;
  return height <= kSliverHeight && height * kSliverAspect < longest;
}

void Joiner::add_triangle(Cluster& cluster, std::uint32_t number, std::uint32_t triangle) {
  const Corners& c = surface_.triangles[triangle];
  for (const std::uint32_t v : c) {
    if (cluster.has(v)) continue;
    const Vector p = scaled(v);
    if (cluster.vertices.empty()) cluster.lower = cluster.upper = p;
    cluster.lower = cluster.lower.cwiseMin(p);
    cluster.upper = cluster.upper.cwiseMax(p);
    cluster.corners.add(p);
    cluster.add(v);
  }
  cluster_of_[triangle] = number;
  cluster.triangles.push_back(triangle);
  const AreaVector area =
      area_vector(surface_.points[c[0]], surface_.points[c[1]], surface_.points[c[2]]);
  for (std::size_t i = 0; i < 3; ++i) cluster.area[i] += static_cast<double>(area[i]) * 0x1p-105;
}

void Joiner::begin_clusters(const std::vector<PlanarPatch>& patches) {
  clusters_.resize(patches.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    for (const std::uint32_t t : patches[p].triangles) add_triangle(clusters_[p], p, t);
    clusters_[p].patch = p;
    clusters_[p].chi_squared = fit_to(clusters_[p].corners).chi_squared;
  }
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
    if (cluster_of_[t] != kNone) continue;
    const auto number = static_cast<std::uint32_t>(clusters_.size());
    clusters_.emplace_back();
    add_triangle(clusters_.back(), number, t);
    clusters_.back().is_sliver = is_sliver(t);
  }
  for (Cluster& cluster : clusters_) cluster.version = next_version_++;
}

// For two triangles that share an edge: four corners c, whose distances from their plane of least
// squares are as volume / area_c, where the areas are of the triangles that leave out one of them.
// Most pairs of a curved surface are told apart by this.
bool Joiner::are_bent(const Cluster& a, const Cluster& b) const {
  std::uint32_t other = kNone;
  for (const std::uint32_t v : b.vertices) {
    if (!a.has(v)) other = v;
  }
  if (other == kNone) return false;
  using Double = Eigen::Vector3d;
  const Vector base = scaled(a.vertices[0]);
  const Double p = (scaled(a.vertices[1]) - base).cast<double>();
  const Double q = (scaled(a.vertices[2]) - base).cast<double>();
  const Double r = (scaled(other) - base).cast<double>();
  const Double pq = p.cross(q);
  const Double qr = q.cross(r);
  const Double rp = r.cross(p);
  const double volume = pq.dot(r);
  const double areas =
      pq.squaredNorm() + qr.squaredNorm() + rp.squaredNorm() + (pq + qr + rp).squaredNorm();
  return volume * volume > kSurelyBent * kVariance * largest_chi_squared(1) * areas;
}

// How much less likely rounding explains both together than each alone; infinite if it does not.
double Joiner::cost_of(std::uint32_t a, std::uint32_t b) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (clusters_[a].vertices.size() < clusters_[b].vertices.size()) std::swap(a, b);
  const Cluster& large = clusters_[a];
  const Cluster& small = clusters_[b];
  const auto dot = [](const std::array<double, 3>& p, const std::array<double, 3>& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  if (!large.is_sliver && !small.is_sliver &&
      dot(large.area, small.area) <
          kSmallestCosine * std::sqrt(dot(large.area, large.area) * dot(small.area, small.area))) {
    return kNever;
  }
  if (large.vertices.size() == 3 && small.vertices.size() == 3 && are_bent(large, small)) {
    return kNever;
  }
  const Vector size = large.upper.cwiseMax(small.upper) - large.lower.cwiseMin(small.lower);
  for (int i = 0; i < 3; ++i) {
    if (is_rounded_[static_cast<std::size_t>(i)] && size[i] <= kFlatToAxis) return kNever;
  }
  Moments both = large.corners;
  both += small.corners;
  // Counting shared corners twice makes no more than twice of the sum.
  if (0.5 * fit_to(both).chi_squared > largest_chi_squared(both.degrees_of_freedom())) {
    return kNever;
  }
  std::vector<std::uint32_t> added;
  for (const std::uint32_t v : small.vertices) {
    if (large.has(v)) {
      Moments shared;
      shared.add(scaled(v));
      both -= shared;
    } else {
      added.push_back(v);
    }
  }
  const Fit fit = fit_to(both);
  const double degrees = both.degrees_of_freedom();
  const double added_degrees = std::max(
      1.0, degrees - large.corners.degrees_of_freedom() - small.corners.degrees_of_freedom());
  const double added_chi_squared =
      std::max(0.0, fit.chi_squared - large.chi_squared - small.chi_squared);
  if (degrees > 0 && fit.chi_squared > largest_chi_squared(degrees)) return kNever;
  if (added_chi_squared > largest_chi_squared(added_degrees)) return kNever;
  const Real most_height = kRoundingSlack * 0.5L * (fit.normal.cwiseAbs().sum());
  for (const std::uint32_t v : added) {
    const Real height = (scaled(v) - fit.middle).dot(fit.normal);
    if (std::abs(height) > most_height) return kNever;
  }
  return added_chi_squared / added_degrees;
}

void Joiner::push(std::uint32_t triangle, std::uint32_t edge) {
  const std::uint32_t a = cluster_of_[triangle];
  const std::uint32_t b = cluster_of_[surface_.neighbours[triangle][edge]];
  if (a == b) return;
  const double cost = cost_of(a, b);
  if (cost < std::numeric_limits<double>::infinity()) {
    queue_.push({cost, triangle, edge, clusters_[a].version, clusters_[b].version});
  }
}

void Joiner::push_all() {
  for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      if (t < surface_.neighbours[t][e]) push(t, e);
    }
  }
}

// The triangles of the smaller one go into the larger one, which keeps its number; returns them.
std::vector<std::uint32_t> Joiner::join(std::uint32_t a, std::uint32_t b) {
  if (clusters_[a].vertices.size() < clusters_[b].vertices.size()) std::swap(a, b);
  Cluster& large = clusters_[a];
  Cluster small = std::move(clusters_[b]);
  clusters_[b] = {};
  for (const std::uint32_t t : small.triangles) add_triangle(large, a, t);
  large.chi_squared = fit_to(large.corners).chi_squared;
  large.is_sliver = false;
  large.patch = kNone;
  large.version = next_version_++;
  ++joined_;
  return std::move(small.triangles);
}

// False if there was nothing to join.
bool Joiner::join_all() {
  bool has_joined = false;
  while (!queue_.empty()) {
    const Pair pair = queue_.top();
    queue_.pop();
    const std::uint32_t a = cluster_of_[pair.triangle];
    const std::uint32_t b = cluster_of_[surface_.neighbours[pair.triangle][pair.edge]];
    if (a == b) continue;
    // One of them has grown since: what the pair costs now decides when it is its turn.
    if (pair.version != clusters_[a].version || pair.other_version != clusters_[b].version) {
      push(pair.triangle, pair.edge);
      continue;
    }
    const std::vector<std::uint32_t> joined = join(a, b);
    for (const std::uint32_t t : joined) {
      for (std::uint32_t e = 0; e < 3; ++e) push(t, e);
    }
    has_joined = true;
  }
  return has_joined;
}

// Clusters in one plane that do not touch each other: larger ones first.
void Joiner::share_planes() {
  using Cell = std::array<int, 3>;
  std::vector<std::uint32_t> order;
  for (std::uint32_t c = 0; c < clusters_.size(); ++c) {
    if (clusters_[c].triangles.size() > 1) order.push_back(c);
  }
  const auto squared_area = [&](std::uint32_t c) {
    const auto& area = clusters_[c].area;
    return area[0] * area[0] + area[1] * area[1] + area[2] * area[2];
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return squared_area(a) > squared_area(b);
  });
  std::map<Cell, std::vector<std::uint32_t>> by_normal;
  for (const std::uint32_t c : order) {
    const double length = std::sqrt(squared_area(c));
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i) {
      cell[i] = static_cast<int>(std::floor(clusters_[c].area[i] / length / kNormalCell));
    }
    std::uint32_t* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const Vector middle = clusters_[c].corners.sum / clusters_[c].corners.count;
    for (int k = 0; k < 27; ++k) {
      const auto found =
          by_normal.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
      if (found == by_normal.end()) continue;
      for (std::uint32_t& other : found->second) {
        const Fit fit = fit_to(clusters_[other].corners);
        if (std::abs((middle - fit.middle).dot(fit.normal)) > kFarthestShared) continue;
        const double cost = cost_of(other, c);
        if (cost < least) {
          least = cost;
          best = &other;
        }
      }
    }
    if (best == nullptr) {
      by_normal[cell].push_back(c);
    } else {
      join(*best, c);
      if (clusters_[*best].triangles.empty()) *best = c;
    }
  }
}

PlanarPatch Joiner::to_patch(const Cluster& cluster) const {
  const Fit fit = fit_to(cluster.corners);
  PlanarPatch patch;
  patch.is_exact = false;
  patch.triangles = cluster.triangles;
  std::array<Real, 3> normal{};
  Real along_area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    normal[i] = fit.normal[static_cast<int>(i)] * per_unit_[i];
    along_area += normal[i] * static_cast<Real>(cluster.area[i]);
  }
  const Real sign = along_area < 0 ? -1 : 1;
  patch.plane.normal = round_direction(sign * normal[0], sign * normal[1], sign * normal[2]);
  GridPoint middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    middle[i] = std::llrint(fit.middle[static_cast<int>(i)] / per_unit_[i]);
  }
  patch.plane.offset = std::llrint(static_cast<Real>(patch.plane.height(middle)) * 0x1p-52L);
  for (const std::uint32_t v : cluster.vertices) {
    patch.range.add(patch.plane.height(surface_.points[v]));
  }
  patch.area = std::sqrt(cluster.area[0] * cluster.area[0] + cluster.area[1] * cluster.area[1] +
                         cluster.area[2] * cluster.area[2]);
  return patch;
}

bool Joiner::run(std::vector<PlanarPatch>& patches) {
  begin_clusters(patches);
  // What was refused may fit when the plane beside it is better known.
  do {
    push_all();
  } while (join_all());
  share_planes();
  if (joined_ * kLeastGain < clusters_.size()) return false;
  std::vector<PlanarPatch> joined;
  for (const Cluster& cluster : clusters_) {
    if (cluster.patch != kNone) {
      joined.push_back(std::move(patches[cluster.patch]));
    } else if (cluster.triangles.size() > 1) {
      joined.push_back(to_patch(cluster));
    }
  }
  patches = std::move(joined);
  return true;
}

}  // namespace

bool join_rounded(std::vector<PlanarPatch>& patches, const FlatSurface& surface,
                  const FlatTolerance& tolerance) {
  return Joiner(surface, tolerance).run(patches);
}

}  // namespace spoctree
