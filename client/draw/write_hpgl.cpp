#include "client/draw/write_hpgl.hpp"

#include <algorithm>

#include "client/draw/cut_dashes.hpp"
#include "client/draw/fixed_number.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

namespace {

constexpr double kUnitsPerMm = 40;
constexpr double kLargestUnit = 8'388'607;
constexpr double kMostDashes = 1e7;

int plotter_pen(const Pen& pen) {
  if (pen.ink != Ink::Black) return static_cast<int>(pen.ink);
  if (pen.hidden) return 4;
  if (pen.is_step) return 3;
  return pen.use == PenUse::Crease ? 2 : 1;
}

class HpglWriter {
 public:
  explicit HpglWriter(double height_mm) : height_mm_(height_mm) {}

  void take_pen(const Pen& pen) {
    const int number = plotter_pen(pen);
    if (number != pen_) {
      text_ += "SP" + std::to_string(number) + ";\n";
      at_ = {-1, -1};  // wherever the plotter fetched the pen from
    }
    pen_ = number;
  }

  void draw(std::span<const Vec2> points) {
    GridPoint last = unit_of(points.front());
    bool is_down = false;
    for (const Vec2 point : points.subspan(1)) {
      const GridPoint next = unit_of(point);
      if (next == last) continue;
      if (!is_down) {
        if (at_ != last) move("PU", last);
        text_ += "PD";
      } else {
        text_ += ',';
      }
      append(next);
      is_down = true;
      last = next;
    }
    if (!is_down) return;
    text_ += ";\n";
    at_ = last;
  }

  std::string take() { return std::move(text_) + "PU;\nSP0;\n"; }

 private:
  GridPoint unit_of(Vec2 point) const {
    return to_grid_point({point.x, height_mm_ - point.y}, kUnitsPerMm);
  }
  void append(GridPoint point) { text_ += std::to_string(point.x) + ',' + std::to_string(point.y); }
  void move(const char* command, GridPoint point) {
    text_ += command;
    append(point);
    text_ += ';';
  }

  double height_mm_;
  std::string text_ = "IN;\n";
  int pen_ = 0;
  GridPoint at_{-1, -1};
};

/// The plotter's own line types are no dashes of ours: their lengths depend on its make, and
/// whether they run on from line to line too.
void draw_dashed(HpglWriter& writer, const StrokeGroup& group) {
  double length = 0;
  for (const Stroke& stroke : group.strokes) {
    const auto points = group.points_of(stroke);
    for (std::size_t k = 1; k < points.size(); ++k)
      length += glm::distance(points[k - 1], points[k]);
  }
  if (length > kMostDashes * (kDashMm + kDashGapMm))
    throw UsageError("more than 10 million dashes: choose a smaller scale");
  for (const Stroke& stroke : group.strokes) {
    for (const auto& dash :
         cut_dashes(group.points_of(stroke), stroke.dashes_before_mm, kDashMm, kDashGapMm))
      writer.draw(dash);
  }
}

}  // namespace

std::string to_hpgl(const Drawing& drawing) {
  if (std::max(drawing.width_mm, drawing.height_mm) * kUnitsPerMm > kLargestUnit)
    throw UsageError("the page is too large for HPGL");
  HpglWriter writer(drawing.height_mm);
  for (const StrokeGroup& group : drawing.groups) {
    writer.take_pen(group.pen);
    if (group.pen.hidden) {
      draw_dashed(writer, group);
      continue;
    }
    for (const Stroke& stroke : group.strokes) writer.draw(group.points_of(stroke));
  }
  return writer.take();
}

}  // namespace spoctree
