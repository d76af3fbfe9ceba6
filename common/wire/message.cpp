#include "common/wire/message.hpp"

#include <cstdint>
#include <cstring>

#include "common/wire/text.hpp"

namespace spoctree {

std::string MessageWriter::seal(FrameType type) {
  const kj::Array<capnp::word> words = capnp::messageToFlatArray(message_);
  const kj::ArrayPtr<const char> bytes = words.asPtr().asChars();
  return seal_frame(type, {bytes.begin(), bytes.size()});
}

MessageWords::MessageWords(const FrameView& frame, FrameType type) {
  if (frame.type != type) {
    throw BadInput(frame.where() + "a " + name_of(frame.type) + " where a " + name_of(type) +
                   " belongs");
  }
  const std::string_view payload = frame.payload;
  // The segment table: number of segments less one, words of the first.
  std::uint32_t table[2] = {1, 0};
  if (payload.size() >= sizeof table) std::memcpy(table, payload.data(), sizeof table);
  if (payload.size() % sizeof(capnp::word) != 0 || table[0] != 0 ||
      payload.size() != sizeof table + std::uint64_t{8} * table[1]) {
    throw BadInput(frame.where() + "not one message of one segment");
  }
  const std::size_t count = payload.size() / sizeof(capnp::word);
  if (reinterpret_cast<std::uintptr_t>(payload.data()) % alignof(capnp::word) == 0) {
    words_ = {reinterpret_cast<const capnp::word*>(payload.data()), count};
  } else {
    copy_ = kj::heapArray<capnp::word>(count);
    std::memcpy(copy_.begin(), payload.data(), payload.size());
    words_ = copy_;
  }
}

std::string checked_text(capnp::Text::Reader text, std::size_t max_bytes, const FrameView& frame,
                         const char* what) {
  const std::string_view bytes(text.begin(), text.size());
  if (!is_clean_text(bytes, max_bytes)) {
    throw BadInput(frame.where() + "the " + what + " is not a printable text of at most " +
                   std::to_string(max_bytes) + " bytes");
  }
  return std::string(bytes);
}

}  // namespace spoctree
