// A .spo file to slices of its frames, and to its tree. Read-only: see spo_writer.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/tree/octree.hpp"
#include "common/wire/mapped_file.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// The frames of a stream, or of its first levels. On opening, every frame's checksum is verified
/// and the index compared with the frames; what the chunks say is judged by `tree` only. Immutable:
/// any number of threads may read one.
class SpoFile {
 public:
  /// Maps the file. Throws BadInput naming the file and the byte where it is not a .spo file, cut
  /// off, or changed. Linear in its size (about a second for some gigabytes).
  explicit SpoFile(const std::filesystem::path& path);
  /// The same of bytes in memory that outlive this object; `name` stands in for the path.
  SpoFile(std::string_view bytes, std::string name);

  const StreamInfo& info() const { return info_; }
  /// The levels in this file: fewer than info().level_count if it is of a partial transmission.
  std::uint32_t level_count() const { return static_cast<std::uint32_t>(level_bytes_.size()); }
  bool is_whole() const { return level_count() == info_.level_count; }
  const std::vector<LevelBytes>& level_bytes() const { return level_bytes_; }

  /// All frames, without the index.
  std::string_view frames() const { return frames_; }
  /// hash_bytes(frames()): if the file is whole, the model's id.
  std::uint64_t frames_hash() const { return boundaries_.back().hash; }
  /// Where a transmission goes on that has brought what is in this file.
  ResumePoint resume_point() const { return boundaries_.back(); }

  /// The frames of the first `levels` levels (0: all) from `from_byte` on. Nothing if that is not
  /// the first byte of one of these frames.
  std::optional<std::string_view> slice(std::uint32_t levels, std::uint64_t from_byte = 0) const;
  /// The hash of the frames before a frame boundary (the end of the frames is one); nothing if
  /// `byte` is none.
  std::optional<std::uint64_t> hash_before(std::uint64_t byte) const;

  /// Decodes the first `levels` levels (0: all). Throws BadInput naming the file and the frame.
  Octree tree(std::uint32_t levels = 0) const;

 private:
  /// Throws BadInput (without the name) for what is evidently another kind of file.
  void reject_other_kinds() const;
  void scan();

  std::optional<MappedFile> mapped_;
  std::string name_;
  std::string_view bytes_;
  std::string_view frames_;
  StreamInfo info_;
  std::vector<LevelBytes> level_bytes_;
  std::vector<ResumePoint> boundaries_;  ///< of all frames, from byte 0 to the end
};

/// The frames of the complete levels at the front of a damaged or cut-off .spo file; empty if not
/// even level 0 is there. What follows the first broken frame is left out. Never throws.
std::string_view recover_frames(std::string_view bytes);

}  // namespace spoctree
