// Convex parts of the picture through which a cell is seen, and what openings leave of them.
#pragma once

#include <span>
#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/crease_parts.hpp"

namespace spoctree {

/// A point of space as the viewer has it: (x, y) / w is where it is in the picture; w is its depth,
/// negative behind the viewer. Linear in the point: lines of the picture are planes through the
/// eye, and what is partly behind it needs no care.
struct SightPoint {
  double x = 0;
  double y = 0;
  double w = 1;
};

SightPoint sight_point(Vec3 point, const Camera& camera);

/// The half-plane { a x + b y + c w >= 0 }; (a, b) is a unit vector.
struct SightLine {
  double a = 0;
  double b = 0;
  double c = 0;

  double operator()(const SightPoint& p) const { return a * p.x + b * p.y + c * p.w; }
  double operator()(Vec2 p) const { return a * p.x + b * p.y + c; }
};

/// The line from one point to another, which has on its left what is inside. All of the picture, if
/// the two are one point of it.
SightLine sight_line(const SightPoint& from, const SightPoint& to);

/// A convex polygon of the picture, counter-clockwise.
struct SightMask {
  struct Corner {
    Vec2 at{0.0};
    SightLine line;  ///< along the edge that leaves it: of the opening that made it, unclipped
  };
  std::vector<Corner> corners;
};

SightMask mask_of(const Rectangle& frame);
double area_of(std::span<const SightMask::Corner> mask);
/// True if it is nowhere wider than `thinnest`, up to a factor of two.
bool is_too_thin(std::span<const SightMask::Corner> mask, double thinnest);

/// An opening as the viewer sees it: counter-clockwise, partly behind the viewer or not.
struct SightOpening {
  struct Corner {
    SightPoint at;
    SightLine line;
  };
  std::span<const Corner> corners;
};

/// Intersects masks with openings. Holds working memory.
class MaskClipper {
 public:
  /// The intersection, into `result`; false if it is nowhere wider than `thinnest`. O(corners of
  /// both).
  bool clip(std::span<const SightMask::Corner> mask, const SightOpening& opening, double thinnest,
            SightMask& result);
  /// The same with one half-plane.
  bool clip(SightMask& mask, const SightLine& line, double thinnest);

 private:
  void cut(const SightLine& line);

  std::vector<SightOpening::Corner> polygon_, cut_;
};

/// Leaves of a line's part a + t (b - a), t in `part`, what is seen through a mask, or beside it by
/// at most `tolerance`.
void clip_line(const SightPoint& a, const SightPoint& b, std::span<const SightMask::Corner> mask,
               double tolerance, Interval& part);

}  // namespace spoctree
