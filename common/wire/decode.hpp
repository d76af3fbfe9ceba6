// The frames of a stream to a tree that grows level by level.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/tree/octree.hpp"
#include "common/wire/frame.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/level_reader.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// Takes the frames of one stream in order. The tree grows when a level is complete; at any time
/// it is valid (validate.hpp finds nothing), or empty before the first level's end. Linear in the
/// bytes received, in time up to the tree's depth; memory likewise, whatever the bytes announce.
class StreamDecoder {
 public:
  StreamDecoder() = default;
  StreamDecoder(const StreamDecoder&) = delete;
  StreamDecoder& operator=(const StreamDecoder&) = delete;

  /// Throws BadInput naming the frame and its first byte when it is not the next frame of a valid
  /// stream. The decoder then accepts no further frame; its tree stays as it was.
  void accept(const FrameView& frame);

  bool has_info() const { return info_.has_value(); }
  /// REQUIRES: has_info(), true after the first frame.
  const StreamInfo& info() const { return *info_; }
  /// The complete levels that have arrived.
  const Octree& tree() const { return tree_; }
  std::uint32_t level_count() const { return static_cast<std::uint32_t>(tree_.levels.size()); }
  /// True if every level that the header announces has arrived.
  bool is_complete() const { return info_ && level_count() == info_->level_count; }
  /// What each complete level cost.
  const std::vector<LevelBytes>& level_bytes() const { return level_bytes_; }

  /// Of the level that is arriving: nodes so far, and of how many.
  std::uint64_t arrived_nodes() const { return reader_.level().size(); }
  std::uint64_t expected_nodes() const { return is_complete() ? 0 : tree_.next_level_size(); }

  /// After the last frame accepted.
  ResumePoint resume_point() const { return {byte_count_, hasher_.hash()}; }

  /// The tree, moved out. The decoder is then of no further use.
  Octree take_tree() { return std::move(tree_); }

 private:
  void accept_header(const FrameView& frame);
  void accept_chunk(const FrameView& frame);
  void accept_level_end(const FrameView& frame);

  std::optional<StreamInfo> info_;
  Octree tree_;
  LevelReader reader_;
  std::vector<LevelBytes> level_bytes_;
  std::uint64_t node_count_ = 0;  ///< of the complete levels
  std::uint64_t byte_count_ = 0;
  Hasher hasher_;
  bool is_broken_ = false;
};

/// The tree of the first `levels` levels (0: all) in `frames`, the frames of a stream from its
/// beginning. Throws BadInput as StreamDecoder does, and when the bytes end before those levels do.
Octree decode_stream(std::string_view frames, std::uint32_t levels = 0);

}  // namespace spoctree
