#include <gtest/gtest.h>

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
    EXPECT_EQ(parse_mask(encode_mask(kSample, format), "m"), kSample) << name_of(format);
}

TEST(Masks, AreReadFromPlainFormatsWithComments) {
  EXPECT_EQ(parse_mask("P1\n# a comment\n3 2\n0 1 1\n110", "m"), mask_of(3, 2, ".####."));
  EXPECT_EQ(parse_mask("P2 3 1 # wide\n9\n4 5 9\n", "m"), mask_of(3, 1, ".##"));
}

TEST(Masks, TakeHalfOfWhiteForTheObject) {
  EXPECT_EQ(parse_mask(std::string("P5 2 1 255\n\x7f\x80", 13), "m"), mask_of(2, 1, ".#"));
  EXPECT_EQ(parse_mask(std::string("P5 2 1 65535\n\x7f\xff\x80\x00", 17), "m"),
            mask_of(2, 1, ".#"));
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
          const Mask mask = parse_mask(bytes, "m");
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
