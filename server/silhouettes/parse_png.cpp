#include "server/silhouettes/parse_png.hpp"

#include <cairo.h>

#include <cstring>
#include <memory>
#include <string>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

struct FreeSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeSurface>;
struct FreeContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

struct Source {
  std::string_view bytes;
  std::size_t at = 0;
};

cairo_status_t read_bytes(void* closure, unsigned char* data, unsigned length) {
  auto& source = *static_cast<Source*>(closure);
  if (source.bytes.size() - source.at < length) {
    source.at = source.bytes.size();
    return CAIRO_STATUS_READ_ERROR;
  }
  std::memcpy(data, source.bytes.data() + source.at, length);
  source.at += length;
  return CAIRO_STATUS_SUCCESS;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

void check_size(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kHeaderAt = 8;  // length, "IHDR", width, height, ...
  if (bytes.size() < kHeaderAt + 16 || bytes.substr(1, 7) != "PNG\r\n\x1a\n" ||
      bytes.substr(kHeaderAt + 4, 4) != "IHDR")
    throw BadInput(name + ": byte 0: not the beginning of a PNG file");
  const std::uint32_t width = big_endian(bytes, kHeaderAt + 8);
  const std::uint32_t height = big_endian(bytes, kHeaderAt + 12);
  constexpr auto kMost = static_cast<std::uint32_t>(kMostMaskPixels);
  if (width < 1 || height < 1 || width > kMost || height > kMost) {
    throw BadInput(name + ": byte " + std::to_string(kHeaderAt + 8) + ": " + std::to_string(width) +
                   " x " + std::to_string(height) + " pixels, rows and columns are 1 to " +
                   std::to_string(kMost));
  }
}

}  // namespace

Mask parse_png(std::string_view bytes, std::string_view name) {
  const std::string file(name);
  check_size(bytes, file);
  Source source{bytes};
  const Surface picture(cairo_image_surface_create_from_png_stream(read_bytes, &source));
  if (const cairo_status_t status = cairo_surface_status(picture.get());
      status != CAIRO_STATUS_SUCCESS) {
    throw BadInput(file + ": byte " + std::to_string(source.at) + ": broken PNG file (" +
                   cairo_status_to_string(status) + ")");
  }
  Mask mask(cairo_image_surface_get_width(picture.get()),
            cairo_image_surface_get_height(picture.get()));
  // Before black, whatever the file's depth and transparency.
  const Surface opaque(cairo_image_surface_create(CAIRO_FORMAT_RGB24, mask.width, mask.height));
  {
    const std::unique_ptr<cairo_t, FreeContext> context(cairo_create(opaque.get()));
    cairo_set_source_surface(context.get(), picture.get(), 0, 0);
    cairo_paint(context.get());
    if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
      throw BadInput(file + ": cannot be drawn");
  }
  cairo_surface_flush(opaque.get());
  const unsigned char* const data = cairo_image_surface_get_data(opaque.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(opaque.get()));
  for (int row = 0; row < mask.height; ++row) {
    for (int column = 0; column < mask.width; ++column) {
      std::uint32_t pixel = 0;
      std::memcpy(
          &pixel,
          data + static_cast<std::size_t>(row) * stride + 4 * static_cast<std::size_t>(column), 4);
      const std::uint32_t brightness =
          299 * (pixel >> 16 & 255) + 587 * (pixel >> 8 & 255) + 114 * (pixel & 255);
      mask.at(column, row) = 2 * brightness >= 255'000;
    }
  }
  return mask;
}

}  // namespace spoctree
