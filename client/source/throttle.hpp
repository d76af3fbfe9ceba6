// Bytes per second -> waiting.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace spoctree {

/// Slower than this, a link would look dead to a server (the system tells the other side about
/// free room in its receive buffer only now and then).
inline constexpr std::uint64_t kLowestRate = 64;

/// A token bucket: on average at most `bytes_per_second`, after a pause at most a tenth of a
/// second's bytes at once.
class Throttle {
 public:
  /// 0: no limit.
  explicit Throttle(std::uint64_t bytes_per_second) : rate_(bytes_per_second) {}

  /// How many bytes to take at once, at most, so that waiting is even: a twentieth of a second's.
  std::size_t portion() const;
  /// Waits until `bytes` bytes more may have arrived.
  void spend(std::size_t bytes);

 private:
  std::uint64_t rate_;
  std::chrono::steady_clock::time_point ready_{};
};

}  // namespace spoctree
