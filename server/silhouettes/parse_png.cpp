#include "server/silhouettes/parse_png.hpp"

#include <cairo.h>

#include <algorithm>
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

constexpr std::size_t kHeaderAt = 8;  // length, "IHDR", width, height, bits of a value, ...

void check_size(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kHeaderAt + 17 || bytes.substr(1, 7) != "PNG\r\n\x1a\n" ||
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

bool has_16_bits(std::string_view bytes) { return bytes[kHeaderAt + 16] == 16; }

Picture picture_of(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Picture picture;
  picture.width = cairo_image_surface_get_width(surface);
  picture.height = cairo_image_surface_get_height(surface);
  picture.pixels.reserve(static_cast<std::size_t>(picture.width) *
                         static_cast<std::size_t>(picture.height));
  const bool has_alpha = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_ARGB32;
  const unsigned char* const data = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (int row = 0; row < picture.height; ++row) {
    const unsigned char* pixel_data = data + static_cast<std::size_t>(row) * stride;
    for (int column = 0; column < picture.width; ++column, pixel_data += 4) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, pixel_data, 4);
      // Where a pixel lets through what is behind it, that is black.
      const std::uint32_t red = bits >> 16 & 255;
      const std::uint32_t green = bits >> 8 & 255;
      const std::uint32_t blue = bits & 255;
      const std::uint32_t brightness = (299 * red + 587 * green + 114 * blue + 500) / 1000;
      picture.pixels.push_back({static_cast<std::uint16_t>(brightness),
                                static_cast<std::uint16_t>(std::max({red, green, blue})),
                                static_cast<std::uint16_t>(std::min({red, green, blue})),
                                has_alpha && 2 * (bits >> 24) < 255});
    }
  }
  return picture;
}

}  // namespace

MaskReading parse_png(std::string_view bytes, std::string_view name) {
  const std::string file(name);
  check_size(bytes, file);
  Source source{bytes};
  const Surface surface(cairo_image_surface_create_from_png_stream(read_bytes, &source));
  if (const cairo_status_t status = cairo_surface_status(surface.get());
      status != CAIRO_STATUS_SUCCESS) {
    throw BadInput(file + ": byte " + std::to_string(source.at) + ": broken PNG file (" +
                   cairo_status_to_string(status) + ")");
  }
  MaskReading reading = find_object(picture_of(surface.get()), name);
  // Of such values only the upper halves are here; labels are in the lower ones.
  if (has_16_bits(bytes) && !reading.mask.has_object()) {
    throw BadInput(file +
                   ": it is dark: the brightest pixel is below 256 of 65535, and what is at "
                   "least half of white is the object");
  }
  return reading;
}

}  // namespace spoctree
