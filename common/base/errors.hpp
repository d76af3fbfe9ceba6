// The kinds of failure a user can meet, and the exit code of each.
// A caller's bug is an assertion, never one of these.
#pragma once

#include <stdexcept>
#include <string>

namespace spoctree {

enum ExitCode : int { kExitDone = 0, kExitUsage = 2, kExitBadInput = 3, kExitNetwork = 4 };

/// The command line asks for something that cannot be meant. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or a stream is not what it should be, or cannot be read or written. The text names the
/// file and the place in it (line, byte, frame or node). Exit code 3.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The peer is absent, silent, or broke the connection. Exit code 4.
class NetworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace spoctree
