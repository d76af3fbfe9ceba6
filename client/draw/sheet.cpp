#include "client/draw/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "client/draw/chain_lines.hpp"
#include "client/draw/clip_lines.hpp"
#include "client/draw/lettering.hpp"
#include "client/draw/straight_way.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

constexpr double kGapMm = 8;
constexpr double kLetterMm = 3.5;
constexpr double kCaptionMm = 7;  ///< a caption and the gap above it
constexpr double kSymbolMm = 7;
constexpr double kFootMm = 10;  ///< the symbol and the gap above it

Vec2 size_of(const View& view) { return view.frame.upper - view.frame.lower; }

/// Where each picture goes.
class Grid {
 public:
  Grid(std::span<const Picture> pictures, bool has_symbol) : foot_mm_(has_symbol ? kFootMm : 0) {
    const auto count = std::count_if(pictures.begin(), pictures.end(), [](const Picture& picture) {
      return !picture.view.is_over_last;
    });
    const int columns =
        count <= 3 ? static_cast<int>(count) : static_cast<int>(std::ceil(std::sqrt(count)));
    int next = 0;
    for (const Picture& picture : pictures) {
      const View& view = picture.view;
      if (!view.is_over_last) {
        cells_.push_back(view.cell.value_or(SheetCell{next % columns, next / columns}));
        ++next;
      } else {
        cells_.push_back(cells_.back());
      }
      widen(widths_, cells_.back().column, size_of(view).x);
      widen(heights_, cells_.back().row, size_of(view).y);
      if (!view.name.empty()) caption_mm_ = kCaptionMm;
    }
  }

  PageContent content() const {
    PageContent content;
    for (const double width : widths_) content.pictures.x += width;
    for (const double height : heights_) content.pictures.y += height;
    const auto columns = static_cast<double>(widths_.size());
    const auto rows = static_cast<double>(heights_.size());
    content.rest_mm = {(columns - 1) * kGapMm, (rows - 1) * kGapMm + rows * caption_mm_ + foot_mm_};
    return content;
  }

  /// How wide the caption of picture `k` may be: its column, and most of the gap beside it.
  double room_of(std::size_t k, const PageLayout& page) const {
    const double gap = std::min(kGapMm, 2 * page.origin_mm.x);
    return widths_[index(cells_[k].column)] * page.mm_per_unit + 0.8 * gap;
  }

  /// The middle of picture `k` on the page.
  Vec2 middle_of(std::size_t k, const PageLayout& page) const {
    const std::size_t column = index(cells_[k].column);
    const std::size_t row = index(cells_[k].row);
    Vec2 at = page.origin_mm + Vec2{0.5 * widths_[column], 0.5 * heights_[row]} * page.mm_per_unit;
    for (std::size_t c = 0; c < column; ++c) at.x += widths_[c] * page.mm_per_unit + kGapMm;
    for (std::size_t r = 0; r < row; ++r)
      at.y += heights_[r] * page.mm_per_unit + caption_mm_ + kGapMm;
    return at;
  }

 private:
  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  static void widen(std::vector<double>& sizes, int number, double size) {
    if (sizes.size() <= index(number)) sizes.resize(index(number) + 1);
    sizes[index(number)] = std::max(sizes[index(number)], size);
  }

  double caption_mm_ = 0;
  double foot_mm_ = 0;
  std::vector<SheetCell> cells_;
  std::vector<double> widths_;  ///< picture units
  std::vector<double> heights_;
};

/// Groups by pen and source, in drawing order.
class GroupCollector {
 public:
  StrokeGroup& group(const Pen& pen, const std::optional<LineSource>& source) {
    const LineSource known = source.value_or(LineSource{});
    StrokeGroup& group =
        groups_[{pen, source.has_value(), known.level, known.kind, known.is_inherited}];
    group.pen = pen;
    group.source = source;
    return group;
  }
  std::vector<StrokeGroup> take() {
    std::vector<StrokeGroup> groups;
    for (auto& [key, group] : groups_) groups.push_back(std::move(group));
    return groups;
  }

 private:
  std::map<std::tuple<Pen, bool, std::uint8_t, NodeKind, bool>, StrokeGroup> groups_;
};

Pen pen_of(const VisibleLine& line, Ink ink, bool colour_by_kind) {
  Pen pen;
  pen.hidden = line.hidden;
  pen.use = line.kind == LineKind::Crease ? PenUse::Crease : PenUse::Silhouette;
  pen.is_step = line.is_step;
  pen.ink = colour_by_kind ? ink_of_kind(line.source) : ink;
  return pen;
}

/// In chains of lines that are not farther apart than `tolerance`, picture units.
std::vector<std::pair<Pen, VisibleLines>> lines_by_pen(const Picture& picture, bool colour_by_kind,
                                                       double tolerance) {
  std::map<Pen, VisibleLines> by_pen;
  for (const VisibleLine& line : picture.lines)
    by_pen[pen_of(line, picture.view.ink, colour_by_kind)].push_back(line);
  std::vector<std::pair<Pen, VisibleLines>> result;
  for (const auto& [pen, lines] : by_pen)
    result.emplace_back(pen, in_chains(lines, picture.view.camera, tolerance));
  return result;
}

void add_stroke(StrokeGroup& group, std::span<const Vec2> points) {
  Stroke stroke;
  stroke.begin = static_cast<std::uint32_t>(group.points.size());
  group.points.insert(group.points.end(), points.begin(), points.end());
  stroke.end = static_cast<std::uint32_t>(group.points.size());
  group.strokes.push_back(stroke);
}

/// From the picture to the page.
struct Placement {
  Vec2 picture{0.0};  ///< this point of the picture
  Vec2 page_mm{0.0};  ///< comes here
  double mm_per_unit = 1;
  double touch_mm = 0;  ///< points nearer than this are one, lines as straight as this are so

  Vec2 operator()(Vec2 at) const {
    return {page_mm.x + (at.x - picture.x) * mm_per_unit,
            page_mm.y - (at.y - picture.y) * mm_per_unit};
  }
};

/// The run of the group's last stroke goes on to `end` if it ends at `begin`.
bool extend_run(StrokeGroup& group, Vec2 begin, Vec2 end, double touch_mm) {
  if (group.strokes.empty() || glm::distance(group.points.back(), begin) > touch_mm) return false;
  group.points.push_back(end);
  ++group.strokes.back().end;
  return true;
}

/// Dashes run on while the pen does.
class Dashes {
 public:
  explicit Dashes(double touch_mm) : touch_mm_(touch_mm) {}

  /// How long the pen has been going on at `begin`.
  double draw(Vec2 begin, Vec2 end) {
    if (!(glm::distance(at_, begin) <= touch_mm_)) drawn_ = 0;
    const double before = drawn_;
    drawn_ += glm::distance(begin, end);
    at_ = end;
    return before;
  }

 private:
  double touch_mm_;
  Vec2 at_{std::numeric_limits<double>::quiet_NaN()};
  double drawn_ = 0;
};

/// Lines that follow each other on one straight line of the picture, whatever their depths.
struct Run {
  std::span<const VisibleLine> lines;
  Vec2 begin{0.0};
  Vec2 end{0.0};
  LineSource source;  ///< of the longest
};

/// The run that the first of the lines begins.
Run first_run(std::span<const VisibleLine> lines, const View& view, const Placement& on_page) {
  Run run;
  double longest = -1;
  std::size_t count = 0;
  std::optional<StraightWay> way;
  for (const VisibleLine& line : lines) {
    const Vec2 begin = on_page(view.camera.project(line.a));
    const Vec2 end = on_page(view.camera.project(line.b));
    if (count == 0) {
      run.begin = begin;
      way.emplace(begin, end, on_page.touch_mm);
    } else if (glm::distance(run.end, begin) > on_page.touch_mm || !way->go_on_to(end)) {
      break;
    }
    run.end = end;
    ++count;
    if (glm::distance(begin, end) <= longest) continue;
    longest = glm::distance(begin, end);
    run.source = line.source;
  }
  run.lines = lines.first(count);
  return run;
}

void add_planes(StrokeGroup& group, const Run& run) {
  Stroke& stroke = group.strokes.back();
  stroke.planes_begin = static_cast<std::uint32_t>(group.planes.size());
  for (const VisibleLine& line : run.lines) {
    for (const LineStretch& stretch : stretches_of(line)) {
      const PlanePair pair = {stretch.planes[0], stretch.planes[1]};
      const bool is_new = group.planes.size() == stroke.planes_begin || group.planes.back() != pair;
      if (is_new) group.planes.push_back(pair);
    }
  }
  stroke.planes_end = static_cast<std::uint32_t>(group.planes.size());
}

void add_lines(GroupCollector& groups, const Pen& pen, const VisibleLines& lines, const View& view,
               const Placement& on_page, LineData data) {
  Dashes dashes(on_page.touch_mm);
  const StrokeGroup* last_group = nullptr;
  for (std::span<const VisibleLine> left = lines; !left.empty();) {
    const Run run = first_run(left, view, on_page);
    left = left.subspan(run.lines.size());
    StrokeGroup& group =
        groups.group(pen, data == LineData::None ? std::nullopt : std::optional(run.source));
    const double dashes_before = dashes.draw(run.begin, run.end);
    // Dashes do not run on where the chain has been elsewhere in between.
    const bool may_be_joined = data != LineData::Planes && (!pen.hidden || last_group == &group);
    last_group = &group;
    if (may_be_joined && extend_run(group, run.begin, run.end, on_page.touch_mm)) continue;
    const Vec2 ends[] = {run.begin, run.end};
    add_stroke(group, ends);
    if (data == LineData::Planes) add_planes(group, run);
    if (pen.hidden) group.strokes.back().dashes_before_mm = dashes_before;
  }
}

/// In smaller letters where there is no room for a longer caption.
void add_caption(GroupCollector& groups, const std::string& name, Vec2 middle, double room) {
  if (name.empty()) return;
  Pen pen;
  pen.use = PenUse::Lettering;
  const double height = std::min(kLetterMm, kLetterMm * room / lettering_width(name, kLetterMm));
  const Vec2 at{middle.x - 0.5 * lettering_width(name, height), middle.y};
  for (const auto& points : letter(name, at, height))
    add_stroke(groups.group(pen, std::nullopt), points);
}

/// Smaller where there is no room for it.
void add_symbol(GroupCollector& groups, Projection projection, const PageLayout& page,
                double margin) {
  Pen pen;
  pen.use = PenUse::Lettering;
  const double room = page.width_mm - 2 * margin;
  const double height = kSymbolMm * std::min(1.0, room / projection_symbol_width(kSymbolMm));
  const Vec2 at{page.width_mm - margin - projection_symbol_width(height),
                page.height_mm - margin - height};
  for (const auto& points : projection_symbol(projection, at, height))
    add_stroke(groups.group(pen, std::nullopt), points);
}

}  // namespace

Picture make_picture(View view, const VisibleLines& lines) {
  VisibleLines clipped = clip_lines(lines, view.camera, view.frame);
  return {std::move(view), std::move(clipped)};
}

Drawing make_sheet(std::span<const Picture> pictures, const Universe& universe,
                   const SheetOptions& options) {
  const Grid grid(pictures, options.symbol.has_value());
  const PageLayout page = lay_out(grid.content(), universe.scale(), options.page);
  const double touch = kPaperTolerance * 2 * std::sqrt(3.0) * universe.half_side;
  GroupCollector groups;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const View& view = pictures[k].view;
    const Vec2 middle = grid.middle_of(k, page);
    const Placement on_page{0.5 * (view.frame.lower + view.frame.upper), middle, page.mm_per_unit,
                            touch * page.mm_per_unit};
    for (const auto& [pen, lines] : lines_by_pen(pictures[k], options.colour_by_kind, touch))
      add_lines(groups, pen, lines, view, on_page, options.data);
    const double below = 0.5 * size_of(view).y * page.mm_per_unit + kCaptionMm;
    add_caption(groups, view.name, middle + Vec2{0, below}, grid.room_of(k, page));
  }
  if (options.symbol) add_symbol(groups, *options.symbol, page, options.page.margin_mm);
  Drawing drawing;
  drawing.title = options.title;
  drawing.width_mm = page.width_mm;
  drawing.height_mm = page.height_mm;
  drawing.scale = page.mm_per_unit / universe.scale();
  drawing.groups = groups.take();
  drawing.universe = universe;
  return drawing;
}

}  // namespace spoctree
