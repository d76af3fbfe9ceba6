#include "client/rebuild/cell_corners.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "client/rebuild/double_pair.hpp"
#include "common/geometry/predicates.hpp"

namespace spoctree {

namespace {

/// Bound of the rounding of a plane's value in a corner of a cell (polyhedron_clipper.cpp derives
/// it), and of what `cross` rounds.
constexpr double kRounding = 0x1p-49;

/// Of a point about whose values nothing is known.
constexpr double kUnknown = 1e300;

template <class Visit>
bool for_each_bit(std::uint32_t bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) {
    if (!visit(static_cast<unsigned>(std::countr_zero(bits)))) return false;
  }
  return true;
}

constexpr std::uint32_t bit(unsigned k) { return std::uint32_t{1} << k; }

}  // namespace

bool CellCorners::find(const NodeAddress& cell, NodeKind kind,
                       std::span<const std::uint32_t> planes,
                       std::span<const std::uint32_t> expression,
                       std::span<const std::uint32_t> bounds, std::size_t near_bounds,
                       CubeCorners& cube, CornerSum& sum) {
  if (!take_planes(kind, planes, expression, bounds)) return false;
  take_walls(cell);
  found_count_ = 0;
  point_count_ = 0;
  if (!find_sides_of_cube()) return false;
  if (near_bounds < bounds.size()) {
    drop_far_bounds(static_cast<unsigned>(planes.size() + near_bounds), planes.size());
  }
  if (!find_on_edges() || !find_on_faces() || !find_inside()) return false;
  for (unsigned i = 0; i < found_count_; ++i) {
    const Found& found = found_[i];
    sum.add(found.planes[0], found.planes[1], found.planes[2], found.count);
  }
  for (unsigned i = 0; i < 8; ++i) {
    cube[i] = material_.is_material(corners_[i].sides) ? kFullCube[i] : 0;
  }
  return true;
}

bool CellCorners::take_planes(NodeKind kind, std::span<const std::uint32_t> planes,
                              std::span<const std::uint32_t> expression,
                              std::span<const std::uint32_t> bounds) {
  if (planes.size() + bounds.size() > kMaxPlanes) return false;
  if (!material_.take(kind, static_cast<unsigned>(planes.size()), expression)) return false;
  count_ = 0;
  const auto take = [&](std::uint32_t plane) {
    refs_[count_] = PlaneRef::of_table(plane);
    coefficients_[count_] = planes_[refs_[count_]];
    numbers_[count_] = carriers_.number_of(refs_[count_]);
    ++count_;
  };
  for (const std::uint32_t plane : planes) take(plane);
  for (const std::uint32_t plane : bounds) take(plane);
  return true;
}

void CellCorners::take_walls(const NodeAddress& cell) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t lower = cell.lower[axis];
    const std::uint32_t upper = lower + cell.size();
    walls_[2 * axis] = PlaneRef::of_wall(axis, lower).flipped();
    walls_[2 * axis + 1] = PlaneRef::of_wall(axis, upper);
    at_[2 * axis] = wall_coordinate(planes_.half_side(), lower);
    at_[2 * axis + 1] = wall_coordinate(planes_.half_side(), upper);
  }
  longest_ = 1.75 * (at_[1] - at_[0]);  // along a diagonal
  for (int i = 0; i < 6; ++i) wall_numbers_[i] = carriers_.number_of(walls_[i]);
}

bool CellCorners::find_sides_of_cube() {
  for (Point& corner : corners_) {
    corner.sides = 0;
    corner.error = kRounding;
    if (count_ % 2 != 0) corner.values[count_] = 0;
  }
  for (unsigned k = 0; k < count_; ++k) {
    const Plane& plane = coefficients_[k];
    const double x[2] = {plane.normal.x * at_[0], plane.normal.x * at_[1]};
    const double y[2] = {plane.normal.y * at_[2], plane.normal.y * at_[3]};
    const double z[2] = {plane.normal.z * at_[4], plane.normal.z * at_[5]};
    for (unsigned i = 0; i < 8; ++i) {
      const double value = x[i & 1] + y[(i >> 1) & 1] + z[i >> 2] - plane.offset;
      corners_[i].values[k] = value;
      bool is_outside = value > 0;
      if (std::abs(value) <= kRounding) {
        const int side =
            side_of_point(plane, Vec3{at_[i & 1], at_[2 + ((i >> 1) & 1)], at_[4 + (i >> 2)]});
        if (side == 0) return false;
        is_outside = side > 0;
      }
      corners_[i].sides |= static_cast<Sides>(is_outside) << k;
    }
  }
  return true;
}

/// A corner of the cube inside all bounds is proof that something of the region is in the cell.
void CellCorners::drop_far_bounds(unsigned near, std::size_t own) {
  const Sides bounds = ~(bit(static_cast<unsigned>(own)) - 1);
  if (std::all_of(corners_, corners_ + 8,
                  [&](const Point& corner) { return (corner.sides & bounds) != 0; })) {
    return;
  }
  count_ = near;
  for (Point& corner : corners_) corner.sides &= bit(near) - 1;
}

/// Where the line through `from` and `to` meets the k-th plane, which is one of those that separate
/// them: the values of all planes, and the sides as these say. Returns the planes whose side is in
/// doubt. Without branches, as far as it goes: no processor foresees a sign.
Sides CellCorners::interpolate(const Point& from, const Point& to, unsigned k, Point& point) const {
  const double span = from.values[k] - to.values[k];
  const double error = std::max(from.error, to.error);
  const Sides separating = from.sides ^ to.sides;
  point.sides = from.sides & ~separating;
  const Sides others = separating & ~bit(k);
  if (!(std::abs(span) > 4 * error)) {
    std::fill(point.values, point.values + count_ + count_ % 2, 0.0);
    point.error = kUnknown;
    return others;
  }
  const double scale = 1 / span;
  const double along = from.values[k] * scale;
  // With distances a and b that err by e, the parameter a / (a - b) errs by at most e / |a - b|.
  point.error = 1.5 * error + error * longest_ * std::abs(scale) + kRounding;
  const DoublePair step(along);
  const DoublePair reliable(point.error);
  Sides outside = 0;
  Sides in_doubt = ~Sides{0};
  for (unsigned j = 0; j < count_; j += 2) {
    const DoublePair start = DoublePair::load(from.values + j);
    const DoublePair value = start + step * (DoublePair::load(to.values + j) - start);
    value.store(point.values + j);
    outside |= value.is_larger_than(DoublePair(0)) << j;
    in_doubt &= ~(value.magnitude().is_larger_than(reliable) << j);
  }
  point.sides |= outside & others;
  return in_doubt & others;
}

/// The same on the planes `on` and `also_on`, with all sides for certain. False if more planes meet
/// there.
bool CellCorners::cross(const Point& from, const Point& to, unsigned k, PlaneRef on,
                        PlaneRef also_on, Point& point) const {
  return for_each_bit(interpolate(from, to, k, point), [&](unsigned j) {
    const int side =
        side_of_intersection(planes_[on], planes_[also_on], coefficients_[k], coefficients_[j]);
    point.sides = side > 0 ? point.sides | bit(j) : point.sides & ~bit(j);
    return side != 0;
  });
}

/// The alternating sum where plane m meets the line through `from` and `to`, on planes k and l.
/// Many planes pass through about one point where a vertex of the solid is: a side that is in doubt
/// is only looked for if the sum depends on it; `counts` says where it is not zero. Nothing if four
/// planes meet.
std::optional<int> CellCorners::sum_inside(const Point& from, const Point& to, unsigned k,
                                           unsigned l, unsigned m, MaterialTable::SidesSet counts) {
  Point point;
  Sides in_doubt = interpolate(from, to, m, point);
  Sides sides = point.sides & ~in_doubt;
  while ((counts & material_.possible(sides, in_doubt)) != 0) {
    if (in_doubt == 0) return material_.sum(sides, bit(k), bit(l), bit(m));
    const auto j = static_cast<unsigned>(std::countr_zero(in_doubt));
    const int side = side_inside(k, l, m, (to.sides & bit(m)) != 0, j);
    if (side == 0) return std::nullopt;
    if (side > 0) sides |= bit(j);
    in_doubt &= in_doubt - 1;
  }
  return 0;
}

/// The side of plane j where k < l < m meet, whose normals have a determinant of the given sign.
/// Four planes that meet in about one point ask four times for the sign of one determinant.
int CellCorners::side_inside(unsigned k, unsigned l, unsigned m, bool is_positive, unsigned j) {
  // The set of the four in ascending order, and how many it takes to pass by to put j last.
  const unsigned passed = (j < k) + (j < l) + (j < m);
  const unsigned a = std::min(k, j);
  const unsigned b = std::min(l, std::max(k, j));
  const unsigned c = std::min(m, std::max(l, j));
  const unsigned d = std::max(m, j);
  signed char& sign = signs_[a + b * (b - 1) / 2 + c * (c - 1) * (c - 2) / 6 +
                             d * (d - 1) * (d - 2) * (d - 3) / 24];
  if (sign == kUnknownSign) {
    sign = static_cast<signed char>(
        determinant_sign(coefficients_[a], coefficients_[b], coefficients_[c], coefficients_[d]));
  }
  // See side_of_intersection.
  return (passed % 2 == 0) == is_positive ? -sign : sign;
}

void CellCorners::put_end(Ends& ends, bool is_exit, std::uint32_t point) const {
  (is_exit ? ends.exit : ends.entry) = point;
}

bool CellCorners::find_on_edges() {
  for (auto& lines : on_face_) std::fill(lines, lines + count_, Ends{kNone, kNone});
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = (axis + 1) % 3;
    const unsigned v = (axis + 2) % 3;
    for (unsigned edge = 0; edge < 4; ++edge) {
      const unsigned u_upper = edge & 1;
      const unsigned v_upper = edge >> 1;
      const unsigned lower = u_upper << u | v_upper << v;
      const Point& from = corners_[lower];
      const Point& to = corners_[lower | 1u << axis];
      const Sides separating = from.sides ^ to.sides;
      if (separating == 0) continue;
      const unsigned f = 2 * u + u_upper;
      const unsigned g = 2 * v + v_upper;
      const bool is_fine = for_each_bit(separating, [&](unsigned k) {
        const std::uint32_t number = point_count_++;
        Point& point = points_[number];
        if (!cross(from, to, k, walls_[f], walls_[g], point)) return false;
        // The sign of the determinant of the outward normals of f, g and k.
        const bool is_positive = (u_upper == v_upper) == ((to.sides & bit(k)) != 0);
        const int sum = material_.sum(point.sides, bit(k));
        add(wall_numbers_[f], wall_numbers_[g], numbers_[k], is_positive ? sum : -sum);
        // On a face, the line of plane k runs along the cross product of their normals.
        put_end(on_face_[f][k], !is_positive, number);
        put_end(on_face_[g][k], is_positive, number);
        return true;
      });
      if (!is_fine) return false;
    }
  }
  return true;
}

bool CellCorners::find_on_faces() {
  if (count_ < 2) return true;
  for (unsigned k = 0; k < count_; ++k) {
    std::fill(inside_[k], inside_[k] + count_, Ends{kNone, kNone});
  }
  for (unsigned f = 0; f < 6; ++f) {
    for (unsigned k = 0; k + 1 < count_; ++k) {
      const Ends ends = on_face_[f][k];
      if (ends.entry == kNone && ends.exit == kNone) continue;
      if (ends.entry == kNone || ends.exit == kNone) return false;
      const Sides separating = points_[ends.entry].sides ^ points_[ends.exit].sides;
      // The other ones have been here before.
      const Sides later = separating & ~(bit(k + 1) - 1);
      const bool is_fine = for_each_bit(later, [&](unsigned l) {
        const std::uint32_t number = point_count_++;
        const Point& from = points_[ends.entry];
        const Point& to = points_[ends.exit];
        Point& point = points_[number];
        if (!cross(from, to, l, walls_[f], refs_[k], point)) return false;
        const bool is_positive = (to.sides & bit(l)) != 0;
        const int sum = material_.sum(point.sides, bit(k), bit(l));
        add(wall_numbers_[f], numbers_[k], numbers_[l], is_positive ? sum : -sum);
        put_end(inside_[k][l], is_positive, number);
        return true;
      });
      if (!is_fine) return false;
    }
  }
  return true;
}

bool CellCorners::find_inside() {
  if (count_ < 3) return true;
  const unsigned n = count_;
  if (n > 3) std::fill(signs_, signs_ + n * (n - 1) * (n - 2) * (n - 3) / 24, kUnknownSign);
  for (unsigned k = 0; k + 2 < count_; ++k) {
    for (unsigned l = k + 1; l + 1 < count_; ++l) {
      const Ends ends = inside_[k][l];
      if (ends.entry == kNone && ends.exit == kNone) continue;
      if (ends.entry == kNone || ends.exit == kNone) return false;
      const Point& from = points_[ends.entry];
      const Point& to = points_[ends.exit];
      const Sides separating = from.sides ^ to.sides;
      const Sides later = separating & ~(bit(l + 1) - 1);
      if (later == 0) continue;
      const auto possible = material_.possible(from.sides & ~separating, separating);
      if (possible == 0) continue;
      const auto sums = material_.sums_of_pair(k, l);
      if ((possible & material_.not_zero(sums)) == 0) continue;
      const bool is_fine = for_each_bit(later, [&](unsigned m) {
        const auto counts = material_.not_zero_with(sums, m);
        if ((counts & possible) == 0) return true;
        const std::optional<int> sum = sum_inside(from, to, k, l, m, counts);
        if (!sum) return false;
        const bool is_positive = (to.sides & bit(m)) != 0;
        add(numbers_[k], numbers_[l], numbers_[m], is_positive ? *sum : -*sum);
        return true;
      });
      if (!is_fine) return false;
    }
  }
  return true;
}

}  // namespace spoctree
