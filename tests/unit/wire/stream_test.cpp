// encode_stream and StreamDecoder on trees made by hand.
#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/stream_messages.hpp"
#include "common/wire/varint.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

const SourceInfo kSource{"mm", "piece.off", 0x1234, "max-depth=12"};

std::string complaint_about(std::string_view stream) {
  try {
    decode_stream(stream);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

std::vector<FrameType> types_of(std::string_view stream) {
  std::vector<FrameType> types;
  for (const FrameView& frame : frames_of(stream)) types.push_back(frame.type);
  return types;
}

Columns<std::string> columns_of(const FrameView& chunk) {
  Columns<std::string> columns;
  open_chunk(chunk, [&](const Columns<std::string_view>& view) {
    columns = {std::string(view.kinds), std::string(view.planes), std::string(view.counts),
               std::string(view.references), std::string(view.expressions)};
  });
  return columns;
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

/// Columns that a hostile sender could write for a root, and what the decoder says.
class HostileRoot : public testing::Test {
 protected:
  Columns<std::string> good_ = columns_of(frames_of(stream_)[1]);
  std::string complaint(const Columns<std::string>& columns) {
    return complaint_about(std::string(frames_of(stream_)[0].bytes) + seal_chunk(columns) +
                           std::string(frames_of(stream_)[2].bytes));
  }
  inline static const std::string stream_ = encode_stream(cube_tree(), kSource);
};

TEST_F(HostileRoot, IsAcceptedAsItWas) { EXPECT_EQ(complaint(good_), ""); }

TEST_F(HostileRoot, NamesFrameByteLevelAndNode) {
  Columns<std::string> columns = good_;
  columns.kinds = "\x06";
  const std::size_t byte = frames_of(stream_)[1].offset;
  EXPECT_EQ(complaint(columns),
            "frame 1 at byte " + std::to_string(byte) + ": level 0: node 0: unknown kind 6");
}

TEST_F(HostileRoot, MustNotReferBeyondThePlanesThatArrived) {
  Columns<std::string> columns = good_;
  columns.references[1] = 2;  // before the first plane
  EXPECT_NE(complaint(columns), "");
  columns = good_;
  columns.planes.resize(5 * 32);  // the sixth has not arrived
  EXPECT_NE(complaint(columns).find("has not arrived"), std::string::npos);
}

TEST_F(HostileRoot, MustNotRepeatAPlane) {
  Columns<std::string> columns = good_;
  columns.references = std::string("\0\x01\0\0\0\0", 6);
  EXPECT_NE(complaint(columns).find("repeated"), std::string::npos);
}

TEST_F(HostileRoot, MustNotAnnounceMorePlanesThanTheHeader) {
  Columns<std::string> columns = good_;
  columns.counts = "\xff\xff\xff\xff\x0f";
  EXPECT_NE(complaint(columns).find("4294967295 planes"), std::string::npos);
  columns = good_;
  columns.planes += columns.planes.substr(0, 32);
  EXPECT_NE(complaint(columns).find("announced"), std::string::npos);
}

TEST_F(HostileRoot, MustHaveUnitNormalsOnTheGrid) {
  for (const double bad : {2.0, 0.5, std::ldexp(1.0, -60), double(NAN), double(INFINITY)}) {
    Columns<std::string> columns = good_;
    columns.planes.replace(0, 8, reinterpret_cast<const char*>(&bad), 8);
    EXPECT_NE(complaint(columns).find("plane 0"), std::string::npos) << bad;
  }
}

TEST_F(HostileRoot, MustHaveColumnsThatEndTogether) {
  using Column = std::string Columns<std::string>::*;
  for (const Column column :
       {&Columns<std::string>::kinds, &Columns<std::string>::planes, &Columns<std::string>::counts,
        &Columns<std::string>::references, &Columns<std::string>::expressions}) {
    Columns<std::string> longer = good_;
    (longer.*column).push_back('\x01');
    EXPECT_NE(complaint(longer), "");
    if ((good_.*column).empty()) continue;
    Columns<std::string> shorter = good_;
    (shorter.*column).pop_back();
    EXPECT_NE(complaint(shorter), "");
  }
  EXPECT_NE(complaint({}).find("empty chunk"), std::string::npos);
}

TEST_F(HostileRoot, MustHaveEnoughPlanesForItsKind) {
  Columns<std::string> columns = good_;
  columns.kinds = "\x01";  // BLACK: takes no count and no references
  EXPECT_NE(complaint(columns), "");
  columns = good_;
  columns.counts = std::string(1, '\0');
  EXPECT_NE(complaint(columns).find("convex node without planes"), std::string::npos);
}

TEST_F(HostileRoot, MustHaveAnExpressionOverItsOwnPlanes) {
  Columns<std::string> columns = good_;
  columns.kinds = "\x05";
  columns.expressions = std::string("\x07\x01\x00", 3);
  EXPECT_EQ(complaint(columns), "");
  columns.expressions = std::string("\x08\x01\x00", 3);  // a seventh plane
  EXPECT_NE(complaint(columns).find("does not have"), std::string::npos);
  columns.expressions = std::string("\x07\x01", 2);  // goes on in the next chunk: none comes
  EXPECT_NE(complaint(columns), "");
}

TEST_F(HostileRoot, MustNotHaveAnEndlessExpression) {
  Columns<std::string> columns = good_;
  columns.kinds = "\x05";
  columns.expressions = std::string(kMaxExpressionDepth + 1, '\x02');
  EXPECT_NE(complaint(columns).find("too deep"), std::string::npos);
}

TEST(StreamDecoder, RefusesAnExpressionThatGrowsOverManyChunks) {
  const std::string stream = encode_stream(cube_tree(), kSource);
  StreamDecoder decoder;
  decoder.accept(frames_of(stream)[0]);
  Columns<std::string> columns = columns_of(frames_of(stream)[1]);
  columns.kinds = "\x05";
  const auto send_chunks = [&] {
    for (int i = 0; i < 100; ++i) {
      columns.expressions.clear();
      for (int split = 0; split < 1000; ++split) columns.expressions += std::string("\x02\x00", 2);
      decoder.accept(*read_frame(seal_chunk(columns), 0, 0));
      columns = {};
    }
  };
  EXPECT_THROW(send_chunks(), BadInput);
}

TEST(StreamDecoder, RefusesAHeaderBeyondTheLimits) {
  const std::string stream = encode_stream(cube_tree(), kSource);
  const StreamInfo good = open_header(frames_of(stream)[0]);
  const auto is_refused = [](const StreamInfo& info) {
    const std::string header = seal_header(info);
    EXPECT_THROW(open_header(*read_frame(header, 0, 0)), BadInput);
  };
  StreamInfo bad = good;
  bad.level_count = kMaxLevels + 1;
  is_refused(bad);
  bad.level_count = 0;
  is_refused(bad);
  bad = good;
  bad.plane_count = kMaxPlanes + 1;
  is_refused(bad);
  bad = good;
  bad.node_count = UINT32_MAX;
  is_refused(bad);
  bad = good;
  bad.universe.half_side = 0.3;
  is_refused(bad);
  bad = good;
  bad.universe.center.y = NAN;
  is_refused(bad);
  bad = good;
  bad.source.name = "\x1b[2J";
  is_refused(bad);
  bad = good;
  bad.source.build_options = std::string(kMaxBuildOptionsBytes + 1, 'x');
  is_refused(bad);
}

TEST(StreamDecoder, RefusesALevelEndThatDisagrees) {
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const auto frames = frames_of(stream);
  const LevelEnd good = open_level_end(frames[2]);
  const auto is_refused = [&](const LevelEnd& end) {
    EXPECT_NE(complaint_about(std::string(frames[0].bytes) + std::string(frames[1].bytes) +
                              seal_level_end(end) + stream.substr(frames[3].offset)),
              "");
  };
  LevelEnd bad = good;
  bad.level = 1;
  is_refused(bad);
  bad = good;
  bad.is_last = true;
  is_refused(bad);
  bad = good;
  bad.node_count = 2;
  is_refused(bad);
  bad = good;
  bad.plane_count = 0;
  is_refused(bad);
  bad = good;
  bad.statement.outer_volume = INFINITY;
  is_refused(bad);
}

TEST(StreamDecoder, RefusesHeadersThatMiscountTheWholeTree) {
  const Octree tree = every_kind_tree();
  const std::string stream = encode_stream(tree, kSource);
  const auto frames = frames_of(stream);
  const StreamInfo good = open_header(frames[0]);
  const auto is_refused = [&](const StreamInfo& info) {
    EXPECT_NE(complaint_about(seal_header(info) + stream.substr(frames[1].offset)), "");
  };
  for (const std::uint32_t levels : {1u, 2u, 4u}) {
    StreamInfo bad = good;
    bad.level_count = levels;
    is_refused(bad);
  }
  for (const std::uint32_t planes : {0u, 7u, 9u}) {
    StreamInfo bad = good;
    bad.plane_count = planes;
    is_refused(bad);
  }
  for (const std::uint32_t nodes : {1u, 16u, 18u}) {
    StreamInfo bad = good;
    bad.node_count = nodes;
    is_refused(bad);
  }
}

TEST(Chunks, CarryARootOfTenThousandPlanes) {
  const Octree tree = many_planes_tree(10'000);
  const std::string stream = encode_stream(tree, kSource);
  std::size_t chunks = 0;
  for (const FrameView& frame : frames_of(stream)) {
    EXPECT_LE(frame.bytes.size(), kMaxFrameBytes);
    chunks += frame.type == FrameType::Chunk;
  }
  // 33 bytes a plane, so 5 chunks of 65,400 bytes hold 9,909 of them.
  EXPECT_EQ(chunks, 6u);
  EXPECT_TRUE(are_equal(decode_stream(stream), tree));
}

TEST(Chunks, KeepASmallNodeTogether) {
  // Nodes of 1 + 1 + 5 * 33 bytes: 391 of them fill 65,297 bytes of a chunk; the next stands in
  // the chunk after it, whole.
  Octree tree = cube_tree();
  tree.planes.clear();
  tree.levels[0] = {};
  tree.levels[0].append(NodeKind::Grey, {});
  Random random(1);
  std::vector<std::uint32_t> all_grey{0};
  std::size_t leaves = 0;
  for (int depth = 1; depth <= 3; ++depth) {
    Level level;
    for (std::uint32_t i = 0; i < 8 * tree.levels.back().grey_count; ++i) {
      if (depth < 3) {
        level.append(NodeKind::Grey, {});
        continue;
      }
      std::vector<std::uint32_t> planes;
      for (int k = 0; k < 5; ++k) {
        planes.push_back(static_cast<std::uint32_t>(tree.planes.size()));
        tree.planes.push_back(random_plane(random, Vec3(0.0), 0.5));
      }
      level.append(NodeKind::Convex, planes);
      ++leaves;
    }
    tree.levels.push_back(level);
  }
  ASSERT_EQ(leaves, 512u);
  const std::string stream = encode_stream(tree, kSource);
  const auto frames = frames_of(stream);
  ASSERT_EQ(frames.size(), 1 + 3 * 2 + 3u);
  EXPECT_EQ(columns_of(frames[7]).kinds.size(), 391u);
  EXPECT_EQ(columns_of(frames[7]).references.size(), 391u * 5);
  EXPECT_EQ(columns_of(frames[8]).kinds.size(), 121u);
  EXPECT_TRUE(are_equal(decode_stream(stream), tree));
}

TEST(Chunks, MayBeCutAnywhereBetweenTheNumbersOfANode) {
  // The protocol lets other senders cut where ours does not: here after every number.
  const std::string stream = encode_stream(every_kind_tree(), kSource);
  const auto frames = frames_of(stream);
  std::string cut;
  for (const FrameView& frame : frames) {
    if (frame.type != FrameType::Chunk) {
      cut += frame.bytes;
      continue;
    }
    const Columns<std::string> all = columns_of(frame);
    Columns<std::string> planes_only;
    planes_only.planes = all.planes;
    if (!all.planes.empty()) cut += seal_chunk(planes_only);
    std::size_t count_at = 0, reference_at = 0, token_at = 0;
    for (const char kind : all.kinds) {
      Columns<std::string> start;
      start.kinds = kind;
      const bool homogeneous = kind < 2;
      std::size_t references = 0;
      if (!homogeneous) {
        references = static_cast<std::size_t>(all.counts[count_at]);
        start.counts = all.counts[count_at++];
      }
      cut += seal_chunk(start);
      for (std::size_t i = 0; i < references; ++i) {
        Columns<std::string> reference;
        reference.references = all.references[reference_at++];
        cut += seal_chunk(reference);
      }
      for (std::size_t i = 0; kind == 5 && i < all.expressions.size(); ++i) {
        Columns<std::string> token;
        token.expressions = all.expressions[token_at++];
        cut += seal_chunk(token);
      }
    }
  }
  EXPECT_GT(frames_of(cut).size(), 40u);
  EXPECT_TRUE(are_equal(decode_stream(cut), every_kind_tree()));
}

}  // namespace
}  // namespace spoctree
