#include "server/silhouettes/parse_netpbm.hpp"

#include <string>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

class NetpbmReader {
 public:
  NetpbmReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  MaskReading read() {
    const char format = bytes_[1];
    const bool is_bitmap = format == '1' || format == '4';
    at_ = 2;
    const int width = read_number("the width", kMostMaskPixels);
    const int height = read_number("the height", kMostMaskPixels);
    const int most = is_bitmap ? 1 : read_number("the largest value", 65535);
    if (width < 1 || height < 1) fail("a picture without pixels");
    if (most < 1) fail("the largest value is 0");
    MaskReading reading;
    if (is_bitmap) {
      reading.mask = Mask(width, height);
      format == '1' ? read_plain_bits(reading.mask) : read_raw_bits(reading.mask);
    } else {
      const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
      if (format == '5') step_over_blank();
      require(format == '2' ? 2 * pixels - 1 : (most > 255 ? 2 : 1) * pixels);
      Picture picture{width, height, most, std::vector<Pixel>(pixels)};
      format == '2' ? read_plain_values(picture) : read_raw_values(picture);
      reading = find_object(picture, name_);
    }
    skip_blanks();
    if (at_ < bytes_.size()) fail("something follows the last pixel");
    return reading;
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(std::string(name_) + ": byte " + std::to_string(at_) + ": " + what);
  }

  void skip_blanks() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (is_space(bytes_[at_])) {
        ++at_;
      } else {
        return;
      }
    }
  }

  int read_number(const char* what, int most) {
    skip_blanks();
    const auto is_digit = [&] {
      return at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9';
    };
    if (at_ == bytes_.size()) fail(std::string("the file ends before ") + what);
    if (!is_digit()) fail(std::string("not a number: ") + what);
    const std::size_t begin = at_;
    int value = 0;
    for (; is_digit(); ++at_) {
      value = 10 * value + (bytes_[at_] - '0');
      if (value <= most) continue;
      at_ = begin;
      fail(std::string(what) + " is more than " + std::to_string(most));
    }
    return value;
  }

  int read_bit() {  // plain PBM files need no blanks between pixels
    skip_blanks();
    if (at_ == bytes_.size()) fail("the file ends before a pixel");
    const char c = bytes_[at_];
    if (c != '0' && c != '1') fail("not a pixel");
    ++at_;
    return c - '0';
  }

  /// Checked before the pixels are read.
  void require(std::size_t count) const {
    if (bytes_.size() - at_ < count) {
      fail("the picture needs " + std::to_string(count) + " bytes from here, the file has " +
           std::to_string(bytes_.size() - at_));
    }
  }
  std::uint8_t next() { return static_cast<std::uint8_t>(bytes_[at_++]); }

  void read_plain_bits(Mask& mask) {
    for (std::uint8_t& pixel : mask.pixels) pixel = static_cast<std::uint8_t>(read_bit());
  }

  void read_raw_bits(Mask& mask) {
    step_over_blank();
    const int row_bytes = (mask.width + 7) / 8;
    require(static_cast<std::size_t>(row_bytes) * static_cast<std::size_t>(mask.height));
    for (int row = 0; row < mask.height; ++row) {
      std::uint8_t byte = 0;
      for (int column = 0; column < mask.width; ++column) {
        if (column % 8 == 0) byte = next();
        mask.at(column, row) = byte >> (7 - column % 8) & 1;
      }
    }
  }

  static Pixel grey(int value) {
    const auto brightness = static_cast<std::uint16_t>(value);
    return {brightness, brightness, brightness};
  }

  void read_plain_values(Picture& picture) {
    for (Pixel& pixel : picture.pixels) pixel = grey(read_number("a pixel", picture.white));
  }

  void read_raw_values(Picture& picture) {
    for (Pixel& pixel : picture.pixels) {
      int value = next();
      if (picture.white > 255) value = 256 * value + next();
      if (value > picture.white) fail("a pixel is more than " + std::to_string(picture.white));
      pixel = grey(value);
    }
  }

  // The one between the header and raw pixels.
  void step_over_blank() {
    if (at_ >= bytes_.size() || !is_space(bytes_[at_])) fail("a blank is missing");
    ++at_;
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
};

}  // namespace

MaskReading parse_netpbm(std::string_view bytes, std::string_view name) {
  return NetpbmReader(bytes, name).read();
}

}  // namespace spoctree
