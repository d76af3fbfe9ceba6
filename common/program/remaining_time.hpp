// How much of a task is done -> how long it has taken, and will take.
#pragma once

#include <chrono>
#include <string>

namespace spoctree {

/// "7 s", "1:05 min", "2:30 h": to be read while it changes. REQUIRES: seconds >= 0.
std::string duration_text(double seconds);

/// " 42 %, 3 s, 4 s left": `fraction` of the work took `elapsed_s` seconds, and the rest is thought
/// to go as fast. While too little is done to say so, only what has passed.
std::string describe_progress(double fraction, double elapsed_s);

/// Seconds since something began.
class Elapsed {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace spoctree
