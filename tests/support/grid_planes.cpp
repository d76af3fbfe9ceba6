#include "tests/support/grid_planes.hpp"

#include <glm/geometric.hpp>
#include <stdexcept>

namespace spoctree {

namespace {

__extension__ using Int128 = __int128;

constexpr double kGrid = 0x1p52;

struct IntegerPlane {
  std::int64_t n[3];
  std::int64_t d;
};

Plane to_plane(const IntegerPlane& plane) {
  return {Vec3{static_cast<double>(plane.n[0]), static_cast<double>(plane.n[1]),
               static_cast<double>(plane.n[2])} /
              kGrid,
          static_cast<double>(plane.d) / kGrid};
}

/// normal . point as a multiple of the grid step, if it is one. The point is `c` * 2^-point_bits.
bool offset_through(IntegerPlane& plane, const std::int64_t (&c)[3], int point_bits) {
  Int128 sum = 0;
  for (int i = 0; i < 3; ++i) sum += static_cast<Int128>(plane.n[i]) * c[i];
  const Int128 step = Int128{1} << point_bits;
  if (sum % step != 0) return false;
  plane.d = static_cast<std::int64_t>(sum / step);
  return true;
}

}  // namespace

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v = random_vector(random, 1);
    const double length = glm::length(v);
    if (length > 0.1 && length <= 1) return v / length;
  }
}

Vec3 random_vector(Random& random, double limit) {
  const double x = random.between(-limit, limit);
  const double y = random.between(-limit, limit);
  return {x, y, random.between(-limit, limit)};
}

Vec3 random_grid_point(Random& random, int point_bits, double limit) {
  Vec3 point = random_vector(random, limit);
  for (int i = 0; i < 3; ++i) {
    point[i] = std::ldexp(std::trunc(std::ldexp(point[i], point_bits)), -point_bits);
  }
  return point;
}

int random_integer(Random& random, int lowest, int highest) {
  return lowest + static_cast<int>(random.below(static_cast<std::uint32_t>(highest - lowest + 1)));
}

Plane grid_plane_through(Vec3 normal, Vec3 point) {
  const Vec3 unit = glm::normalize(normal);
  Plane plane;
  for (int i = 0; i < 3; ++i) plane.normal[i] = std::nearbyint(unit[i] * kGrid) / kGrid;
  plane.offset = std::nearbyint(glm::dot(plane.normal, point) * kGrid) / kGrid;
  return plane;
}

Plane random_plane_exactly_through(Random& random, Vec3 point, int point_bits) {
  std::int64_t c[3];
  for (int i = 0; i < 3; ++i) c[i] = static_cast<std::int64_t>(std::ldexp(point[i], point_bits));
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Plane start = grid_plane_through(random_direction(random), point);
    // The last bits of a normal are free within the tolerance of is_valid: among some 10^4
    // neighbours, normal . c is a multiple of 2^point_bits for a few.
    constexpr int kReach = 10;
    IntegerPlane plane{};
    for (int k = 0; k < 40000; ++k) {
      for (int i = 0; i < 3; ++i) {
        plane.n[i] = static_cast<std::int64_t>(start.normal[i] * kGrid) +
                     random_integer(random, -kReach, kReach);
      }
      if (!offset_through(plane, c, point_bits)) continue;
      const Plane found = to_plane(plane);
      if (is_valid(found)) return found;
    }
  }
  throw std::logic_error("no plane found through the point");
}

Plane random_plane_exactly_through_line(Random& random, Vec3 point, int point_bits,
                                        const int (&direction)[3]) {
  // Two integer vectors orthogonal to the direction; a large combination of them, of unit length.
  int axis = 0;
  while (direction[axis] == 0) ++axis;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::int64_t a[3] = {0, 0, 0};
  std::int64_t b[3] = {0, 0, 0};
  a[u] = direction[axis];
  a[axis] = -direction[u];
  b[v] = direction[axis];
  b[axis] = -direction[v];
  std::int64_t c[3];
  for (int i = 0; i < 3; ++i) c[i] = static_cast<std::int64_t>(std::ldexp(point[i], point_bits));
  for (int attempt = 0; attempt < 100000; ++attempt) {
    const double angle = random.between(0, 6.283185307179586);
    Vec3 combination{0.0};
    for (int i = 0; i < 3; ++i) {
      combination[i] =
          std::cos(angle) * static_cast<double>(a[i]) + std::sin(angle) * static_cast<double>(b[i]);
    }
    const double scale = kGrid / glm::length(combination);
    const auto alpha =
        static_cast<std::int64_t>(std::cos(angle) * scale) + random_integer(random, -1, 1);
    const auto beta =
        static_cast<std::int64_t>(std::sin(angle) * scale) + random_integer(random, -1, 1);
    IntegerPlane plane{};
    for (int i = 0; i < 3; ++i) plane.n[i] = alpha * a[i] + beta * b[i];
    if (!offset_through(plane, c, point_bits)) continue;
    const Plane found = to_plane(plane);
    if (is_valid(found)) return found;
  }
  throw std::logic_error("no plane found through the line");
}

Plane nearly_parallel_plane_through(Random& random, const Plane& plane, Vec3 point) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    Plane other = plane;
    for (int i = 0; i < 3; ++i) {
      const int change = 4 * random_integer(random, -2, 2);  // a multiple of 4 keeps d an integer
      other.normal[i] += change / kGrid;
      other.offset += change * point[i] / kGrid;
    }
    if (is_valid(other) && other.normal != plane.normal) return other;
  }
  throw std::logic_error("no nearly parallel plane found");
}

Plane random_degenerate_plane(Random& random, Vec3 centre, double half_side,
                              const std::vector<Plane>& older) {
  Vec3 point = centre;
  for (int i = 0; i < 3; ++i) point[i] += half_side * random_integer(random, -1, 1);
  const Plane plane = [&] {
    switch (random.below(5)) {
      case 0:
        return random_plane_exactly_through(random, point, 7);
      case 1: {
        int direction[3] = {0, 0, 0};
        while (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) {
          for (int& component : direction) component = random_integer(random, -1, 1);
        }
        return random_plane_exactly_through_line(random, point, 7, direction);
      }
      case 2: {
        Plane wall;
        const int axis = random_integer(random, 0, 2);
        wall.normal[axis] = 1;
        wall.offset = point[axis];
        return wall;
      }
      case 3:
        if (!older.empty()) return older[random.below(static_cast<std::uint32_t>(older.size()))];
        [[fallthrough]];
      default:
        return grid_plane_through(random_direction(random),
                                  centre + random_vector(random, half_side));
    }
  }();
  return random.chance(0.5) ? plane : plane.flipped();
}

}  // namespace spoctree
