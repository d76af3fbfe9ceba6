#include "common/wire/frame.hpp"

#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "common/wire/hash.hpp"

namespace spoctree {
namespace {

// The published value of the reference implementation.
TEST(Hash, IsXxh3) {
  EXPECT_EQ(hash_bytes(""), 0x2d06800538d394c2u);
  EXPECT_EQ(to_hex(hash_bytes("")), "2d06800538d394c2");
  EXPECT_EQ(to_hex(0xab), "00000000000000ab");
}

TEST(Hash, OfPiecesIsThatOfTheWhole) {
  const std::string bytes(1000, 'x');
  Hasher hasher;
  EXPECT_EQ(hasher.hash(), hash_bytes(""));
  for (std::size_t at = 0; at < bytes.size(); at += 7) hasher.add(bytes.substr(at, 7));
  EXPECT_EQ(hasher.hash(), hash_bytes(bytes));
}

TEST(Frame, HasTheDocumentedBytes) {
  const std::string payload = "0123456789abcdef";
  const std::string frame = seal_frame(FrameType::LevelEnd, payload);
  ASSERT_EQ(frame.size(), 32u);
  EXPECT_EQ(frame.substr(0, 8), std::string("SPO\x03\x10\0\0\0", 8));
  EXPECT_EQ(frame.substr(16), payload);
  std::uint64_t checksum = 0;
  for (std::size_t i = 8; i-- > 0;) {
    checksum = checksum << 8 | static_cast<unsigned char>(frame[8 + i]);
  }
  EXPECT_EQ(checksum, hash_bytes(payload, 0x00000010'034f5053u));
}

TEST(Frame, IsReadBackWithItsPlaceInTheStream) {
  const std::string bytes = seal_frame(FrameType::Catalog, "01234567") + "rest";
  const auto frame = read_frame(bytes, 4, 100);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->type, FrameType::Catalog);
  EXPECT_EQ(frame->payload, "01234567");
  EXPECT_EQ(frame->bytes.size(), 24u);
  EXPECT_EQ(frame->where(), "frame 4 at byte 100: ");
}

TEST(Frame, WaitsForMoreBytesOnEveryTruncation) {
  const std::string bytes = seal_frame(FrameType::Chunk, std::string(40, 'p'));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_frame(std::string_view(bytes).substr(0, size), 0, 0)) << size;
  }
}

TEST(Frame, EveryChangedByteIsNoticedOrAsksForMore) {
  const std::string good = seal_frame(FrameType::Chunk, std::string(40, 'p'));
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ (1 << bit));
      try {
        EXPECT_FALSE(read_frame(bad, 0, 0)) << at;  // a longer length: more bytes are needed
      } catch (const BadInput&) {
      }
    }
  }
}

TEST(Frame, RefusesALengthBeforeItsPayloadArrives) {
  std::string bytes = seal_frame(FrameType::Request, std::string(2048, 'p')).substr(0, 8);
  EXPECT_FALSE(read_frame(bytes, 0, 0));
  EXPECT_THROW(read_frame(bytes, 0, 0, kMaxRequestPayloadBytes), BadInput);
  bytes.replace(4, 4, std::string("\xff\xff\xff\x7f", 4));
  EXPECT_THROW(read_frame(bytes, 0, 0), BadInput);
  EXPECT_THROW(read_frame("HTTP/1.1 400 Bad Request\r\n", 0, 0), BadInput);
}

TEST(FrameReader, GivesTheSameFramesHoweverTheBytesArrive) {
  std::string stream;
  for (int i = 0; i < 20; ++i) {
    stream += seal_frame(FrameType::Chunk, std::string(8 * static_cast<std::size_t>(i), 'a'));
  }
  for (const std::size_t piece : {1u, 3u, 16u, 17u, 100u, 5000u}) {
    FrameReader reader;
    std::string again;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      reader.feed(std::string_view(stream).substr(at, piece));
      while (const auto frame = reader.next()) {
        EXPECT_EQ(frame->offset, again.size());
        again += frame->bytes;
      }
    }
    EXPECT_EQ(again, stream);
    EXPECT_EQ(reader.number(), 20u);
    EXPECT_EQ(reader.offset(), stream.size());
    EXPECT_EQ(reader.pending_bytes(), 0u);
  }
}

TEST(FrameReader, CountsFromWhereTheStreamIsEntered) {
  FrameReader reader(kMaxPayloadBytes, 7, 1000);
  reader.feed(seal_frame(FrameType::Chunk, "01234567") + "SP");
  const auto frame = reader.next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->number, 7u);
  EXPECT_EQ(frame->offset, 1000u);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.pending_bytes(), 2u);
  reader.feed("X");
  EXPECT_THROW(reader.next(), BadInput);
  EXPECT_THROW(reader.next(), BadInput);
}

}  // namespace
}  // namespace spoctree
