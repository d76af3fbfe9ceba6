// Frames to Cap'n Proto messages and back. For the sources of common/wire only: this header is
// where Cap'n Proto's types and exceptions end.
#pragma once

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <kj/exception.h>

#include <string>

#include "common/base/errors.hpp"
#include "common/wire/frame.hpp"

namespace spoctree {

/// A message under construction, of one segment. `text_bytes` is the size of its texts and columns
/// together; no message has more pointers than fit in the slack.
class MessageWriter {
 public:
  explicit MessageWriter(std::size_t text_bytes)
      : message_(static_cast<capnp::uint>(text_bytes / 8 + kSlackWords),
                 capnp::AllocationStrategy::FIXED_SIZE) {}
  template <typename Root>
  typename Root::Builder root() {
    return message_.initRoot<Root>();
  }
  std::string seal(FrameType type);

 private:
  static constexpr std::size_t kSlackWords = 64;
  capnp::MallocMessageBuilder message_;
};

/// A frame's payload as aligned words of one segment. Throws BadInput if the frame is not of
/// `type` or its segment table is another.
class MessageWords {
 public:
  MessageWords(const FrameView& frame, FrameType type);
  kj::ArrayPtr<const capnp::word> words() const { return words_; }

 private:
  kj::Array<capnp::word> copy_;  ///< used where the payload is not aligned
  kj::ArrayPtr<const capnp::word> words_;
};

/// Calls `read` with the message of `frame` and returns what it returns. Readers and what they
/// refer to are valid during the call only. Whatever Cap'n Proto complains about becomes BadInput.
template <typename Root, typename Read>
auto read_message(const FrameView& frame, FrameType type, Read&& read) {
  const MessageWords words(frame, type);
  try {
    capnp::ReaderOptions limits;
    limits.traversalLimitInWords = 2 * words.words().size() + 64;
    limits.nestingLimit = 8;
    capnp::FlatArrayMessageReader message(words.words(), limits);
    return read(message.template getRoot<Root>());
  } catch (const kj::Exception& complaint) {
    throw BadInput(frame.where() + "a malformed message: " + complaint.getDescription().cStr());
  }
}

/// A text of a message. Throws BadInput unless it is clean (text.hpp) and short enough.
std::string checked_text(capnp::Text::Reader text, std::size_t max_bytes, const FrameView& frame,
                         const char* what);

}  // namespace spoctree
