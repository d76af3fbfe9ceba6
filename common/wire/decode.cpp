#include "common/wire/decode.hpp"

#include <algorithm>

#include "common/base/errors.hpp"
#include "common/wire/stream_messages.hpp"

namespace spoctree {

void StreamDecoder::accept(const FrameView& frame) {
  if (is_broken_) throw BadInput(frame.where() + "follows a frame that was refused");
  is_broken_ = true;
  if (!info_) {
    accept_header(frame);
  } else if (is_complete()) {
    throw BadInput(frame.where() + "a " + name_of(frame.type) + " after the end of the stream");
  } else if (frame.type == FrameType::Chunk) {
    accept_chunk(frame);
  } else {
    accept_level_end(frame);
  }
  is_broken_ = false;
  byte_count_ += frame.bytes.size();
  hasher_.add(frame.bytes);
}

void StreamDecoder::accept_header(const FrameView& frame) {
  info_ = open_header(frame);
  tree_.universe = info_->universe;
  reader_.begin(tree_, *info_);
}

void StreamDecoder::accept_chunk(const FrameView& frame) {
  open_chunk(frame, [&](const Columns<std::string_view>& columns) {
    reader_.read(columns, frame.where());
  });
}

void StreamDecoder::accept_level_end(const FrameView& frame) {
  const LevelEnd end = open_level_end(frame);
  const auto require = [&](bool holds, const char* otherwise) {
    if (!holds) {
      throw BadInput(frame.where() + "the end of level " + std::to_string(end.level) + " " +
                     otherwise);
    }
  };
  require(end.level == level_count(), "is not that of the level under way");
  require(reader_.is_full(), "comes before all its nodes and planes");
  require(
      end.node_count == reader_.level().size() && end.plane_count == reader_.new_planes().size(),
      "counts other nodes or planes than have arrived");
  require(end.is_last == (end.level + 1 == info_->level_count),
          "and the header disagree on the last level");
  const std::uint64_t nodes = node_count_ + end.node_count;
  const std::uint64_t next_nodes = std::uint64_t{8} * reader_.level().grey_count;
  if (end.is_last) {
    require(
        nodes == info_->node_count && tree_.planes.size() + end.plane_count == info_->plane_count,
        "leaves fewer nodes or planes than the header announces");
  } else {
    require(next_nodes > 0, "has no GREY node for a further level");
    require(nodes + next_nodes <= info_->node_count,
            "asks for more nodes than the header announces");
  }
  reader_.append_to(tree_);
  tree_.levels.back().statement = end.statement;
  node_count_ = nodes;
  const std::uint64_t total = byte_count_ + frame.bytes.size();
  level_bytes_.push_back(
      {total - (level_bytes_.empty() ? 0 : level_bytes_.back().total_bytes), total});
  if (!is_complete()) reader_.begin(tree_, *info_);
}

Octree decode_stream(std::string_view frames, std::uint32_t levels) {
  StreamDecoder decoder;
  std::uint64_t number = 0;
  std::uint64_t offset = 0;
  while (!decoder.is_complete() && (levels == 0 || decoder.level_count() < levels)) {
    const auto frame = read_frame(frames.substr(offset), number, offset);
    if (!frame) {
      throw BadInput("frame " + std::to_string(number) + " at byte " + std::to_string(offset) +
                     ": the stream ends before its last level does");
    }
    decoder.accept(*frame);
    offset += frame->bytes.size();
    ++number;
  }
  return decoder.take_tree();
}

}  // namespace spoctree
