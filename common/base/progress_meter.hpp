// Shares of work, done by any thread -> now and then, how much is done.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace spoctree {

/// Called with the fraction of some work that is done. May be empty.
using ProgressReport = std::function<void(double fraction)>;

/// Adds up shares of some work, and reports the sum at most a thousand times: by one thread at a
/// time, never less than before, never more than 1. A thread that finds another one reporting goes
/// on with its work.
class ProgressMeter {
 public:
  /// REQUIRES: `report` outlives this.
  explicit ProgressMeter(const ProgressReport& report) : report_(report) {}

  /// Thread-safe, and cheap where nothing is to be reported.
  void add(double share);

 private:
  const ProgressReport& report_;
  std::atomic<double> done_ = 0;
  std::atomic<double> next_ = 0;  ///< nothing is reported before this much is done
  std::mutex reporting_;
};

}  // namespace spoctree
