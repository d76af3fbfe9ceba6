// Well-sealed frames that lie: each is refused, with the frame, the byte and the reason.
#include <gtest/gtest.h>

#include <cmath>

#include "common/base/errors.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/stream_messages.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

const SourceInfo kSource{"mm", "piece.off", 0x1234, "max-depth=12"};

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
  bad = good;
  bad.statement.inner_area = 2 * bad.statement.outer_area + 1;
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

}  // namespace
}  // namespace spoctree
