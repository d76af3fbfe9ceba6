// encode_stream and StreamDecoder on trees made by hand.
#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/stream_messages.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

const SourceInfo kSource{"mm", "piece.off", 0x1234, "max-depth=12"};

std::vector<FrameType> types_of(std::string_view stream) {
  std::vector<FrameType> types;
  for (const FrameView& frame : frames_of(stream)) types.push_back(frame.type);
  return types;
}

TEST(SampleTrees, AreValid) {
  EXPECT_TRUE(validate(cube_tree()).empty());
  EXPECT_EQ(validate(every_kind_tree()), std::vector<std::string>{});
  EXPECT_TRUE(validate(many_planes_tree(1000)).empty());
}

TEST(EncodeStream, SendsHeaderThenChunksAndAnEndPerLevel) {
  using enum FrameType;
  EXPECT_EQ(types_of(encode_stream(every_kind_tree(), kSource)),
            (std::vector{Header, Chunk, LevelEnd, Chunk, LevelEnd, Chunk, LevelEnd}));
}

TEST(EncodeStream, WritesTheColumnsOfTheProtocol) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const auto frames = frames_of(stream);
  const Columns<std::string> root = columns_of(frames[1]);
  EXPECT_EQ(root.kinds, "\x02");
  EXPECT_EQ(root.counts, "\x01");
  EXPECT_EQ(root.references, std::string(1, '\0'));  // the next new plane
  ASSERT_EQ(root.planes.size(), 32u);
  // +x at 0.5: 1.0 is 0x3ff0..., 0.5 is 0x3fe0..., little-endian.
  EXPECT_EQ(root.planes.substr(0, 8), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
  EXPECT_EQ(root.planes.substr(24), std::string("\0\0\0\0\0\0\xe0\x3f", 8));

  // Planes 1 | 2 1 | - | 3 1 4 | 4 5, seen from 1 on: distances back from the next new one.
  const Columns<std::string> middle = columns_of(frames[3]);
  EXPECT_EQ(middle.kinds, std::string("\0\x03\x04\x02\x05\x01\x03\x01", 8));
  EXPECT_EQ(middle.counts, std::string("\x01\x02\x00\x03\x02", 5));
  EXPECT_EQ(middle.references, std::string("\0\0\x02\0\x03\0\x01\0", 8));
  EXPECT_EQ(middle.expressions, std::string("\x02\x04\x01\x00\x03\x00\x01", 7));
  EXPECT_EQ(middle.planes.size(), 5 * 32u);
}

TEST(EncodeStream, AnnouncesTreeAndSource) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const StreamInfo info = open_header(frames_of(stream)[0]);
  EXPECT_EQ(info.universe, every_kind_tree().universe);
  EXPECT_EQ(info.level_count, 3u);
  EXPECT_EQ(info.plane_count, 8u);
  EXPECT_EQ(info.node_count, 17u);
  EXPECT_EQ(info.source, kSource);
}

TEST(EncodeStream, MakesTextsPrintable) {
  SourceInfo source = kSource;
  source.name = "a\x1b" + std::string(300, 'n');
  const std::string stream = encode_stream(cube_tree(), source);
  EXPECT_EQ(open_header(frames_of(stream)[0]).source.name, "a?" + std::string(253, 'n'));
}

TEST(EncodeStream, RefusesAStatementThatIsNoNumber) {
  Octree tree = cube_tree();
  tree.levels[0].statement.error_bound = -1;
  EXPECT_THROW(encode_stream(tree, kSource), BadInput);
  tree.levels[0].statement.error_bound = NAN;
  EXPECT_THROW(encode_stream(tree, kSource), BadInput);
}

TEST(EncodeStream, RefusesAnExpressionTooDeep) {
  Octree tree = cube_tree();
  const std::uint32_t planes[] = {0, 1, 2, 3, 4, 5};
  const auto nested = [&](std::uint32_t depth) {
    std::vector<std::uint32_t> tokens(depth, kFirstPlaneToken);
    tokens.insert(tokens.end(), depth + 1, kInToken);
    tree.levels[0] = {};
    tree.levels[0].append(NodeKind::Vertex, planes, tokens);
    EXPECT_TRUE(validate(tree).empty());
  };
  nested(kMaxExpressionDepth);
  EXPECT_TRUE(are_equal(decode_stream(encode_stream(tree, kSource)), tree));
  nested(kMaxExpressionDepth + 1);
  EXPECT_THROW(encode_stream(tree, kSource), BadInput);
}

TEST(DecodeStream, GivesTheTreeBack) {
  for (const Octree& tree : {cube_tree(), every_kind_tree()}) {
    const Octree again = decode_stream(encode_stream(tree, kSource));
    EXPECT_TRUE(are_equal(tree, again));
    EXPECT_EQ(validate(again), std::vector<std::string>{});
  }
}

TEST(DecodeStream, GivesTheFirstLevels) {
  const Octree tree = every_kind_tree();
  const std::string stream = encode_stream(tree, kSource);
  for (std::uint32_t levels = 1; levels <= 3; ++levels) {
    const Octree prefix = decode_stream(stream, levels);
    EXPECT_EQ(prefix.levels.size(), levels);
    EXPECT_EQ(validate(prefix), std::vector<std::string>{});
    EXPECT_EQ(prefix.levels.back().statement, tree.levels[levels - 1].statement);
  }
}

TEST(StreamDecoder, KnowsAfterEveryFrameWhereItIs) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  StreamDecoder decoder;
  EXPECT_FALSE(decoder.has_info());
  std::uint64_t level_begin = 0;
  for (const FrameView& frame : frames_of(stream)) {
    decoder.accept(frame);
    const std::uint64_t end = frame.offset + frame.bytes.size();
    EXPECT_EQ(decoder.resume_point(), (ResumePoint{end, hash_bytes(stream.substr(0, end))}));
    if (!decoder.tree().levels.empty()) {
      EXPECT_EQ(validate(decoder.tree()), std::vector<std::string>{});
    }
    if (frame.type == FrameType::Chunk) {
      EXPECT_EQ(decoder.arrived_nodes(), decoder.expected_nodes());
    } else if (frame.type == FrameType::LevelEnd) {
      EXPECT_EQ(decoder.arrived_nodes(), 0u);
      EXPECT_EQ(decoder.level_bytes().back(), (LevelBytes{end - level_begin, end}));
      level_begin = end;
    }
    EXPECT_EQ(decoder.is_complete(), end == stream.size());
  }
  EXPECT_EQ(decoder.expected_nodes(), 0u);
  EXPECT_EQ(decoder.level_bytes().size(), 3u);
}

TEST(StreamDecoder, GoesOnWhereAFirstConnectionBroke) {
  const Octree tree = random_tree(5);
  const std::string stream = encode_stream(tree, kSource);
  StreamDecoder decoder;
  FrameReader first;
  first.feed(stream.substr(0, stream.size() / 2));
  while (const auto frame = first.next()) decoder.accept(*frame);
  const ResumePoint held = decoder.resume_point();
  FrameReader second(kMaxPayloadBytes, first.number(), held.byte);
  second.feed(stream.substr(held.byte));
  while (const auto frame = second.next()) decoder.accept(*frame);
  EXPECT_TRUE(decoder.is_complete());
  EXPECT_TRUE(are_equal(decoder.tree(), tree));
}

TEST(StreamDecoder, ReadsAFrameAtAnyAddress) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  for (std::size_t shift = 0; shift < 8; ++shift) {
    const std::string shifted = std::string(shift, ' ') + stream;
    EXPECT_TRUE(
        are_equal(decode_stream(std::string_view(shifted).substr(shift)), every_kind_tree()));
  }
}

TEST(StreamDecoder, RefusesFramesOutOfOrder) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const auto frames = frames_of(stream);
  const auto joined = [&](std::initializer_list<int> numbers) {
    std::string joint;
    for (const int number : numbers) joint += frames[static_cast<std::size_t>(number)].bytes;
    return joint;
  };
  for (const std::string& bad :
       {joined({1}), joined({2}), joined({0, 0}), joined({0, 2}), joined({0, 1, 1}),
        joined({0, 1, 3}), joined({0, 1, 4}), joined({0, 1, 2, 2}), joined({0, 1, 2, 5}),
        joined({0, 1, 2, 4}), joined({0, 1, 2, 3, 4, 5, 4})}) {
    EXPECT_NE(complaint_about(bad).find("frame "), std::string::npos);
  }
}

TEST(StreamDecoder, RefusesAFrameAfterTheEnd) {
  const std::string stream = encode_stream(cube_tree(), kSource);
  StreamDecoder decoder;
  const auto frames = frames_of(stream);
  for (const FrameView& frame : frames) decoder.accept(frame);
  EXPECT_THROW(decoder.accept(frames.back()), BadInput);
  EXPECT_TRUE(are_equal(decoder.tree(), cube_tree()));
}

TEST(StreamDecoder, KeepsItsTreeAndRefusesEverythingAfterABadFrame) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const auto frames = frames_of(stream);
  StreamDecoder decoder;
  for (int i = 0; i < 3; ++i) decoder.accept(frames[static_cast<std::size_t>(i)]);
  EXPECT_THROW(decoder.accept(frames[0]), BadInput);
  EXPECT_THROW(decoder.accept(frames[3]), BadInput);
  EXPECT_EQ(decoder.tree().levels.size(), 1u);
  EXPECT_EQ(validate(decoder.tree()), std::vector<std::string>{});
}

}  // namespace
}  // namespace spoctree
