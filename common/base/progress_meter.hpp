// Shares of work, done by any thread -> now and then, how much is done.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace spoctree {

/// Called with the fraction of some work that is done. May be empty. What it throws ends the work:
/// so long work is cancelled.
using ProgressReport = std::function<void(double fraction)>;

/// Adds up shares of some work, and reports the sum at most a thousand times: by one thread at a
/// time, never less than before, never more than 1. A thread that finds another one reporting goes
/// on with its work.
class ProgressMeter {
 public:
  /// REQUIRES: `report` outlives this.
  explicit ProgressMeter(const ProgressReport& report) : report_(report) {}

  /// Thread-safe, and cheap where nothing is to be reported. Throws what the report throws.
  void add(double share);

 private:
  const ProgressReport& report_;
  std::atomic<double> done_ = 0;
  std::atomic<double> next_ = 0;  ///< nothing is reported before this much is done
  std::mutex reporting_;
};

/// A share of the work that a meter adds up, handed down to who does it. Without a meter, nobody
/// wants to know.
class ProgressShare {
 public:
  ProgressShare() = default;
  /// REQUIRES: `meter` outlives this.
  explicit ProgressShare(ProgressMeter& meter, double share = 1) : meter_(&meter), share_(share) {}

  /// A share of this share.
  ProgressShare part(double fraction) const {
    ProgressShare part = *this;
    part.share_ *= fraction;
    return part;
  }
  /// As much more of it is done. Thread-safe; throws what the meter's report throws.
  void add(double fraction = 1) const {
    if (meter_ != nullptr) meter_->add(fraction * share_);
  }

 private:
  ProgressMeter* meter_ = nullptr;
  double share_ = 0;
};

/// For inner loops, one in each thread: tells every thousandth time or so.
class ProgressCounter {
 public:
  explicit ProgressCounter(const ProgressShare& share) : share_(share) {}

  /// As much more of the share is done. Throws what the meter's report throws.
  void add(double fraction) {
    waiting_ += fraction;
    if (++times_ == kTimes) tell();
  }
  /// Tells at once, after the last one. Throws likewise.
  void tell() {
    const double told = std::exchange(waiting_, 0);
    times_ = 0;
    share_.add(told);
  }

 private:
  static constexpr int kTimes = 1024;

  ProgressShare share_;
  double waiting_ = 0;
  int times_ = 0;
};

/// What each of so many items adds.
inline double per_item(std::size_t items) {
  return items == 0 ? 0 : 1 / static_cast<double>(items);
}

}  // namespace spoctree
