#include "client/commands/draw_formats.hpp"

#include <filesystem>
#include <system_error>

#include "client/draw/write_dxf.hpp"
#include "client/draw/write_hpgl.hpp"
#include "client/draw/write_json.hpp"
#include "client/draw/write_pdf.hpp"
#include "client/draw/write_png.hpp"
#include "client/draw/write_svg.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"

namespace spoctree {

namespace {

struct FormatName {
  const char* name;
  DrawFormat format;
};
constexpr FormatName kFormats[] = {{"svg", DrawFormat::Svg},   {"pdf", DrawFormat::Pdf},
                                   {"png", DrawFormat::Png},   {"dxf", DrawFormat::Dxf},
                                   {"hpgl", DrawFormat::Hpgl}, {"json", DrawFormat::Json},
                                   {"plt", DrawFormat::Hpgl}};
constexpr double kDefaultDpi = 200;

std::string in_small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// Of a file's name, without its point and in small letters; empty for folders.
std::string extension_in(const std::string& output) {
  std::error_code error;
  if (std::filesystem::is_directory(output, error)) return "";
  std::string extension = std::filesystem::path(output).extension().string();
  if (extension.size() <= 1) return "";
  return in_small_letters(extension.substr(1));
}

/// What a format has room for.
LineData data_of(DrawFormat format) {
  if (format == DrawFormat::Svg || format == DrawFormat::Dxf) return LineData::Planes;
  return format == DrawFormat::Pdf ? LineData::Source : LineData::None;
}

void check_page(const DrawArguments& arguments, DrawFormat format) {
  const bool is_png = !arguments.output.empty() && format == DrawFormat::Png;
  if (arguments.dpi && !is_png) throw UsageError("--dpi is for PNG");
  if (arguments.dpi && !(*arguments.dpi >= kLeastDpi && *arguments.dpi <= kLargestDpi))
    throw UsageError("--dpi must be between 10 and 2400");
  const bool is_json_only = format == DrawFormat::Json && arguments.html.empty();
  if (is_json_only && (arguments.page.scale || arguments.page.paper || arguments.colour_by_kind ||
                       !arguments.with_data || arguments.view.projection))
    throw UsageError(
        "JSON has no page: --scale, --page, --projection, --colour-by and --bare do nothing there");
}

}  // namespace

std::string extension_of(DrawFormat format) {
  for (const FormatName& known : kFormats) {
    if (known.format == format) return std::string(".") + known.name;
  }
  return "";
}

DrawFormat choose_format(const DrawArguments& arguments) {
  const std::string wanted = arguments.format.empty() ? extension_in(arguments.output)
                                                      : in_small_letters(arguments.format);
  if (wanted.empty()) return DrawFormat::Svg;
  for (const FormatName& known : kFormats) {
    if (wanted == known.name) return known.format;
  }
  if (arguments.format.empty())
    throw UsageError("'" + arguments.output + "': there is no format '" + wanted +
                     "'; --format says which one it should be");
  throw UsageError("--format: '" + arguments.format +
                   "' should be svg, pdf, png, dxf, hpgl or json");
}

void check(const DrawArguments& arguments) {
  if (arguments.output.empty() && arguments.html.empty())
    throw UsageError("-o or --html is required");
  if (!arguments.html.empty() && arguments.html == arguments.output)
    throw UsageError("-o and --html name the same file");
  for (const std::string& output : {arguments.output, arguments.html}) {
    if (!output.empty() && are_one_file(arguments.stream.source, output))
      throw UsageError(output + ": the drawing would be written over the model itself");
  }
  if (arguments.output.empty() && !arguments.format.empty())
    throw UsageError("--format is for -o; what --html writes is always HTML");
  check(arguments.view);
  const DrawFormat format = choose_format(arguments);
  const double angle = arguments.crease_angle_deg.value_or(0);
  if (!(angle >= 0 && angle <= 180))
    throw UsageError("--crease-angle must be between 0 and 180 degrees");
  if (angle > 0 && !arguments.with_creases)
    throw UsageError("--crease-angle chooses creases, of which --lines wants none");
  if (arguments.colour_by_kind && arguments.view.stereo == ViewOptions::Stereo::Anaglyph)
    throw UsageError("--stereo=anaglyph needs the colours that --colour-by kind would use");
  check_page(arguments, format);
}

Drawing sheet_of(const LevelPictures& level, const DrawArguments& arguments, DrawFormat format) {
  SheetOptions options;
  options.page = arguments.page;
  options.title = level.model + ", level " + std::to_string(level.level);
  options.colour_by_kind = arguments.colour_by_kind;
  if (is_arranged_by_projection(arguments.view.named))
    options.symbol = arguments.view.projection.value_or(Projection::FirstAngle);
  options.data = arguments.with_data ? data_of(format) : LineData::None;
  if (format == DrawFormat::Dxf && !options.page.scale && !options.page.paper) {
    options.page.scale = 1;
    options.page.margin_mm = 0;
  }
  if (format == DrawFormat::Dxf) options.page.least_mm = 0;
  return make_sheet(level.pictures, level.universe, options);
}

std::string encode(const LevelPictures& level, const DrawArguments& arguments, DrawFormat format) {
  if (format == DrawFormat::Json)
    return to_json(level.pictures, level.universe, level.model, level.level);
  const Drawing drawing = sheet_of(level, arguments, format);
  switch (format) {
    case DrawFormat::Pdf: {
      PdfWriter pdf;
      pdf.add_page(drawing);
      return pdf.finish(drawing.title);
    }
    case DrawFormat::Png:
      return to_png(drawing, arguments.dpi.value_or(kDefaultDpi));
    case DrawFormat::Dxf:
      return to_dxf(drawing);
    case DrawFormat::Hpgl:
      return to_hpgl(drawing);
    default:
      return to_svg(drawing);
  }
}

}  // namespace spoctree
