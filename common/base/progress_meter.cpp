#include "common/base/progress_meter.hpp"

#include <algorithm>

namespace spoctree {

namespace {
constexpr double kStep = 1e-3;
}

void ProgressMeter::add(double share) {
  if (!report_) return;
  if (done_.fetch_add(share, std::memory_order_relaxed) + share < next_) return;
  const std::unique_lock lock(reporting_, std::try_to_lock);
  if (!lock) return;
  const double done = done_;
  if (done < next_) return;  // another thread has just reported it
  next_ = done + kStep;
  report_(std::min(done, 1.0));
}

}  // namespace spoctree
