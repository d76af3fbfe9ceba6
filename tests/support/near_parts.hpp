// Segments -> which part of one is near another.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// Ascending disjoint pairs of parameters t of a + t (b - a).
using Parts = std::vector<std::pair<double, double>>;

struct Segment {
  Vec3 a{0.0};
  Vec3 b{0.0};

  Vec3 at(double t) const { return a + t * (b - a); }
};

/// The part of `of` that is within `distance` of a point of `to`.
std::optional<std::pair<double, double>> part_near(const Segment& of, const Segment& to,
                                                   double distance);

/// The part of `of` that `on` lies along, if all of that part is within `distance` of it; unlike
/// part_near nothing of lines that merely meet or cross, but for `distance` beyond the ends.
std::optional<std::pair<double, double>> part_along(const Segment& of, const Segment& on,
                                                    double distance);

Parts united(Parts parts);
Parts common_of(const Parts& one, const Parts& other);
Parts without(std::pair<double, double> whole, const Parts& parts);

}  // namespace spoctree
