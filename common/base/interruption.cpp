#include "common/base/interruption.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace spoctree {

namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kSignals.size()> usual;
std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  noted.store(signal);
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &usual[i], nullptr);
}

}  // namespace

Interruption::Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], nullptr, &usual[i]);
  }
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (usual[i].sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(kSignals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &usual[i], nullptr);
}

bool Interruption::is_requested() { return noted.load() != 0; }

void Interruption::go_on() {
  if (is_requested()) std::raise(noted.load());
}

}  // namespace spoctree
