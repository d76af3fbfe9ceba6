#include "client/draw/write_png.hpp"

#include <cairo.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

constexpr double kMmPerInch = 25.4;

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;

int pixels(double mm, double dpi) {
  const double count = std::max(1.0, std::ceil(mm * dpi / kMmPerInch - 1e-6));
  if (!(count <= kLargestPngSide))
    throw UsageError(
        "a picture with more than 32000 pixels on a side: choose a smaller scale or "
        "--dpi");
  return static_cast<int>(count);
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw BadInput(std::string("cannot make the PNG picture: ") + cairo_status_to_string(status));
}

void take_pen(cairo_t* context, const Pen& pen) {
  const Rgb colour = colour_of(pen);
  cairo_set_source_rgb(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  cairo_set_line_width(context, width_mm(pen));
  const bool is_glass = pen.ink == Ink::LeftEye || pen.ink == Ink::RightEye;
  cairo_set_operator(context, is_glass ? CAIRO_OPERATOR_MULTIPLY : CAIRO_OPERATOR_OVER);
}

void draw(cairo_t* context, const StrokeGroup& group, const Stroke& stroke) {
  const double dashes[] = {kDashMm, kDashGapMm};
  cairo_set_dash(context, dashes, group.pen.hidden ? 2 : 0, stroke.dashes_before_mm);
  const auto points = group.points_of(stroke);
  cairo_move_to(context, points.front().x, points.front().y);
  for (const Vec2 point : points.subspan(1)) cairo_line_to(context, point.x, point.y);
  // Stroke by stroke: cairo's time for one path grows faster than its length.
  cairo_stroke(context);
}

/// A PNG begins with a signature of 8 bytes and the chunk IHDR of 25.
constexpr std::size_t kHeaderEnd = 33;

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
}

/// The chunk pHYs, which cairo does not write: pixels per metre, by which it is printed to scale.
std::string density(double dpi) {
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi * 1000 / kMmPerInch));
  std::string body = "pHYs";
  append_big_endian(body, per_metre);
  append_big_endian(body, per_metre);
  body += '\1';
  std::string chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  append_big_endian(chunk,
                    static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                     static_cast<uInt>(body.size()))));
  return chunk;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string to_png(const Drawing& drawing, double dpi) {
  if (!(dpi >= kLeastDpi && dpi <= kLargestDpi))
    throw UsageError("--dpi must be between 10 and 2400");
  const int width = pixels(drawing.width_mm, dpi);
  const int height = pixels(drawing.height_mm, dpi);
  if (static_cast<double>(width) * height > kLargestPngPixels)
    throw UsageError(
        "a picture with more than 200 million pixels: choose a smaller scale or --dpi");
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  check(cairo_surface_status(surface.get()));
  const Context context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  cairo_scale(context.get(), dpi / kMmPerInch, dpi / kMmPerInch);
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  for (const StrokeGroup& group : drawing.groups) {
    take_pen(context.get(), group.pen);
    for (const Stroke& stroke : group.strokes) draw(context.get(), group, stroke);
  }
  check(cairo_status(context.get()));
  std::string png;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  png.insert(kHeaderEnd, density(dpi));
  return png;
}

}  // namespace spoctree
