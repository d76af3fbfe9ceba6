#include "tests/support/frames.hpp"

#include <cstdio>

#include "common/base/errors.hpp"
#include "common/wire/decode.hpp"

namespace spoctree {

std::vector<FrameView> frames_of(std::string_view stream) {
  std::vector<FrameView> frames;
  for (std::uint64_t offset = 0; offset < stream.size();) {
    const auto frame = read_frame(stream.substr(offset), frames.size(), offset);
    if (!frame) throw BadInput("byte " + std::to_string(offset) + ": a cut-off frame");
    frames.push_back(*frame);
    offset += frame->bytes.size();
  }
  return frames;
}

std::string complaint_about(std::string_view stream) {
  try {
    decode_stream(stream);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

Columns<std::string> columns_of(const FrameView& chunk) {
  Columns<std::string> columns;
  open_chunk(chunk, [&](const Columns<std::string_view>& view) {
    columns = {std::string(view.kinds), std::string(view.planes), std::string(view.counts),
               std::string(view.references), std::string(view.expressions)};
  });
  return columns;
}

namespace {

std::string hex_rows(std::string_view bytes, std::uint64_t offset) {
  std::string rows;
  for (std::size_t at = 0; at < bytes.size(); at += 16) {
    char number[32];
    std::snprintf(number, sizeof number, "%06llx ", static_cast<unsigned long long>(offset + at));
    rows += number;
    std::string text;
    for (std::size_t i = at; i < at + 16; ++i) {
      if (i >= bytes.size()) {
        rows += "   ";
        continue;
      }
      const auto byte = static_cast<unsigned char>(bytes[i]);
      std::snprintf(number, sizeof number, " %02x", byte);
      rows += number;
      text += byte >= 0x20 && byte < 0x7f ? bytes[i] : '.';
    }
    rows += "  " + text + "\n";
  }
  return rows;
}

}  // namespace

std::string hex_dump(std::string_view stream) {
  std::string dump;
  std::uint64_t offset = 0;
  for (std::uint64_t number = 0; offset < stream.size(); ++number) {
    // What is no frame (the trailer of a file) is shown as it stands.
    std::optional<FrameView> frame;
    std::string title = "the last " + std::to_string(stream.size() - offset) + " bytes";
    try {
      frame = read_frame(stream.substr(offset), number, offset);
      if (frame) {
        title = "frame " + std::to_string(number) + ": " + name_of(frame->type) + ", " +
                std::to_string(frame->bytes.size()) + " bytes";
      }
    } catch (const BadInput&) {
    }
    const std::string_view bytes = frame ? frame->bytes : stream.substr(offset);
    dump += (dump.empty() ? "" : "\n") + title + "\n" + hex_rows(bytes, offset);
    offset += bytes.size();
  }
  return dump;
}

}  // namespace spoctree
