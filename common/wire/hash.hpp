// Bytes to their XXH3-64 hash: frame checksums, model ids, the source file's hash.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace spoctree {

/// XXH3-64 of `bytes`, with seed 0 unless given.
std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed = 0);

/// The hash as 16 lower-case hexadecimal digits: the way ids are shown.
std::string to_hex(std::uint64_t hash);

/// XXH3-64 (seed 0) of bytes that come in pieces.
class Hasher {
 public:
  Hasher();
  void add(std::string_view bytes);
  /// The hash of everything added so far; more may be added afterwards.
  std::uint64_t hash() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace spoctree
