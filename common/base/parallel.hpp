// Independent pieces of work -> every core.
//
// The only user of oneTBB. That is compiled without ThreadSanitizer, which therefore does not see
// what a thread may rely on when it gets a piece of work, and when the work is done: here it is
// told.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace spoctree {

/// Calls body(0) ... body(count - 1), in any order and at the same time; returns when all are done.
/// An exception of one call ends the others that have not begun, and is thrown on. Meant for bodies
/// of a microsecond and more.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// Calls both, at the same time if a thread is free.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

/// Sorts by `less`. The result is that of std::sort where no two elements are equivalent; else it
/// does not depend on the threads either.
template <class T, class Less>
void parallel_sort(std::vector<T>& items, Less less) {
  constexpr std::size_t kRuns = 16;  // a power of two
  constexpr std::size_t kWorthwhile = 10'000;
  if (items.size() < kWorthwhile) {
    std::sort(items.begin(), items.end(), less);
    return;
  }
  const auto begin_of = [&](std::size_t run) {
    return items.begin() + static_cast<std::ptrdiff_t>(items.size() * run / kRuns);
  };
  parallel_for(kRuns, [&](std::size_t run) { std::sort(begin_of(run), begin_of(run + 1), less); });
  for (std::size_t width = 1; width < kRuns; width *= 2) {
    parallel_for(kRuns / (2 * width), [&](std::size_t pair) {
      const std::size_t run = 2 * width * pair;
      std::inplace_merge(begin_of(run), begin_of(run + width), begin_of(run + 2 * width), less);
    });
  }
}

/// Jobs that may start further jobs and wait for none. A thread takes the newest of its own jobs
/// first.
class JobGroup {
 public:
  JobGroup();
  /// REQUIRES: `wait` was called after the last job was started.
  ~JobGroup();
  JobGroup(const JobGroup&) = delete;
  JobGroup& operator=(const JobGroup&) = delete;

  /// From any thread. `job` is copied.
  void start(std::function<void()> job);
  /// Works until no job is left. Throws what a job has thrown; jobs that had not begun are then
  /// dropped.
  void wait();

 private:
  struct Group;
  std::unique_ptr<Group> group_;
};

}  // namespace spoctree
