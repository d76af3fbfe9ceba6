// The same bytes, whoever does the work: any number of threads, any size of a thread's share.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "common/wire/encode.hpp"
#include "server/build/certify.hpp"
#include "server/build/order_free_sum.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/model_solid.hpp"
#include "tests/unit/build/cells.hpp"

namespace spoctree {
namespace {

/// Everything that a build makes, in one string.
std::string all_of(const Solid& solid, const BuildOptions& options) {
  const SolidQueries queries(solid);
  BuiltOctree built = build_octree(solid, queries, options);
  certify(built, solid, queries);
  std::string text = encode_stream(built.tree, {}) + std::to_string(built.depth_limited_nodes);
  for (const auto& witnesses : built.witnesses) {
    for (const std::uint32_t witness : witnesses) text += ' ' + std::to_string(witness);
  }
  return text;
}

std::vector<Solid> solids() {
  std::vector<Solid> solids;
  solids.push_back(model_solid("sphere", 40));
  Random random(1);
  solids.push_back(uneven_solid(8, random));
  solids.push_back(voxel_solid(random_voxels(3, random)));
  solids.push_back(box_solid(Vec3(-0.5), Vec3(0.5)));
  return solids;
}

TEST(Threads, AnyNumberOfThemBuildsTheSameBytes) {
  for (const Solid& solid : solids()) {
    for (const std::uint32_t max_depth : {std::uint32_t{kMaxDepth}, std::uint32_t{3}}) {
      BuildOptions options;
      options.rules = SpRules{0, max_depth};
      options.fragments_per_job = 32;
      std::string one;
      for (const std::size_t threads : {1, 2, 3, 8}) {
        const oneapi::tbb::global_control limit(
            oneapi::tbb::global_control::max_allowed_parallelism, threads);
        const std::string bytes = all_of(solid, options);
        if (one.empty()) one = bytes;
        EXPECT_TRUE(bytes == one) << threads << " threads";
      }
    }
  }
}

TEST(Threads, AnyShareOfAThreadMakesTheSameBytes) {
  for (const Solid& solid : solids()) {
    BuildOptions options;
    options.fragments_per_job = static_cast<std::size_t>(-1);
    const std::string whole = all_of(solid, options);
    for (const std::size_t share : {0, 1, 7, 100}) {
      options.fragments_per_job = share;
      EXPECT_TRUE(all_of(solid, options) == whole) << share << " fragments";
    }
  }
}

TEST(Threads, ReportsComeOneAtATimeAndGrowToTheWhole) {
  const Solid solid = model_solid("sphere", 40);
  const SolidQueries queries(solid);
  BuildOptions options;
  options.fragments_per_job = 16;
  std::atomic<int> reporting = 0;
  double last = 0;
  options.progress = [&](double fraction) {
    EXPECT_EQ(++reporting, 1);
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    --reporting;
  };
  build_octree(solid, queries, options);
  EXPECT_GT(last, 0.9);
}

TEST(Threads, ASumIsTheSameInAnyOrder) {
  Random random(1);
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) {
    values.push_back(random.between(-1, 1) * std::pow(2, random.between(-60, 3)));
  }
  OrderFreeSum forwards;
  OrderFreeSum backwards;
  long double truth = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    forwards.add(values[i]);
    backwards.add(values[values.size() - 1 - i]);
    truth += values[i];
  }
  EXPECT_EQ(forwards.value(), backwards.value());
  EXPECT_NEAR(forwards.value(), static_cast<double>(truth), 1e-15);
}

}  // namespace
}  // namespace spoctree
