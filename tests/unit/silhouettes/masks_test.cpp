#include <gtest/gtest.h>
#include <zlib.h>

#include "common/base/errors.hpp"
#include "server/silhouettes/encode_mask.hpp"
#include "server/silhouettes/mask.hpp"
#include "server/silhouettes/read_mask.hpp"

namespace spoctree {
namespace {

Mask mask_of(int width, int height, const std::string& pixels) {
  Mask mask(width, height);
  for (std::size_t i = 0; i < pixels.size(); ++i) mask.pixels[i] = pixels[i] == '#';
  return mask;
}

const Mask kSample = mask_of(10, 3, "#.........####..####.#.#.#.#.#");

std::string complaint(const std::string& bytes) {
  try {
    parse_mask(bytes, "m");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "none";
}

TEST(Masks, AreReadAsTheyWereWrittenInEveryFormat) {
  for (const MaskFormat format : {MaskFormat::Pbm, MaskFormat::Pgm, MaskFormat::Png})
    EXPECT_EQ(parse_mask(encode_mask(kSample, format), "m").mask, kSample) << name_of(format);
}

TEST(Masks, AreReadFromPlainFormatsWithComments) {
  EXPECT_EQ(parse_mask("P1\n# a comment\n3 2\n0 1 1\n110", "m").mask, mask_of(3, 2, ".####."));
  EXPECT_EQ(parse_mask("P2 3 1 # wide\n9\n4 5 9\n", "m").mask, mask_of(3, 1, ".##"));
}

TEST(Masks, TakeHalfOfWhiteForTheObject) {
  EXPECT_EQ(parse_mask(std::string("P5 2 1 255\n\x7f\x80", 13), "m").mask, mask_of(2, 1, ".#"));
  EXPECT_EQ(parse_mask(std::string("P5 2 1 65535\n\x7f\xff\x80\x00", 17), "m").mask,
            mask_of(2, 1, ".#"));
}

// A PNG file of 8 bits a value, as the specification has it: colour type 0 grey, 2 RGB, 6 RGBA.
std::string png_of(int width, int height, int type, const std::string& values) {
  const auto number = [](std::size_t n) {
    std::string four;
    for (int shift = 24; shift >= 0; shift -= 8) four += static_cast<char>(n >> shift);
    return four;
  };
  std::string png = "\x89PNG\r\n\x1a\n";
  const auto add = [&](const std::string& chunk) {
    const auto* const data = reinterpret_cast<const Bytef*>(chunk.data());
    png +=
        number(chunk.size() - 4) + chunk + number(crc32(0, data, static_cast<uInt>(chunk.size())));
  };
  add("IHDR" + number(static_cast<std::size_t>(width)) + number(static_cast<std::size_t>(height)) +
      std::string{8, static_cast<char>(type), 0, 0, 0});
  const std::size_t row = values.size() / static_cast<std::size_t>(height);
  std::string rows;
  for (std::size_t begin = 0; begin < values.size(); begin += row)
    rows += '\0' + values.substr(begin, row);
  std::string packed(compressBound(rows.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  add("IDAT" + packed.substr(0, size));
  add("IEND");
  return png;
}

std::string pixel(int red, int green, int blue) {
  return {static_cast<char>(red), static_cast<char>(green), static_cast<char>(blue)};
}
std::string pixel(int red, int green, int blue, int alpha) {
  return pixel(red, green, blue) + static_cast<char>(alpha);
}

void expect_reading(const std::string& bytes, const std::string& pixels,
                    const std::string& remark) {
  const MaskReading reading = parse_mask(bytes, "m");
  EXPECT_EQ(reading.mask, mask_of(3, 1, pixels));
  EXPECT_NE(reading.remark.find(remark), std::string::npos) << reading.remark;
  EXPECT_EQ(reading.remark.empty(), remark.empty()) << reading.remark;
}

TEST(Masks, OfLabelsAreWhatIsNotBlack) {
  const std::string remark = "the brightest pixel is 1 of 255: taken for a picture of labels";
  expect_reading("P2 3 1 255\n0 1 1\n", ".##", remark);
  expect_reading(std::string("P5 3 1 255\n\0\1\1", 14), ".##", remark);
  expect_reading(png_of(3, 1, 0, std::string("\0\1\1", 3)), ".##", remark);
  expect_reading("P2 3 1 65535\n0 7 7\n", ".##", "the brightest pixel is 7 of 65535");
  expect_reading("P2 3 1 1\n0 1 1\n", ".##", "");
  expect_reading(png_of(3, 1, 2, pixel(0, 0, 0) + pixel(90, 10, 10) + pixel(90, 10, 10)), ".##",
                 "picture of labels");
}

TEST(Masks, ThatAreDarkAreRefusedByTheirBrightness) {
  const std::string end = ", and what is at least half of white is the object";
  EXPECT_EQ(complaint("P2 3 1 255\n0 1 2\n"),
            "m: it is dark: the brightest pixel is 2 of 255" + end);
  EXPECT_EQ(complaint("P2 3 1 255\n9 9 9\n"),
            "m: it is dark: the brightest pixel is 9 of 255" + end);
  EXPECT_EQ(complaint(png_of(3, 1, 0, "\x01\x10\x20")),
            "m: it is dark: the brightest pixel is 32 of 255" + end);
  expect_reading("P2 3 1 255\n0 0 0\n", "...", "every pixel is black");
}

TEST(Masks, OfCutOutsAreWhatIsOpaque) {
  const std::string none = pixel(0, 0, 0, 0);
  const std::string remark = "the object is what is opaque, bright or not";
  expect_reading(png_of(3, 1, 6, none + pixel(0, 0, 0, 255) + pixel(0, 0, 0, 255)), ".##", remark);
  expect_reading(png_of(3, 1, 6, none + pixel(200, 0, 0, 255) + pixel(255, 255, 255, 255)), ".##",
                 remark);
  expect_reading(png_of(3, 1, 6, none + pixel(0, 0, 0, 100) + pixel(9, 9, 9, 200)), "..#", remark);
  expect_reading(png_of(3, 1, 6, none + none + pixel(255, 255, 255, 255)), "..#", "");
  EXPECT_EQ(complaint(png_of(3, 1, 6, none + none + none)), "m: every pixel is transparent");
}

TEST(Masks, OfColouredObjectsAreUnderstoodOrRefused) {
  const std::string black = pixel(0, 0, 0);
  const std::string red = pixel(255, 0, 0);
  const std::string dark_red = pixel(140, 0, 0);
  const std::string blue = pixel(0, 0, 255);
  const std::string yellow = pixel(255, 255, 0);
  const std::string white = pixel(255, 255, 255);
  expect_reading(png_of(3, 1, 2, black + red + dark_red), ".##",
                 "no pixel is bright (the brightest is 76 of 255): the object is what has a strong "
                 "colour");
  expect_reading(png_of(3, 1, 2, black + yellow + white), ".##", "");
  EXPECT_EQ(complaint(png_of(3, 1, 2, blue + yellow + blue)),
            "m: it has bright pixels (brightness up to 226 of 255) and dark ones in strong colours "
            "(brightness from 29 of 255): make the object white and all else black");
  EXPECT_NE(complaint(png_of(3, 1, 2, white + red + white)).find("76 of 255"), std::string::npos);
  EXPECT_NE(complaint(png_of(3, 1, 2, blue + red + blue)).find("strong colours all over"),
            std::string::npos);
}

TEST(Masks, AreRefusedWhereverTheyAreCutOff) {
  for (const MaskFormat format : {MaskFormat::Pbm, MaskFormat::Pgm, MaskFormat::Png}) {
    const std::string whole = encode_mask(kSample, format);
    const std::size_t pixels_end = format == MaskFormat::Png ? whole.size() - 12 : whole.size();
    for (std::size_t length = 0; length < pixels_end; ++length) {
      EXPECT_NE(complaint(whole.substr(0, length)), "none")
          << name_of(format) << " cut at " << length;
    }
  }
}

TEST(Masks, AreNeverACrashWithAnyByteChanged) {
  for (const MaskFormat format : {MaskFormat::Pbm, MaskFormat::Pgm, MaskFormat::Png}) {
    const std::string whole = encode_mask(kSample, format);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const int change : {1, 0x20, 0x80, 0xff}) {
        std::string bytes = whole;
        bytes[i] = static_cast<char>(bytes[i] ^ change);
        try {
          const Mask mask = parse_mask(bytes, "m").mask;
          EXPECT_LE(mask.width, kMostMaskPixels);
          EXPECT_LE(mask.height, kMostMaskPixels);
        } catch (const BadInput&) {
        }
      }
    }
  }
}

TEST(Masks, AreRefusedByTheirHeadersBeforeAnythingIsAllocated) {
  EXPECT_EQ(complaint("P5 99999999999999999999 3 255\n"), "m: byte 3: the width is more than 4096");
  EXPECT_EQ(complaint("P4 4096 4097\n"), "m: byte 8: the height is more than 4096");
  EXPECT_NE(complaint("P5 4096 4096 255\n\x01").find("needs 16777216 bytes"), std::string::npos);
  std::string png = encode_mask(kSample, MaskFormat::Png);
  png[16] = 0x7f;  // width of 2 thousand million
  EXPECT_NE(complaint(png).find("byte 16"), std::string::npos);
}

TEST(Masks, AreRefusedWithTheirPlace) {
  EXPECT_EQ(complaint(""), "m: byte 0: neither a PBM nor a PGM nor a PNG file");
  EXPECT_EQ(complaint("\xff\xd8\xff\xe0"), "m: is a JPEG picture, not a PBM, PGM or PNG file");
  EXPECT_EQ(complaint("P6 1 1 255\nabc"), "m: byte 0: neither a PBM nor a PGM nor a PNG file");
  EXPECT_EQ(complaint("P5 0 1 255\n"), "m: byte 10: a picture without pixels");
  EXPECT_EQ(complaint("P2 1 1 9 -3"), "m: byte 9: not a number: a pixel");
  EXPECT_EQ(complaint("P2 1 1 9 10"), "m: byte 9: a pixel is more than 9");
  EXPECT_EQ(complaint("P1 2 1 0 2"), "m: byte 9: not a pixel");
  EXPECT_EQ(complaint("P1 1 1 0 1"), "m: byte 9: something follows the last pixel");
}

TEST(Grow, SetsTheEightNeighboursWithinThePicture) {
  EXPECT_EQ(grow(mask_of(4, 3, "#..........#")), mask_of(4, 3, "##..####..##"));
}

TEST(Resample, KeepsASquareOfAPowerOfTwo) {
  const Mask square = mask_of(2, 2, "#..#");
  EXPECT_EQ(resample(square, 1), square);
  EXPECT_EQ(resample(square, 2), mask_of(4, 4, "##..##....##..##"));
}

TEST(Resample, TakesThePixelAroundEachMiddle) {
  // Middles at 1/8, 3/8, 5/8, 7/8 of three pixels: pixels 0, 1, 1, 2.
  EXPECT_EQ(resample(mask_of(3, 1, "#.#"), 2), mask_of(4, 4, "#..##..##..##..#"));
}

}  // namespace
}  // namespace spoctree
