#include "server/solid/solid_queries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "server/solid/box_tree.hpp"
#include "server/solid/triangle_distance.hpp"
#include "server/solid/upward_ray.hpp"

namespace spoctree {

namespace {

BoxTree box_tree_of(const Solid& solid) {
  std::vector<Box> boxes;
  boxes.reserve(solid.triangles.size());
  for (const SolidTriangle& t : solid.triangles) {
    boxes.push_back(box_around(solid.vertices[t.vertex[0]], solid.vertices[t.vertex[1]],
                               solid.vertices[t.vertex[2]]));
  }
  return BoxTree(boxes);
}

}  // namespace

struct SolidQueries::Data {
  explicit Data(const Solid& s) : solid(s), boxes(box_tree_of(s)) {
    measured.reserve(solid.triangles.size());
    for (const SolidTriangle& t : solid.triangles) {
      measured.emplace_back(solid.vertices[t.vertex[0]], solid.vertices[t.vertex[1]],
                            solid.vertices[t.vertex[2]]);
    }
  }

  const Solid& solid;
  BoxTree boxes;
  std::vector<MeasuredTriangle> measured;
};

SolidQueries::SolidQueries(const Solid& solid) : data_(std::make_unique<const Data>(solid)) {}
SolidQueries::~SolidQueries() = default;

SolidQueries::Side SolidQueries::side_of(Vec3 point) const {
  const UpwardRay ray(point);
  const Solid& solid = data_->solid;
  bool is_on = false;
  bool is_inside = false;
  data_->boxes.visit_boxes_above(point, [&](std::uint32_t i) {
    const SolidTriangle& t = solid.triangles[i];
    switch (ray.meets(solid.vertices[t.vertex[0]], solid.vertices[t.vertex[1]],
                      solid.vertices[t.vertex[2]])) {
      case UpwardRay::Meets::StartsOn:
        is_on = true;
        break;
      case UpwardRay::Meets::Crosses:
        is_inside = !is_inside;
        break;
      case UpwardRay::Meets::Not:
        break;
    }
  });
  return is_on ? Side::On : (is_inside ? Side::In : Side::Out);
}

SolidQueries::Nearest SolidQueries::nearest(Vec3 point, double near_enough) const {
  Nearest found;
  const double squared_enough = std::max(0.0, near_enough) * near_enough;
  double smallest = std::numeric_limits<double>::infinity();
  data_->boxes.smallest_squared_distance(point, [&](std::uint32_t i) {
    const double squared = data_->measured[i].squared_distance(point);
    if (squared < smallest) {
      smallest = squared;
      found.triangle = i;
    }
    return squared <= squared_enough ? 0.0 : squared;  // nothing is nearer: the search ends
  });
  found.distance = std::sqrt(smallest);
  return found;
}

double SolidQueries::distance_to(std::uint32_t triangle, Vec3 point) const {
  return std::sqrt(data_->measured[triangle].squared_distance(point));
}

}  // namespace spoctree
