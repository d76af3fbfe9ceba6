#include "common/wire/frame.hpp"

#include <bit>
#include <cassert>
#include <cstring>

#include "common/base/errors.hpp"
#include "common/wire/hash.hpp"

namespace spoctree {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

constexpr std::string_view kMagic = "SPO";
constexpr std::size_t kLengthAt = 4;
constexpr std::size_t kChecksumAt = 8;

template <typename Number>
Number load(std::string_view bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

bool is_known(std::uint8_t type) { return (type >= 1 && type <= 4) || (type >= 16 && type <= 18); }

}  // namespace

const char* name_of(FrameType type) {
  switch (type) {
    case FrameType::Header:
      return "header";
    case FrameType::Chunk:
      return "chunk";
    case FrameType::LevelEnd:
      return "level end";
    case FrameType::Index:
      return "index";
    case FrameType::Request:
      return "request";
    case FrameType::Catalog:
      return "catalog";
    case FrameType::Error:
      return "error";
  }
  return "unknown";
}

std::string FrameView::where() const {
  return "frame " + std::to_string(number) + " at byte " + std::to_string(offset) + ": ";
}

std::string seal_frame(FrameType type, std::string_view payload) {
  assert(payload.size() <= kMaxPayloadBytes && payload.size() % 8 == 0);
  std::string bytes(kFrameHeaderBytes, '\0');
  bytes.reserve(kFrameHeaderBytes + payload.size());
  kMagic.copy(bytes.data(), kMagic.size());
  bytes[kMagic.size()] = static_cast<char>(type);
  const auto length = static_cast<std::uint32_t>(payload.size());
  std::memcpy(bytes.data() + kLengthAt, &length, sizeof length);
  const std::uint64_t checksum = hash_bytes(payload, load<std::uint64_t>(bytes, 0));
  std::memcpy(bytes.data() + kChecksumAt, &checksum, sizeof checksum);
  bytes += payload;
  return bytes;
}

std::optional<FrameView> read_frame(std::string_view bytes, std::uint64_t number,
                                    std::uint64_t offset, std::size_t max_payload) {
  FrameView frame;
  frame.number = number;
  frame.offset = offset;
  const std::string_view magic = bytes.substr(0, kMagic.size());
  if (magic != kMagic.substr(0, magic.size())) {
    throw BadInput(frame.where() + "no frame begins here");
  }
  if (bytes.size() < kChecksumAt) return std::nullopt;
  const auto type = static_cast<std::uint8_t>(bytes[kMagic.size()]);
  if (!is_known(type)) {
    throw BadInput(frame.where() + "a frame of unknown type " + std::to_string(type));
  }
  const auto length = load<std::uint32_t>(bytes, kLengthAt);
  if (length > max_payload || length % 8 != 0) {
    throw BadInput(frame.where() + "a payload of " + std::to_string(length) + " bytes (at most " +
                   std::to_string(max_payload) + ", a multiple of 8)");
  }
  if (bytes.size() < kFrameHeaderBytes + length) return std::nullopt;
  frame.type = static_cast<FrameType>(type);
  frame.bytes = bytes.substr(0, kFrameHeaderBytes + length);
  frame.payload = frame.bytes.substr(kFrameHeaderBytes);
  if (load<std::uint64_t>(bytes, kChecksumAt) !=
      hash_bytes(frame.payload, load<std::uint64_t>(bytes, 0))) {
    throw BadInput(frame.where() + "the checksum does not match");
  }
  return frame;
}

void FrameReader::feed(std::string_view bytes) {
  buffer_.erase(0, taken_);
  taken_ = 0;
  buffer_ += bytes;
}

std::size_t FrameReader::missing_bytes() const {
  const std::string_view frame = std::string_view(buffer_).substr(taken_);
  if (frame.size() < kFrameHeaderBytes) return kFrameHeaderBytes - frame.size();
  return kFrameHeaderBytes + load<std::uint32_t>(frame, kLengthAt) - frame.size();
}

std::optional<FrameView> FrameReader::next() {
  auto frame = read_frame(std::string_view(buffer_).substr(taken_), number_, offset_, max_payload_);
  if (frame) {
    taken_ += frame->bytes.size();
    offset_ += frame->bytes.size();
    ++number_;
  }
  return frame;
}

}  // namespace spoctree
