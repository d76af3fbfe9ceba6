#include "tests/support/exact_determinant.hpp"

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <glm/common.hpp>

namespace spoctree {

namespace {

using Exact = CGAL::Exact_rational;

template <class Number>
Number determinant(const Number (&m)[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
         m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// The sum of the absolute values of the determinant's terms.
double permanent(Vec3 a, Vec3 b, Vec3 c) {
  a = glm::abs(a);
  b = glm::abs(b);
  c = glm::abs(c);
  return a.x * (b.y * c.z + b.z * c.y) + a.y * (b.z * c.x + b.x * c.z) +
         a.z * (b.x * c.y + b.y * c.x);
}

Exact exact_determinant(const ExactDifference& a, const ExactDifference& b,
                        const ExactDifference& c) {
  Exact m[3][3];
  const ExactDifference* const rows[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = Exact(rows[i]->to[j]) - Exact(rows[i]->from[j]);
  }
  return determinant(m);
}

}  // namespace

ExactDeterminant::ExactDeterminant(const ExactDifference& a, const ExactDifference& b,
                                   const ExactDifference& c)
    : a_(a), b_(b), c_(c) {
  const Vec3 u = a.to - a.from;
  const Vec3 v = b.to - b.from;
  const Vec3 w = c.to - c.from;
  const double m[3][3] = {{u.x, u.y, u.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}};
  value_ = determinant(m);
  // Each term is a product of three differences, rounded eight times at most.
  error_ = permanent(u, v, w) * 0x1p-49;
  if (std::abs(value_) > error_ || error_ == 0) return;
  value_ = CGAL::to_double(exact_determinant(a, b, c));
  error_ = std::abs(value_) * 0x1p-50;
}

double ExactDeterminant::root(const ExactDeterminant& at_0, const ExactDeterminant& at_1) {
  const double slope = at_0.value_ - at_1.value_;
  if (at_0.error_ + at_1.error_ < 1e-9 * std::abs(slope)) return at_0.value_ / slope;
  const Exact f0 = exact_determinant(at_0.a_, at_0.b_, at_0.c_);
  const Exact f1 = exact_determinant(at_1.a_, at_1.b_, at_1.c_);
  return CGAL::to_double(Exact(f0 / (f0 - f1)));
}

}  // namespace spoctree
