#include "common/base/temporary_name.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstring>

namespace spoctree {

namespace {

// A signal handler may not allocate, lock or wait: the names stand in a fixed table, each with a
// flag that is set after the name is written and cleared before it is overwritten.
struct Slot {
  std::atomic<bool> is_taken = false;
  std::atomic<bool> is_valid = false;
  std::array<char, 4096> path{};
};
std::array<Slot, 32> slots;
std::atomic<const char*> last_words = nullptr;
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void remove_files_and_die(int signal) {
  for (Slot& slot : slots) {
    if (slot.is_valid.load()) ::unlink(slot.path.data());
  }
  if (const char* const words = last_words.load()) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words, std::strlen(words));
  }
  // SA_RESETHAND has put the default back: this ends the program once the handler returns.
  ::raise(signal);
}

}  // namespace

TemporaryName::TemporaryName(const std::string& path) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    Slot& slot = slots[i];
    if (path.size() >= slot.path.size()) return;
    if (slot.is_taken.exchange(true)) continue;
    std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
    slot.is_valid.store(true);
    slot_ = static_cast<int>(i);
    return;
  }
}

TemporaryName::~TemporaryName() {
  if (slot_ < 0) return;
  Slot& slot = slots[static_cast<std::size_t>(slot_)];
  slot.is_valid.store(false);
  slot.is_taken.store(false);
}

void set_last_words(const char* text) { last_words.store(text); }

void remove_temporary_files_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    // Somebody who wants a signal ignored (nohup) keeps that.
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = remove_files_and_die;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace spoctree
