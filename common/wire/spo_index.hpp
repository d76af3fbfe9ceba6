// The end of a .spo file: the index (a frame) and the trailer that locates it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/wire/frame.hpp"

namespace spoctree {

/// A function of the frames before it.
struct SpoIndex {
  std::uint64_t frames_hash = 0;          ///< of all frames; of a whole file: the model's id
  std::vector<std::uint64_t> level_ends;  ///< byte after each level's end frame

  bool operator==(const SpoIndex&) const = default;
};

/// The trailer: the first byte of the index frame (64 bits, little-endian), then "spoctree".
inline constexpr std::size_t kTrailerBytes = 16;

/// Index frame and trailer. REQUIRES: 1 to kMaxLevels levels.
std::string seal_index(const SpoIndex& index);

/// Throws BadInput naming frame and byte when the frame is not a well-formed index.
SpoIndex open_index(const FrameView& frame);

/// The first byte of the index frame, from the end of a file. Throws BadInput if `file_end`, the
/// last bytes of a file of `file_size` bytes, does not end with a trailer.
std::uint64_t open_trailer(std::string_view file_end, std::uint64_t file_size);

}  // namespace spoctree
