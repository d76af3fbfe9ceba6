// Mesh files with damage, through everything that a server does with a mesh, under watch.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/mesh/read_mesh.hpp"

namespace spoctree {

/// What any mesh file may cost, whatever is in it. Seconds of processor time.
inline constexpr int kMostSeconds = 10;
inline constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// One way to damage a file.
struct Damage {
  enum class Kind { None, Cut, Flip };
  Kind kind = Kind::None;
  std::size_t at = 0;      ///< the size to which it is cut, or the byte that is flipped
  unsigned char bits = 0;  ///< that are flipped
};

/// "cut to 17 bytes", "byte 17 ^ 0x40".
std::string to_text(const Damage& damage);
std::string damaged(std::string_view bytes, const Damage& damage);

/// Every truncation and a flip in every byte (all bits of it in turn: one, another, all), or every
/// n-th of both.
std::vector<Damage> every_damage(std::size_t file_bytes, std::size_t step = 1);

struct DamageOptions {
  bool repair = false;
  std::size_t build_every = 1;  ///< of the files that turn out to be solids, build every n-th
};

struct DamageReport {
  std::size_t files = 0;
  std::size_t solids = 0;
  std::size_t built = 0;
  double slowest_seconds = 0;  ///< of processor time
  Damage slowest;
  std::size_t peak_bytes = 0;         ///< of memory in use
  std::vector<std::string> failures;  ///< crashes, limits exceeded, errors that are not BadInput

  DamageReport& operator+=(const DamageReport& other);
};

/// Reads, repairs if wanted, judges and builds `bytes` with each damage, in a process of its own,
/// where a crash or kMostSeconds exceeded ends one case only. What a file may not do is in
/// `failures`. REQUIRES: this process has no other threads.
DamageReport judge_damaged(const std::string& name, MeshFormat format, std::string_view bytes,
                           std::span<const Damage> damages, const DamageOptions& options);

/// What a program did. `code` is -signal if a signal ended it.
struct WatchedRun {
  int code = 0;
  std::string out;
  std::string err;
  double seconds = 0;  ///< of processor time
  std::size_t peak_bytes = 0;
};

/// Runs a program, and ends it when it takes kMostSeconds.
WatchedRun run_watched(const std::vector<std::string>& words);

}  // namespace spoctree
