#include "client/draw/write_dxf.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <vector>

namespace spoctree {

namespace {

/// AutoCAD's colour numbers. 7 is black on white and white on black.
constexpr int kInkColours[kInkCount] = {7, 8, 94, 5, 2, 1, 6, 4, 1};

/// An entity's extended data are at most 16 kilobytes.
constexpr std::size_t kMostPlanePairs = 200;

int colour_number(const Pen& pen) {
  if (pen.ink == Ink::Black && (pen.is_step || pen.hidden)) return pen.hidden ? 8 : 9;
  return kInkColours[static_cast<int>(pen.ink)];
}

/// At most 31 characters, as R12 wants them: "SILHOUETTE_STEP_R_CONCAVE_30I" is the longest.
std::string layer_of(const StrokeGroup& group) {
  const Pen& pen = group.pen;
  Pen use;
  use.use = pen.use;
  std::string name = pen.hidden ? "hidden" : name_of(use, '_');
  if (pen.is_step) name += "_step";
  if (pen.ink == Ink::LeftEye || pen.ink == Ink::RightEye) {
    name += pen.ink == Ink::LeftEye ? "_l" : "_r";
  } else if (pen.ink != Ink::Black && !group.source) {
    name += std::string("_") + name_of(pen.ink);
  }
  if (group.source) {
    name += std::string("_") + name_of(group.source->kind) + '_' +
            std::to_string(group.source->level) + (group.source->is_inherited ? "i" : "");
  }
  for (char& c : name) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return name;
}

class DxfWriter {
 public:
  explicit DxfWriter(const Drawing& drawing) : drawing_(drawing) {}

  std::string write() {
    // A comment is one line: titles have no line breaks.
    if (!drawing_.title.empty()) pair(999, drawing_.title);
    header();
    tables();
    pair(0, "SECTION");
    pair(2, "ENTITIES");
    for (const StrokeGroup& group : drawing_.groups) {
      const std::string layer = layer_of(group);
      for (const Stroke& stroke : group.strokes) draw(group, stroke, layer);
    }
    pair(0, "ENDSEC");
    pair(0, "EOF");
    return std::move(text_);
  }

 private:
  void pair(int code, std::string_view value) {
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
  }
  void pair(int code, int value) { pair(code, std::to_string(value)); }
  void pair(int code, double value) {
    // Twelve digits: finer than any picture is exact.
    char digits[40];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value + 0.0, std::chars_format::general, 12);
    pair(code, std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
  }
  void point(Vec2 at, int first_code) {
    pair(first_code, at.x);
    pair(first_code + 10, drawing_.height_mm - at.y);
    pair(first_code + 20, 0.0);
  }

  void header() {
    pair(0, "SECTION");
    pair(2, "HEADER");
    pair(9, "$ACADVER");
    pair(1, "AC1009");
    pair(9, "$EXTMIN");
    point({0, drawing_.height_mm}, 10);
    pair(9, "$EXTMAX");
    point({drawing_.width_mm, 0}, 10);
    pair(0, "ENDSEC");
  }

  void tables() {
    pair(0, "SECTION");
    pair(2, "TABLES");
    table("LTYPE", 2);
    line_type("CONTINUOUS", "Solid line", {});
    line_type("DASHED", "__ __ __", {kDashMm, -kDashGapMm});
    pair(0, "ENDTAB");
    std::map<std::string, Pen> layers;
    for (const StrokeGroup& group : drawing_.groups) layers.emplace(layer_of(group), group.pen);
    table("LAYER", static_cast<int>(layers.size()) + 1);
    layer("0", {});
    for (const auto& [name, pen] : layers) layer(name, pen);
    pair(0, "ENDTAB");
    table("APPID", 1);
    pair(0, "APPID");
    pair(2, "SPOCTREE");
    pair(70, 0);
    pair(0, "ENDTAB");
    pair(0, "ENDSEC");
  }
  void table(const char* name, int entries) {
    pair(0, "TABLE");
    pair(2, name);
    pair(70, entries);
  }
  void line_type(const char* name, const char* picture, const std::vector<double>& dashes) {
    pair(0, "LTYPE");
    pair(2, name);
    pair(70, 0);
    pair(3, picture);
    pair(72, 65);
    pair(73, static_cast<int>(dashes.size()));
    double length = 0;
    for (const double dash : dashes) length += dash < 0 ? -dash : dash;
    pair(40, length);
    for (const double dash : dashes) pair(49, dash);
  }
  void layer(const std::string& name, const Pen& pen) {
    pair(0, "LAYER");
    pair(2, name);
    pair(70, 0);
    pair(62, colour_number(pen));
    pair(6, pen.hidden ? "DASHED" : "CONTINUOUS");
  }

  void draw(const StrokeGroup& group, const Stroke& stroke, const std::string& layer) {
    const auto points = group.points_of(stroke);
    if (points.size() == 2) {
      entity("LINE", layer);
      point(points[0], 10);
      point(points[1], 11);
      planes_of(group, stroke);
      return;
    }
    entity("POLYLINE", layer);
    pair(66, 1);  // vertices follow
    point({0, drawing_.height_mm}, 10);
    if (group.pen.hidden) pair(70, 128);  // dashes run on round the corners
    planes_of(group, stroke);
    for (const Vec2 at : points) {
      entity("VERTEX", layer);
      point(at, 10);
    }
    entity("SEQEND", layer);
  }
  void entity(const char* kind, const std::string& layer) {
    pair(0, kind);
    pair(8, layer);
  }
  void planes_of(const StrokeGroup& group, const Stroke& stroke) {
    const auto planes = group.planes_of(stroke);
    if (planes.empty()) return;
    pair(1001, "SPOCTREE");
    for (const PlanePair& both : planes.first(std::min(planes.size(), kMostPlanePairs))) {
      for (const PlaneRef plane : both) pair(1000, name_of(plane, drawing_.universe));
    }
  }

  const Drawing& drawing_;
  std::string text_;
};

}  // namespace

std::string to_dxf(const Drawing& drawing) { return DxfWriter(drawing).write(); }

}  // namespace spoctree
