// The frames of a stream, as they are made or as they arrive, to a .spo file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/base/atomic_file.hpp"
#include "common/tree/octree.hpp"
#include "common/wire/frame.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/spo_index.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// Writes a .spo file beside its final name; `commit` adds the index and moves it there. Without
/// `commit` nothing remains. Whoever writes all frames of a stream writes the same bytes as its
/// encoder. Holds the frames of one level.
class SpoWriter {
 public:
  /// Throws BadInput when the file cannot be created.
  explicit SpoWriter(std::filesystem::path path);

  /// REQUIRES: the next frame of a stream that a StreamDecoder accepts (the first frame first).
  void accept(const FrameView& frame);

  /// Finishes the file with the levels that are complete; frames after the last one are dropped.
  /// Throws BadInput when no level is complete or the file cannot be written.
  void commit();

 private:
  std::string name_;
  AtomicFile file_;
  std::string level_;  ///< frames of the level under way
  std::uint64_t written_bytes_ = 0;
  Hasher hasher_;
  SpoIndex index_;
};

/// A whole .spo file in memory: the stream of `tree` (see encode.hpp) and its index.
std::string encode_spo(const Octree& tree, const SourceInfo& source);

/// Writes the whole .spo file of `tree`. Throws BadInput as encode_stream and SpoWriter do.
void write_spo(const std::filesystem::path& path, const Octree& tree, const SourceInfo& source);

}  // namespace spoctree
