#include "common/base/progress_meter.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace spoctree {
namespace {

TEST(ProgressShare, AddsUpPartsOfParts) {
  std::vector<double> told;
  const ProgressReport report = [&](double fraction) { told.push_back(fraction); };
  ProgressMeter meter(report);
  const ProgressShare half = ProgressShare(meter).part(0.5);
  half.part(0.5).add();
  half.add(0.25);
  ProgressShare(meter).add(0.5);
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.375, 0.875}));
}

TEST(ProgressShare, TellsNobodyWithoutAMeter) {
  ProgressShare().part(0.5).add();
  ProgressCounter counter{ProgressShare()};
  for (int i = 0; i < 10'000; ++i) counter.add(1);
}

TEST(ProgressShare, ThrowsWhatTheReportThrows) {
  const ProgressReport report = [](double fraction) {
    if (fraction > 0.5) throw std::runtime_error("enough");
  };
  ProgressMeter meter(report);
  const ProgressShare all(meter);
  EXPECT_NO_THROW(all.add(0.5));
  EXPECT_THROW(all.add(0.25), std::runtime_error);
  // And again, whoever goes on.
  EXPECT_THROW(all.add(0.25), std::runtime_error);
}

TEST(ProgressCounter, TellsNowAndThenAndForgetsNothing) {
  std::vector<double> told;
  const ProgressReport report = [&](double fraction) { told.push_back(fraction); };
  ProgressMeter meter(report);
  ProgressCounter counter{ProgressShare(meter)};
  constexpr std::size_t kItems = std::size_t{1} << 20;
  for (std::size_t i = 0; i < kItems; ++i) counter.add(per_item(kItems));
  ASSERT_FALSE(told.empty());
  EXPECT_LE(told.size(), 1'024u);
  EXPECT_NEAR(told.back(), 1, 2e-3);
}

}  // namespace
}  // namespace spoctree
