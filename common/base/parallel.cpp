#include "common/base/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_group.h>

#include <utility>

#ifdef SPOCTREE_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace spoctree {

namespace {

/// What happens before a `release` happens before what follows the next `acquire`. So it is anyway;
/// this is for ThreadSanitizer.
class Order {
 public:
#ifdef SPOCTREE_THREAD_SANITIZER
  void release() { __tsan_release(this); }
  void acquire() { __tsan_acquire(this); }
#else
  void release() {}
  void acquire() {}
#endif
};

/// Releases, or acquires, at the end of a scope: when something is thrown, too.
class ReleaseAtEnd {
 public:
  explicit ReleaseAtEnd(Order& order) : order_(order) {}
  ~ReleaseAtEnd() { order_.release(); }

 private:
  Order& order_;
};
class AcquireAtEnd {
 public:
  explicit AcquireAtEnd(Order& order) : order_(order) {}
  ~AcquireAtEnd() { order_.acquire(); }

 private:
  Order& order_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  Order begin;
  Order end;
  begin.release();
  const AcquireAtEnd all_done(end);
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    begin.acquire();
    const ReleaseAtEnd done(end);
    body(i);
  });
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  Order begin;
  Order end;
  const auto call = [&](const std::function<void()>& body) {
    begin.acquire();
    const ReleaseAtEnd done(end);
    body();
  };
  begin.release();
  const AcquireAtEnd all_done(end);
  oneapi::tbb::parallel_invoke([&] { call(first); }, [&] { call(second); });
}

struct JobGroup::Group {
  oneapi::tbb::task_group tasks;
  Order begin;
  Order end;
};

JobGroup::JobGroup() : group_(std::make_unique<Group>()) {}
JobGroup::~JobGroup() = default;

void JobGroup::start(std::function<void()> job) {
  Group& group = *group_;
  group.begin.release();
  group.tasks.run([&group, job = std::move(job)] {
    group.begin.acquire();
    const ReleaseAtEnd done(group.end);
    job();
  });
}

void JobGroup::wait() {
  const AcquireAtEnd all_done(group_->end);
  group_->tasks.wait();
}

}  // namespace spoctree
