#include "server/silhouettes/encode_mask.hpp"

#include <cairo.h>

#include <new>

namespace spoctree {

namespace {

std::string header(const char* magic, const Mask& mask) {
  return std::string(magic) + "\n" + std::to_string(mask.width) + " " +
         std::to_string(mask.height) + "\n";
}

std::string to_pbm(const Mask& mask) {
  std::string bytes = header("P4", mask);
  for (int row = 0; row < mask.height; ++row) {
    unsigned byte = 0;
    for (int column = 0; column < mask.width; ++column) {
      byte |= static_cast<unsigned>(mask.at(column, row)) << (7 - column % 8);
      if (column % 8 == 7 || column + 1 == mask.width) {
        bytes += static_cast<char>(byte);
        byte = 0;
      }
    }
  }
  return bytes;
}

std::string to_pgm(const Mask& mask) {
  std::string bytes = header("P5", mask) + "255\n";
  for (const std::uint8_t pixel : mask.pixels) bytes += static_cast<char>(pixel * 255);
  return bytes;
}

std::string to_png(const Mask& mask) {
  cairo_surface_t* const surface =
      cairo_image_surface_create(CAIRO_FORMAT_A8, mask.width, mask.height);
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  cairo_surface_flush(surface);
  unsigned char* const data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int row = 0; row < mask.height; ++row) {
    for (int column = 0; column < mask.width; ++column)
      data[row * stride + column] = mask.at(column, row) != 0 ? 255 : 0;
  }
  cairo_surface_mark_dirty(surface);
  std::string bytes;
  const auto append = [](void* closure, const unsigned char* part, unsigned length) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(part), length);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface, append, &bytes);
  cairo_surface_destroy(surface);
  if (status != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  return bytes;
}

}  // namespace

std::string_view name_of(MaskFormat format) {
  switch (format) {
    case MaskFormat::Pbm:
      return "pbm";
    case MaskFormat::Pgm:
      return "pgm";
    case MaskFormat::Png:
      return "png";
  }
  return "";
}

std::string encode_mask(const Mask& mask, MaskFormat format) {
  switch (format) {
    case MaskFormat::Pbm:
      return to_pbm(mask);
    case MaskFormat::Pgm:
      return to_pgm(mask);
    case MaskFormat::Png:
      return to_png(mask);
  }
  return "";
}

}  // namespace spoctree
