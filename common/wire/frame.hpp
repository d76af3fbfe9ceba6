// Bytes to frames and back: the one framing of socket and file.
//
// A frame is 16 bytes and a payload: 'S' 'P' 'O', the frame's type (1 byte), the payload's length
// in bytes (32 bits), XXH3-64 of the payload seeded with the eight bytes before (64 bits). Numbers
// are little-endian; the length is a multiple of 8, so that frames keep their alignment.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/wire/limits.hpp"

namespace spoctree {

/// The values are those on the wire.
enum class FrameType : std::uint8_t {
  Header = 1,
  Chunk = 2,
  LevelEnd = 3,
  Index = 4,
  Request = 16,
  Catalog = 17,
  Error = 18
};

/// Lower-case name of a frame type, for messages.
const char* name_of(FrameType type);

/// A frame in somebody else's memory.
struct FrameView {
  FrameType type{};
  std::string_view bytes;    ///< the whole frame
  std::string_view payload;  ///< its message
  std::uint64_t number = 0;  ///< in the stream, from 0
  std::uint64_t offset = 0;  ///< of its first byte in the stream

  /// "frame 3 at byte 1200: ", the beginning of every complaint about it.
  std::string where() const;
};

/// One frame's bytes. REQUIRES: at most kMaxPayloadBytes, a multiple of 8.
std::string seal_frame(FrameType type, std::string_view payload);

/// The frame at the front of `bytes`; nothing if more bytes are needed. Throws BadInput naming
/// frame and byte when no frame can begin so, when its payload is longer than `max_payload`, or
/// when its checksum does not match. The length is judged as soon as it is there.
std::optional<FrameView> read_frame(std::string_view bytes, std::uint64_t number,
                                    std::uint64_t offset,
                                    std::size_t max_payload = kMaxPayloadBytes);

/// Cuts bytes that arrive in any pieces into frames. Holds what was fed and not yet asked for.
class FrameReader {
 public:
  /// For a stream that is entered at its frame `number`, which begins at byte `offset`.
  explicit FrameReader(std::size_t max_payload = kMaxPayloadBytes, std::uint64_t number = 0,
                       std::uint64_t offset = 0)
      : max_payload_(max_payload), number_(number), offset_(offset) {}

  void feed(std::string_view bytes);
  /// The next frame, or nothing if more bytes are needed. The view holds until the next call of
  /// `feed`. Throws as read_frame does, and then again on every call.
  std::optional<FrameView> next();

  /// Number and first byte of the frame that `next` waits for.
  std::uint64_t number() const { return number_; }
  std::uint64_t offset() const { return offset_; }
  /// Bytes fed that belong to no frame yet: where a stream ends, not 0 means that it was cut off.
  std::size_t pending_bytes() const { return buffer_.size() - taken_; }
  /// How many bytes can be fed, at least one, without going beyond the frame that `next` waits for.
  /// REQUIRES: `next` has just returned nothing.
  std::size_t missing_bytes() const;

 private:
  std::size_t max_payload_;
  std::uint64_t number_;
  std::uint64_t offset_;
  std::string buffer_;
  std::size_t taken_ = 0;
};

}  // namespace spoctree
