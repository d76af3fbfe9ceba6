#include "common/wire/spo_writer.hpp"

#include "common/base/errors.hpp"
#include "common/wire/encode.hpp"

namespace spoctree {

SpoWriter::SpoWriter(std::filesystem::path path) : name_(path.string()), file_(std::move(path)) {}

void SpoWriter::accept(const FrameView& frame) {
  level_ += frame.bytes;
  if (frame.type != FrameType::LevelEnd) return;
  file_.write(level_);
  hasher_.add(level_);
  written_bytes_ += level_.size();
  index_.level_ends.push_back(written_bytes_);
  level_.clear();
}

void SpoWriter::commit() {
  if (index_.level_ends.empty()) throw BadInput(name_ + ": no complete level to write");
  index_.frames_hash = hasher_.hash();
  file_.write(seal_index(index_));
  file_.commit();
}

std::string encode_spo(const Octree& tree, const SourceInfo& source) {
  SpoIndex index;
  std::string bytes;
  encode_stream(tree, source, [&](std::string_view frame) {
    bytes += frame;
    if (read_frame(frame, 0, 0)->type == FrameType::LevelEnd) {
      index.level_ends.push_back(bytes.size());
    }
  });
  index.frames_hash = hash_bytes(bytes);
  bytes += seal_index(index);
  return bytes;
}

void write_spo(const std::filesystem::path& path, const Octree& tree, const SourceInfo& source) {
  SpoWriter writer(path);
  encode_stream(tree, source,
                [&](std::string_view frame) { writer.accept(*read_frame(frame, 0, 0)); });
  writer.commit();
}

}  // namespace spoctree
