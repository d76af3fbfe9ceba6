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

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  Order begin;
  Order end;
  begin.release();
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    begin.acquire();
    body(i);
    end.release();
  });
  end.acquire();
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  Order begin;
  Order end;
  const auto call = [&](const std::function<void()>& body) {
    begin.acquire();
    body();
    end.release();
  };
  begin.release();
  oneapi::tbb::parallel_invoke([&] { call(first); }, [&] { call(second); });
  end.acquire();
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
    job();
    group.end.release();
  });
}

void JobGroup::wait() {
  group_->tasks.wait();
  group_->end.acquire();
}

}  // namespace spoctree
