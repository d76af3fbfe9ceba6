// Where chunks are cut, and that it does not matter to the reader.
#include <gtest/gtest.h>

#include "common/base/errors.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "common/wire/stream_messages.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

const SourceInfo kSource{"mm", "piece.off", 0x1234, "max-depth=12"};

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
