// What holds for every tree and every damage: decoding undoes encoding; bad bytes are refused, and
// what is accepted is a valid tree.
#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"
#include "common/wire/spo_writer.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

const SourceInfo kSource{"mm", "piece.off", 0x1234, ""};
const std::vector<std::string> kNothing;

Octree tree_of_seed(std::uint64_t seed) {
  RandomTreeOptions options;
  options.levels = 1 + seed % 7;
  options.grey_chance = 0.2 + 0.1 * static_cast<double>(seed % 5);
  options.max_planes_per_node = static_cast<std::uint32_t>(1 + seed % 9);
  return random_tree(seed, options);
}

TEST(RandomTree, IsValidAndTheSameEveryTime) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Octree tree = tree_of_seed(seed);
    ASSERT_EQ(validate(tree), kNothing) << seed;
    ASSERT_TRUE(tree.is_complete());
    ASSERT_TRUE(are_equal(tree, tree_of_seed(seed)));
  }
}

TEST(Wire, DecodingUndoesEncoding) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Octree tree = tree_of_seed(seed);
    const std::string stream = encode_stream(tree, kSource);
    ASSERT_EQ(stream, encode_stream(tree, kSource));
    ASSERT_TRUE(are_equal(decode_stream(stream), tree)) << seed;
  }
}

TEST(Wire, EveryPrefixOfLevelsIsAValidTree) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Octree tree = tree_of_seed(seed);
    const std::string stream = encode_stream(tree, kSource);
    for (std::uint32_t levels = 1; levels <= tree.levels.size(); ++levels) {
      ASSERT_EQ(validate(decode_stream(stream, levels)), kNothing) << seed << " " << levels;
    }
  }
}

TEST(Wire, ALargeTreeTakesManyChunks) {
  RandomTreeOptions options;
  options.levels = 9;
  options.max_nodes = 60'000;
  const Octree tree = random_tree(3, options);
  const std::string stream = encode_stream(tree, kSource);
  EXPECT_GT(frames_of(stream).size(), 30u);
  for (const FrameView& frame : frames_of(stream)) {
    EXPECT_LE(frame.bytes.size(), kMaxFrameBytes);
  }
  const Octree again = decode_stream(stream);
  EXPECT_TRUE(are_equal(again, tree));
  EXPECT_EQ(validate(again), kNothing);
}

TEST(Wire, AStreamCutOffAnywhereIsRefused) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  for (std::size_t size = 0; size < stream.size(); ++size) {
    ASSERT_THROW(decode_stream(std::string_view(stream).substr(0, size)), BadInput) << size;
  }
}

TEST(Wire, AFileCutOffAnywhereIsRefused) {
  const std::string file = encode_spo(every_kind_tree(), kSource);
  for (std::size_t size = 0; size < file.size(); ++size) {
    ASSERT_THROW(SpoFile(std::string_view(file).substr(0, size), "file"), BadInput) << size;
  }
}

TEST(Wire, AFileWithAnyByteChangedIsRefused) {
  const std::string good = encode_spo(every_kind_tree(), kSource);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int change : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ change);
      ASSERT_THROW(SpoFile(bad, "file"), BadInput) << at;
    }
  }
}

TEST(Wire, AStreamWithAnyByteChangedIsRefused) {
  const std::string good = encode_stream(every_kind_tree(), kSource);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int change : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ change);
      ASSERT_THROW(decode_stream(bad), BadInput) << at;
    }
  }
}

/// `good` with the payload of one frame replaced and the checksum made right again.
std::string resealed(std::string_view stream, const FrameView& frame, std::string_view payload) {
  return std::string(stream.substr(0, frame.offset)) + seal_frame(frame.type, payload) +
         std::string(stream.substr(frame.offset + frame.bytes.size()));
}

/// Decodes hostile bytes; whatever is accepted must be a valid tree.
void decode_hostile(std::string_view stream) {
  StreamDecoder decoder;
  try {
    for (const FrameView& frame : frames_of(stream)) decoder.accept(frame);
  } catch (const BadInput&) {
  }
  if (!decoder.tree().levels.empty()) {
    ASSERT_EQ(validate(decoder.tree()), kNothing);
  }
}

TEST(HostileStream, WithOneByteOfAMessageChangedGivesNoInvalidTree) {
  const std::string good = encode_stream(every_kind_tree(), kSource);
  for (const FrameView& frame : frames_of(good)) {
    for (std::size_t at = 0; at < frame.payload.size(); ++at) {
      for (const int change : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
        std::string payload(frame.payload);
        payload[at] = static_cast<char>(payload[at] ^ change);
        decode_hostile(resealed(good, frame, payload));
      }
    }
  }
}

TEST(HostileStream, WithAMessageCutOffGivesNoInvalidTree) {
  const std::string good = encode_stream(every_kind_tree(), kSource);
  for (const FrameView& frame : frames_of(good)) {
    for (std::size_t size = 0; size < frame.payload.size(); size += 8) {
      decode_hostile(resealed(good, frame, frame.payload.substr(0, size)));
      // The same with a segment table that agrees.
      if (size < 8) continue;
      std::string payload(frame.payload.substr(0, size));
      payload[4] = static_cast<char>(size / 8 - 1);
      payload[5] = 0;
      decode_hostile(resealed(good, frame, payload));
    }
  }
}

TEST(HostileStream, WithManyChangesGivesNoInvalidTree) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const std::string good = encode_stream(tree_of_seed(seed % 20), kSource);
    std::string stream = good;
    for (std::uint32_t i = 1 + random.below(4); i-- > 0;) {
      const auto frames = frames_of(stream);
      const FrameView& frame = frames[random.below(static_cast<std::uint32_t>(frames.size()))];
      std::string payload(frame.payload);
      if (payload.empty()) continue;
      for (std::uint32_t k = 1 + random.below(3); k-- > 0;) {
        const std::uint32_t at = random.below(static_cast<std::uint32_t>(payload.size()));
        payload[at] = static_cast<char>(random.chance(0.5) ? random.below(8) : random.below(256));
      }
      stream = resealed(stream, frame, payload);
    }
    decode_hostile(stream);
  }
}

TEST(HostileStream, OfRandomFramesGivesNoInvalidTree) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const std::string one = encode_stream(tree_of_seed(seed % 20), kSource);
    const std::string other = encode_stream(tree_of_seed(seed % 20 + 1), kSource);
    auto frames = frames_of(one);
    for (const FrameView& frame : frames_of(other)) frames.push_back(frame);
    std::string stream(frames[0].bytes);
    for (int i = 0; i < 10; ++i) {
      stream += frames[random.below(static_cast<std::uint32_t>(frames.size()))].bytes;
    }
    decode_hostile(stream);
  }
}

TEST(HostileMessage, OfTheConversationIsRefusedOrRead) {
  const std::vector<CatalogEntry> entries{{"gear", 1, 2, 3, 4, 5, "mm", "gear.off"},
                                          {"shaft", 6, 7, 8, 9, 10, "", ""}};
  for (const std::string& good :
       {seal_request(ListRequest{}), seal_request(GetRequest{"gear", 3, {80, 5}}),
        seal_error({ErrorCode::Busy, "later"}), seal_catalog(entries)}) {
    const FrameView frame = read_frame(good, 0, 0).value();
    for (std::size_t at = 0; at < frame.payload.size(); ++at) {
      for (int value = 0; value < 256; ++value) {
        std::string payload(frame.payload);
        payload[at] = static_cast<char>(value);
        const std::string bytes = seal_frame(frame.type, payload);
        const FrameView bad = read_frame(bytes, 0, 0).value();
        try {
          std::vector<CatalogEntry> read;
          if (bad.type == FrameType::Request) open_request(bad);
          if (bad.type == FrameType::Error) open_error(bad);
          if (bad.type == FrameType::Catalog) open_catalog(bad, read);
          EXPECT_LE(read.size(), kMaxCatalogModels);
        } catch (const BadInput&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace spoctree
