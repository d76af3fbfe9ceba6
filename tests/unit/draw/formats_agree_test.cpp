// One sheet of a real solid in every format: the same lines on paper, and those in space.

#include <gtest/gtest.h>

#include <algorithm>

#include "client/draw/sheet.hpp"
#include "client/draw/write_dxf.hpp"
#include "client/draw/write_hpgl.hpp"
#include "client/draw/write_pdf.hpp"
#include "client/draw/write_svg.hpp"
#include "client/lines/visible_lines.hpp"
#include "client/rebuild/surface.hpp"
#include "tests/support/voxels.hpp"
#include "tests/unit/draw/read_back.hpp"

namespace spoctree::test {
namespace {

/// A staircase of four steps, from two sides and in a perspective.
std::vector<Picture> pictures_of(const Octree& tree) {
  std::vector<View> views;
  ViewOptions named;
  named.named = {"front", "iso"};
  for (View& view : make_views(named, tree)) views.push_back(std::move(view));
  ViewOptions eye;
  eye.eye = Vec3{3, -4, 2};
  views.push_back(make_views(eye, tree).at(0));
  const LineScene scene(tree, rebuild_surface(tree, 2), 2);
  LineOptions options;
  options.with_hidden_lines = true;
  std::vector<Picture> pictures;
  for (View& view : views) {
    VisibleLines lines = visible_lines(scene, view.camera, options);
    pictures.push_back({std::move(view), std::move(lines)});
  }
  return pictures;
}

double length_of(const std::vector<Segment>& segments) {
  double length = 0;
  for (const Segment& segment : segments) length += glm::distance(segment.a, segment.b);
  return length;
}

double distance(Vec2 point, const Segment& segment) {
  const Vec2 way = segment.b - segment.a;
  const double t = std::clamp(glm::dot(point - segment.a, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(point, segment.a + t * way);
}

/// Every end and every middle of `segments` lies on one of `others`.
void expect_covered(const std::vector<Segment>& segments, const std::vector<Segment>& others,
                    double tolerance) {
  for (const Segment& segment : segments) {
    for (const Vec2 point : {segment.a, segment.b, 0.5 * (segment.a + segment.b)}) {
      const bool is_covered = std::any_of(others.begin(), others.end(), [&](const Segment& other) {
        return distance(point, other) <= tolerance;
      });
      EXPECT_TRUE(is_covered) << point.x << ' ' << point.y;
    }
  }
}

TEST(Formats, ShowTheSameLines) {
  const Octree tree = tree_of(Voxels{2, [](int x, int, int z) { return x + z < 4; }});
  const std::vector<Picture> pictures = pictures_of(tree);
  for (const LineData data : {LineData::None, LineData::Source, LineData::Planes}) {
    SheetOptions options;
    options.data = data;
    const Drawing drawing = make_sheet(pictures, tree.universe, options);
    const auto upwards = [&](std::vector<Segment> segments, double mm_per_unit) {
      for (Segment& segment : segments) {
        segment.a = {segment.a.x * mm_per_unit, drawing.height_mm - segment.a.y * mm_per_unit};
        segment.b = {segment.b.x * mm_per_unit, drawing.height_mm - segment.b.y * mm_per_unit};
      }
      return segments;
    };
    // The drawing itself, as it is before any format rounds it.
    std::vector<Segment> exact;
    for (const StrokeGroup& group : drawing.groups) {
      for (const Stroke& stroke : group.strokes) {
        const auto points = group.points_of(stroke);
        for (std::size_t k = 1; k < points.size(); ++k)
          exact.push_back({points[k - 1], points[k], "", ""});
      }
    }
    ASSERT_GT(exact.size(), 40U);
    // HPGL has hidden lines in dashes.
    Drawing solid = drawing;
    for (StrokeGroup& group : solid.groups) group.pen.hidden = false;
    PdfWriter pdf;
    pdf.add_page(drawing);
    for (const auto& segments : {read_svg(to_svg(drawing)), upwards(read_dxf(to_dxf(drawing)), 1),
                                 upwards(read_hpgl(to_hpgl(solid)), 1),
                                 upwards(read_pdf(pdf.finish("")).at(0).segments, 25.4 / 72)}) {
      // HPGL's grid is the coarsest: 0.025 mm.
      EXPECT_EQ(segments.size(), exact.size());
      EXPECT_NEAR(length_of(segments), length_of(exact), 0.02 * static_cast<double>(exact.size()));
      expect_covered(segments, exact, 0.02);
      expect_covered(exact, segments, 0.02);
    }
  }
}

// All pens together, strokes with and without data have the same ink on paper.
TEST(Formats, DataChangeNothingOnPaper) {
  const Octree tree = tree_of(Voxels{2, [](int x, int, int z) { return x + z < 4; }});
  const std::vector<Picture> pictures = pictures_of(tree);
  std::vector<double> lengths;
  for (const LineData data : {LineData::None, LineData::Source, LineData::Planes}) {
    SheetOptions options;
    options.data = data;
    const auto segments = read_dxf(to_dxf(make_sheet(pictures, tree.universe, options)));
    lengths.push_back(length_of(segments));
  }
  EXPECT_NEAR(lengths[0], lengths[2], 1e-6);
  EXPECT_NEAR(lengths[1], lengths[2], 1e-6);
}

}  // namespace
}  // namespace spoctree::test
