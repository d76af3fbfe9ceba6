#include "client/source/throttle.hpp"

#include <algorithm>
#include <limits>
#include <thread>

namespace spoctree {

namespace {
constexpr std::chrono::milliseconds kBurst{100};
constexpr std::uint64_t kPortionsPerSecond = 20;
}  // namespace

std::size_t Throttle::portion() const {
  if (rate_ == 0) return std::numeric_limits<std::size_t>::max();
  return std::max<std::size_t>(rate_ / kPortionsPerSecond, 1);
}

void Throttle::spend(std::size_t bytes) {
  if (rate_ == 0) return;
  const std::chrono::duration<double> cost(static_cast<double>(bytes) / static_cast<double>(rate_));
  ready_ = std::max(ready_, std::chrono::steady_clock::now() - kBurst) +
           std::chrono::duration_cast<std::chrono::steady_clock::duration>(cost);
  std::this_thread::sleep_until(ready_);
}

}  // namespace spoctree
