// Ctrl-C, put off until what is worth keeping has been kept.
#pragma once

namespace spoctree {

/// While one of these exists, the first SIGINT, SIGTERM or SIGHUP ends nothing: it is noted, and
/// whoever does the work asks now and then. The second one does what it always does. One at a time.
class Interruption {
 public:
  Interruption();
  /// From now on signals do again what they did before.
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Whether a signal was noted. Also to be asked where none of these exists.
  static bool is_requested();
  /// Ends the program by the signal that was noted; nothing if there was none.
  /// REQUIRES: no Interruption exists any more.
  static void go_on();
};

}  // namespace spoctree
