// What a stream says about itself: where its model comes from, how large it is, what its levels
// cost.
#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/universe.hpp"

namespace spoctree {

/// What the encoder cannot see in the tree.
struct SourceInfo {
  std::string units;          ///< of the model, such as "mm"; empty: not known
  std::string name;           ///< of the mesh file, without folders
  std::uint64_t hash = 0;     ///< hash_bytes (hash.hpp) of the mesh file
  std::string build_options;  ///< "name=value" pairs, blank between

  bool operator==(const SourceInfo&) const = default;
};

/// What a stream announces in its first frame. The counts are those of a full transmission.
struct StreamInfo {
  Universe universe;
  std::uint32_t level_count = 0;
  std::uint32_t plane_count = 0;
  std::uint32_t node_count = 0;
  SourceInfo source;

  bool operator==(const StreamInfo&) const = default;
};

/// What a level costs, framing included; the header frame counts to level 0.
struct LevelBytes {
  std::uint64_t bytes = 0;        ///< of this level
  std::uint64_t total_bytes = 0;  ///< of this level and all before it: where the next one begins

  bool operator==(const LevelBytes&) const = default;
};

/// Where a transmission that was broken off goes on: what a `get` request says.
struct ResumePoint {
  std::uint64_t byte = 0;  ///< a frame boundary
  std::uint64_t hash = 0;  ///< hash_bytes of everything before it

  bool operator==(const ResumePoint&) const = default;
};

}  // namespace spoctree
