// Fuzzes the wire. The first byte chooses: raw bytes as a .spo file and as frames; or payloads that
// get right lengths and checksums, so that the fuzzer reaches the messages behind them.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"

namespace {

using namespace spoctree;

/// Cuts `bytes` into a type, a length in words (16 bits) and a payload, over and over. The
/// segment table is put before each payload.
std::string sealed_frames(std::string_view bytes) {
  std::string stream;
  while (bytes.size() >= 3) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
    const auto type = static_cast<FrameType>(byte(0) % 32);
    const std::size_t words = (byte(1) | std::size_t{byte(2)} << 8) % 8000;
    bytes.remove_prefix(3);
    std::string payload(8, '\0');
    payload[4] = static_cast<char>(words);
    payload[5] = static_cast<char>(words >> 8);
    payload += bytes.substr(0, 8 * words);
    bytes.remove_prefix(std::min(bytes.size(), 8 * words));
    payload.resize(8 + 8 * words);
    stream += seal_frame(type, payload);
  }
  return stream;
}

void read(const FrameView& frame, StreamDecoder& decoder) {
  std::vector<CatalogEntry> entries;
  switch (frame.type) {
    case FrameType::Request:
      open_request(frame);
      return;
    case FrameType::Catalog:
      open_catalog(frame, entries);
      return;
    case FrameType::Error:
      open_error(frame);
      return;
    default:
      decoder.accept(frame);
  }
}

void read_stream(std::string_view stream) {
  StreamDecoder decoder;
  try {
    FrameReader reader;
    reader.feed(stream);
    while (const auto frame = reader.next()) read(*frame, decoder);
  } catch (const BadInput&) {
  }
  if (!decoder.tree().levels.empty() && !validate(decoder.tree()).empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0) {
    read_stream(sealed_frames(bytes));
    return 0;
  }
  read_stream(bytes);
  recover_frames(bytes);
  try {
    SpoFile(bytes, "file").tree();
  } catch (const BadInput&) {
  }
  return 0;
}
