#include "common/wire/spo_index.hpp"

#include <cstring>

#include "common/wire/message.hpp"
#include "schemas/stream.capnp.h"

namespace spoctree {

namespace {
constexpr std::string_view kTrailerMagic = "spoctree";
}  // namespace

std::string seal_index(const SpoIndex& index) {
  MessageWriter message(8 * index.level_ends.size());
  auto root = message.root<schema::Index>();
  root.setFramesHash(index.frames_hash);
  auto ends = root.initLevelEnds(static_cast<capnp::uint>(index.level_ends.size()));
  for (capnp::uint i = 0; i < ends.size(); ++i) ends.set(i, index.level_ends[i]);
  std::string bytes = message.seal(FrameType::Index);
  const std::uint64_t offset = index.level_ends.back();
  bytes.append(reinterpret_cast<const char*>(&offset), sizeof offset);
  bytes += kTrailerMagic;
  return bytes;
}

SpoIndex open_index(const FrameView& frame) {
  return read_message<schema::Index>(frame, FrameType::Index, [&](schema::Index::Reader root) {
    SpoIndex index;
    index.frames_hash = root.getFramesHash();
    const auto ends = root.getLevelEnds();
    if (ends.size() < 1 || ends.size() > kMaxLevels) {
      throw BadInput(frame.where() + "an index of " + std::to_string(ends.size()) + " levels");
    }
    std::uint64_t begin = 0;
    for (const std::uint64_t end : ends) {
      if (end <= begin || end > frame.offset) {
        throw BadInput(frame.where() + "an index whose levels do not follow each other");
      }
      index.level_ends.push_back(begin = end);
    }
    return index;
  });
}

std::uint64_t open_trailer(std::string_view file_end, std::uint64_t file_size) {
  if (file_end.size() >= kTrailerBytes && file_end.ends_with(kTrailerMagic)) {
    std::uint64_t offset = 0;
    std::memcpy(&offset, file_end.data() + file_end.size() - kTrailerBytes, sizeof offset);
    if (file_size >= kTrailerBytes + kFrameHeaderBytes &&
        offset <= file_size - kTrailerBytes - kFrameHeaderBytes) {
      return offset;
    }
  }
  throw BadInput("byte " + std::to_string(file_size) +
                 ": no trailer: the file is cut off, or not a .spo file");
}

}  // namespace spoctree
