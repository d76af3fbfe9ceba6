// Points that triangles meet in, in rational numbers, by number. For the sources of this folder
// that build an arrangement; no other header includes this one.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = ExactKernel::Point_3;

/// The points of a mesh, followed by those that were constructed since.
class ExactPoints {
 public:
  explicit ExactPoints(std::span<const Vec3> given) : given_(given) {}

  std::size_t given() const { return given_.size(); }
  std::size_t size() const { return given_.size() + made_.size(); }
  bool is_given(std::uint32_t number) const { return number < given_.size(); }

  std::uint32_t add(const ExactPoint& point) {
    made_.push_back(point);
    return static_cast<std::uint32_t>(size() - 1);
  }
  ExactPoint operator[](std::uint32_t number) const {
    if (!is_given(number)) return made_[number - given_.size()];
    const Vec3 p = given_[number];
    return {p.x, p.y, p.z};
  }

 private:
  std::span<const Vec3> given_;
  std::vector<ExactPoint> made_;
};

}  // namespace spoctree
