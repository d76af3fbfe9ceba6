// A page with lines of several pens, for the tests of the writers.
#pragma once

#include "client/draw/drawing.hpp"

namespace spoctree::test {

inline StrokeGroup group_of(const Pen& pen, std::initializer_list<std::vector<Vec2>> strokes) {
  StrokeGroup group;
  group.pen = pen;
  for (const std::vector<Vec2>& points : strokes) {
    Stroke stroke;
    stroke.begin = static_cast<std::uint32_t>(group.points.size());
    group.points.insert(group.points.end(), points.begin(), points.end());
    stroke.end = static_cast<std::uint32_t>(group.points.size());
    group.strokes.push_back(stroke);
  }
  return group;
}

/// 100 mm x 62.5 mm: a dashed line, a corner of two, and two creases that know their planes.
inline Drawing sample_drawing() {
  Drawing drawing;
  drawing.title = "sample";
  drawing.width_mm = 100;
  drawing.height_mm = 62.5;
  Pen hidden;
  hidden.hidden = true;
  drawing.groups.push_back(group_of(hidden, {{{90, 60}, {90, 10}}}));
  StrokeGroup known = group_of({}, {{{1, 2}, {3.5, 4.25}}, {{10, 2}, {5, 2}}});
  known.source = LineSource{NodeKind::Convex, 3, false};
  known.planes.push_back({PlaneRef::of_table(7), PlaneRef::of_table(12).flipped()});
  const PlaneRef middle = PlaneRef::of_wall(0, 1U << 29);
  known.planes.push_back({middle, PlaneRef::of_table(0)});
  known.planes.push_back({PlaneRef::of_table(3), PlaneRef::of_table(0)});
  known.strokes[0].planes_end = known.strokes[1].planes_begin = 1;
  known.strokes[1].planes_end = 3;
  drawing.groups.push_back(known);
  Pen silhouette;
  silhouette.use = PenUse::Silhouette;
  drawing.groups.push_back(group_of(silhouette, {{{20, 20}, {30, 20}, {30, 45}}}));
  drawing.universe.center = {2.5, 0, 0};
  return drawing;
}

}  // namespace spoctree::test
