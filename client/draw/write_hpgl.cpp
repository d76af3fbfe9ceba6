#include "client/draw/write_hpgl.hpp"

#include <algorithm>

#include "client/draw/fixed_number.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

namespace {

constexpr double kUnitsPerMm = 40;
constexpr double kLargestUnit = 8'388'607;

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
    // A dash and its gap as in other formats: a pattern of so many percent of the page's diagonal
    // would depend on the plotter, one in millimetres (mode 1) does not.
    if (pen.hidden != is_dashed_)
      text_ += pen.hidden ? "LT2," + to_decimal(kDashMm + kDashGapMm, 1) + ",1;\n" : "LT;\n";
    is_dashed_ = pen.hidden;
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

  std::string take() {
    if (is_dashed_) text_ += "LT;\n";
    return text_ + "PU;\nSP0;\n";
  }

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
  bool is_dashed_ = false;
  GridPoint at_{-1, -1};
};

}  // namespace

std::string to_hpgl(const Drawing& drawing) {
  if (std::max(drawing.width_mm, drawing.height_mm) * kUnitsPerMm > kLargestUnit)
    throw UsageError("the page is too large for HPGL");
  HpglWriter writer(drawing.height_mm);
  for (const StrokeGroup& group : drawing.groups) {
    writer.take_pen(group.pen);
    for (const Stroke& stroke : group.strokes) writer.draw(group.points_of(stroke));
  }
  return writer.take();
}

}  // namespace spoctree
