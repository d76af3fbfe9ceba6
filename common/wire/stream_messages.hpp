// The stream's three messages as plain structs: to sealed frames and back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "common/tree/octree.hpp"
#include "common/wire/frame.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// The columns of a chunk, by their bytes (see PROTOCOL.md).
template <typename Bytes>
struct Columns {
  Bytes kinds;
  Bytes planes;
  Bytes counts;
  Bytes references;
  Bytes expressions;

  std::size_t byte_count() const {
    return kinds.size() + planes.size() + counts.size() + references.size() + expressions.size();
  }
};

/// What closes a level.
struct LevelEnd {
  std::uint32_t level = 0;
  bool is_last = false;
  std::uint32_t node_count = 0;
  std::uint32_t plane_count = 0;  ///< planes that appeared for the first time in this level
  LevelStatement statement;

  bool operator==(const LevelEnd&) const = default;
};

std::string seal_header(const StreamInfo& info);
/// REQUIRES: byte_count() <= kMaxChunkColumnBytes.
std::string seal_chunk(const Columns<std::string>& columns);
std::string seal_level_end(const LevelEnd& end);

/// The `open` functions throw BadInput, naming frame and byte, when the frame is of another type,
/// its message is malformed, or a value is not one that the type of the field promises.
StreamInfo open_header(const FrameView& frame);
/// The columns are valid during the call of `read` only.
void open_chunk(const FrameView& frame,
                const std::function<void(const Columns<std::string_view>&)>& read);
LevelEnd open_level_end(const FrameView& frame);

}  // namespace spoctree
