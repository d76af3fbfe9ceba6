// The bytes of the protocol's worked example: whoever changes them changes the protocol.
#include <gtest/gtest.h>

#include "common/wire/messages.hpp"
#include "common/wire/spo_writer.hpp"
#include "tests/support/frames.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/sample_trees.hpp"

namespace spoctree {
namespace {

TEST(Golden, FileOfACube) {
  const SourceInfo source{"mm", "cube.off", 0x0123456789abcdef, "max-depth=12"};
  const std::string dump = hex_dump(encode_spo(cube_tree(), source));
  expect_golden("cube.hex", dump);
  expect_shown("schemas/PROTOCOL.md", "cube.hex", "```\n" + dump + "```\n");
}

TEST(Golden, RequestForACube) {
  const std::string dump = hex_dump(seal_request(GetRequest{"cube", 1, {}}));
  expect_golden("get_cube.hex", dump);
  expect_shown("schemas/PROTOCOL.md", "get_cube.hex", "```\n" + dump + "```\n");
}

// A tree of every kind, of chunks that are cut inside a node, and of many levels: by their hashes,
// as the bytes would fill pages.
TEST(Golden, HashesOfStreams) {
  RandomTreeOptions large;
  large.levels = 8;
  large.max_nodes = 20'000;
  std::string lines;
  const auto add = [&](const char* name, const Octree& tree) {
    const std::string bytes = encode_spo(tree, {});
    lines += to_hex(hash_bytes(bytes)) + " " + std::to_string(bytes.size()) + " " + name + "\n";
  };
  add("every kind", every_kind_tree());
  add("10000 planes", many_planes_tree(10'000));
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    add(("random " + std::to_string(seed)).c_str(), random_tree(seed, large));
  }
  expect_golden("streams.txt", lines);
}

}  // namespace
}  // namespace spoctree
