#include "common/program/threads.hpp"

#include <oneapi/tbb/global_control.h>

#include <CLI/CLI.hpp>

namespace spoctree {

namespace {
constexpr int kMostThreads = 1024;
}

// Built in place: oneTBB lets its controls be copied, and a copy that dies ends the limit.
struct ThreadLimit::Control {
  explicit Control(int threads)
      : control(oneapi::tbb::global_control::max_allowed_parallelism,
                static_cast<std::size_t>(threads)) {}
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  oneapi::tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {}
ThreadLimit::~ThreadLimit() = default;

ThreadsOption::ThreadsOption(CLI::App& command) {
  command.add_option("--threads", threads_, "Use at most N threads (default: one per core)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

ThreadsOption::~ThreadsOption() = default;

void ThreadsOption::apply() {
  if (threads_ == 0) return;
  limit_ = std::make_unique<ThreadLimit>(threads_);
}

}  // namespace spoctree
