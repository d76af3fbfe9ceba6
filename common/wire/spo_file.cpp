#include "common/wire/spo_file.hpp"

#include <algorithm>

#include "common/base/ascii_case.hpp"
#include "common/base/errors.hpp"
#include "common/base/file_kind.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/spo_index.hpp"
#include "common/wire/stream_messages.hpp"

namespace spoctree {

SpoFile::SpoFile(const std::filesystem::path& path)
    : mapped_(path), name_(path.string()), bytes_(mapped_->bytes()) {
  scan();
}

SpoFile::SpoFile(std::string_view bytes, std::string name) : name_(std::move(name)), bytes_(bytes) {
  scan();
}

void SpoFile::reject_other_kinds() const {
  const auto kind = find_file_kind(bytes_);
  const std::string extension = to_lower_case(std::filesystem::path(name_).extension().string());
  const bool is_mesh = kind ? kind->is_mesh
                            : extension == ".off" || extension == ".obj" || extension == ".stl" ||
                                  extension == ".ply";
  if (kind && kind->extension == ".spo") return;
  if (is_mesh) {
    throw BadInput("is " + (kind ? kind->name : std::string("a mesh by its name")) +
                   ", not a .spo file: spoctree-server build makes one of it");
  }
  if (kind) throw BadInput("is " + kind->name + ", not a .spo file");
}

void SpoFile::scan() try {
  reject_other_kinds();
  const std::uint64_t index_begin = open_trailer(bytes_, bytes_.size());
  const std::string_view file = bytes_.substr(0, bytes_.size() - kTrailerBytes);
  Hasher hasher;
  SpoIndex expected;
  std::uint64_t offset = 0;
  boundaries_.push_back({0, hasher.hash()});
  while (true) {
    const auto frame = read_frame(file.substr(offset), boundaries_.size() - 1, offset);
    if (!frame) {
      throw BadInput("byte " + std::to_string(offset) + ": a cut-off frame");
    }
    const auto fail = [&](const std::string& what) { throw BadInput(frame->where() + what); };
    if (offset == 0) {
      info_ = open_header(*frame);
    } else if (offset == index_begin) {
      const SpoIndex index = open_index(*frame);
      expected.frames_hash = hasher.hash();
      if (expected.level_ends.empty() || expected.level_ends.back() != offset ||
          index != expected) {
        fail("the index is not that of the frames before it");
      }
      if (offset + frame->bytes.size() != file.size()) fail("bytes between index and trailer");
      break;
    } else if (expected.level_ends.size() == info_.level_count) {
      fail("a frame after the end of the stream");
    } else if (frame->type == FrameType::LevelEnd) {
      const LevelEnd end = open_level_end(*frame);
      if (end.level != expected.level_ends.size()) fail("the end of a level not under way");
      expected.level_ends.push_back(offset + frame->bytes.size());
    } else if (frame->type != FrameType::Chunk) {
      fail(std::string("a ") + name_of(frame->type) + " among the levels");
    }
    hasher.add(frame->bytes);
    offset += frame->bytes.size();
    boundaries_.push_back({offset, hasher.hash()});
  }
  frames_ = bytes_.substr(0, index_begin);
  std::uint64_t begin = 0;
  for (const std::uint64_t end : expected.level_ends) {
    level_bytes_.push_back({end - begin, end});
    begin = end;
  }
} catch (const BadInput& error) {
  throw BadInput(name_ + ": " + error.what());
}

std::optional<std::string_view> SpoFile::slice(std::uint32_t levels,
                                               std::uint64_t from_byte) const {
  const std::uint32_t last = levels == 0 ? level_count() : std::min(levels, level_count());
  const std::uint64_t end = level_bytes_[last - 1].total_bytes;
  if (from_byte >= end || !hash_before(from_byte)) return std::nullopt;
  return frames_.substr(from_byte, end - from_byte);
}

std::optional<std::uint64_t> SpoFile::hash_before(std::uint64_t byte) const {
  const auto found = std::lower_bound(
      boundaries_.begin(), boundaries_.end(), byte,
      [](const ResumePoint& boundary, std::uint64_t wanted) { return boundary.byte < wanted; });
  if (found == boundaries_.end() || found->byte != byte) return std::nullopt;
  return found->hash;
}

Octree SpoFile::tree(std::uint32_t levels) const try {
  return decode_stream(frames_, levels == 0 ? level_count() : std::min(levels, level_count()));
} catch (const BadInput& error) {
  throw BadInput(name_ + ": " + error.what());
}

std::string_view recover_frames(std::string_view bytes) {
  std::uint64_t offset = 0;
  std::uint64_t complete = 0;
  try {
    StreamDecoder decoder;
    for (std::uint64_t number = 0; !decoder.is_complete(); ++number) {
      const auto frame = read_frame(bytes.substr(offset), number, offset);
      if (!frame) break;
      decoder.accept(*frame);
      offset += frame->bytes.size();
      if (frame->type == FrameType::LevelEnd) complete = offset;
    }
  } catch (const BadInput&) {
    // What follows the first broken frame is lost; that is what recovering means.
  }
  return bytes.substr(0, complete);
}

}  // namespace spoctree
