#include "client/draw/write_pdf.hpp"

#include <algorithm>
#include <cmath>

#include "client/draw/fixed_number.hpp"
#include "common/base/errors.hpp"

namespace spoctree {

namespace {

constexpr double kPointsPerMm = 72 / 25.4;
constexpr double kLargestPageMm = 5080;  // 14,400 points
constexpr int kDecimals = 3;
constexpr double kStepsPerMm = 1000;

std::string decimals(double value) { return to_decimal(value, 6); }

std::string box_of(const Drawing& drawing) {
  return "[0 0 " + decimals(drawing.width_mm * kPointsPerMm) + ' ' +
         decimals(drawing.height_mm * kPointsPerMm) + ']';
}

void append_point(std::string& text, GridPoint point, char command) {
  append_decimal(text, point.x, kDecimals);
  text += ' ';
  append_decimal(text, point.y, kDecimals);
  text += ' ';
  text += command;
  text += '\n';
}

void append_stroke(std::string& text, std::span<const Vec2> points) {
  append_point(text, to_grid_point(points.front(), kStepsPerMm), 'm');
  for (const Vec2 point : points.subspan(1))
    append_point(text, to_grid_point(point, kStepsPerMm), 'l');
  text += "S\n";
}

std::string take_pen(const Pen& pen) {
  const Rgb colour = colour_of(pen);
  const bool is_glass = pen.ink == Ink::LeftEye || pen.ink == Ink::RightEye;
  std::string text = is_glass ? "/Multiply gs\n" : "/Normal gs\n";
  for (const int part : {colour.red, colour.green, colour.blue})
    text += to_decimal(part / 255.0, 3) + ' ';
  text += "RG " + to_decimal(width_mm(pen), 3) + " w\n";
  if (!pen.hidden) text += "[] 0 d\n";
  return text;
}

/// Where in the dashes a stroke begins, in numbers as short as can be.
std::string phase_of(const Stroke& stroke) {
  return to_decimal(std::fmod(stroke.dashes_before_mm, kDashMm + kDashGapMm), kDecimals);
}

void append_strokes(std::string& text, const StrokeGroup& group) {
  std::string last_phase;
  for (const Stroke& stroke : group.strokes) {
    if (group.pen.hidden && phase_of(stroke) != last_phase) {
      last_phase = phase_of(stroke);
      text += '[' + to_decimal(kDashMm, 3) + ' ' + to_decimal(kDashGapMm, 3) + "] " + last_phase +
              " d\n";
    }
    append_stroke(text, group.points_of(stroke));
  }
}

std::string begin_layer(int object) { return "/OC /L" + std::to_string(object) + " BDC\n"; }

std::string list_of(const std::vector<int>& objects) {
  std::string list = "[";
  for (const int object : objects) list += reference_to(object) + ' ';
  return list + ']';
}

}  // namespace

int PdfWriter::add_layer_object(const std::string& name) {
  layer_objects_.push_back(file_.add("<</Type/OCG/Name" + pdf_string(name) + ">>"));
  return layer_objects_.back();
}

int PdfWriter::layer_of(const Pen& pen) {
  Layer& layer = layers_[pen];
  if (layer.object == 0) layer.object = add_layer_object(name_of(pen, ' '));
  return layer.object;
}

int PdfWriter::part_of(const Pen& pen, const LineSource& source) {
  layer_of(pen);
  const std::string node = name_of(source);
  int& part = layers_[pen].parts[{source.level, node}];
  if (part == 0) part = add_layer_object(node + ", level " + std::to_string(source.level));
  return part;
}

std::string PdfWriter::content_of(const Drawing& drawing) {
  // Millimetres, y downwards; round caps and joins.
  std::string content = decimals(kPointsPerMm) + " 0 0 -" + decimals(kPointsPerMm) + " 0 " +
                        decimals(drawing.height_mm * kPointsPerMm) + " cm 1 J 1 j\n";
  for (const StrokeGroup& group : drawing.groups) {
    content += begin_layer(layer_of(group.pen));
    if (group.source) content += begin_layer(part_of(group.pen, *group.source));
    content += take_pen(group.pen);
    append_strokes(content, group);
    content += group.source ? "EMC\nEMC\n" : "EMC\n";
  }
  return content;
}

std::string PdfWriter::properties() const {
  std::string list;
  for (const int object : layer_objects_)
    list += "/L" + std::to_string(object) + ' ' + reference_to(object);
  return "<<" + list + ">>";
}

void PdfWriter::add_page(const Drawing& drawing) {
  if (!(std::max(drawing.width_mm, drawing.height_mm) <= kLargestPageMm))
    throw UsageError("the page is too large for PDF, whose pages are at most 5080 mm wide");
  if (page_tree_ == 0) page_tree_ = file_.reserve();
  const int content = file_.add_stream(content_of(drawing));
  const int page = file_.add("<</Type/Page/Parent " + reference_to(page_tree_) + "/MediaBox" +
                             box_of(drawing) + "/Contents " + reference_to(content) +
                             "/Resources<</ExtGState<</Multiply<</BM/Multiply>>/Normal<</BM/Normal"
                             ">>>>/Properties" +
                             properties() + ">>>>");
  pages_.push_back({page, drawing.title});
}

std::string PdfWriter::layer_order() const {
  std::string order = "[";
  for (const auto& [pen, layer] : layers_) {
    order += reference_to(layer.object) + ' ';
    if (layer.parts.empty()) continue;
    order += '[';
    for (const auto& [key, part] : layer.parts) order += reference_to(part) + ' ';
    order += ']';
  }
  return order + ']';
}

int PdfWriter::add_outline() {
  const int root = file_.reserve();
  std::vector<int> entries;
  for (std::size_t k = 0; k < pages_.size(); ++k) entries.push_back(file_.reserve());
  for (std::size_t k = 0; k < pages_.size(); ++k) {
    std::string entry = "<</Title" + pdf_string(pages_[k].title) + "/Parent " + reference_to(root) +
                        "/Dest[" + reference_to(pages_[k].object) + "/Fit]";
    if (k > 0) entry += "/Prev " + reference_to(entries[k - 1]);
    if (k + 1 < pages_.size()) entry += "/Next " + reference_to(entries[k + 1]);
    file_.set(entries[k], entry + ">>");
  }
  file_.set(root, "<</Type/Outlines/First " + reference_to(entries.front()) + "/Last " +
                      reference_to(entries.back()) + "/Count " + std::to_string(entries.size()) +
                      ">>");
  return root;
}

std::string PdfWriter::finish(const std::string& title) {
  std::vector<int> pages;
  for (const Page& page : pages_) pages.push_back(page.object);
  file_.set(page_tree_, "<</Type/Pages/Count " + std::to_string(pages.size()) + "/Kids" +
                            list_of(pages) + ">>");
  const int outline = add_outline();
  const int info =
      file_.add("<</Title" + pdf_string(title) + "/Producer" + pdf_string("spoctree") + ">>");
  const int catalog =
      file_.add("<</Type/Catalog/Pages " + reference_to(page_tree_) + "/Outlines " +
                reference_to(outline) + "/PageMode/UseOutlines/OCProperties<</OCGs" +
                list_of(layer_objects_) + "/D<</Order" + layer_order() + ">>>>>>");
  return file_.finish(catalog, info);
}

}  // namespace spoctree
