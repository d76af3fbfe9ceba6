// Streams taken apart into frames, for tests that look at them or damage them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/wire/frame.hpp"
#include "common/wire/stream_messages.hpp"

namespace spoctree {

/// The frames of `stream`, in its memory. Throws BadInput where they end with anything but a frame.
std::vector<FrameView> frames_of(std::string_view stream);

/// What decode_stream says when it refuses `stream`; empty if it does not.
std::string complaint_about(std::string_view stream);

/// The columns of a chunk, copied.
Columns<std::string> columns_of(const FrameView& chunk);

/// The frames as rows of 16 bytes: offset, hexadecimal, text. A line before each frame names it.
std::string hex_dump(std::string_view stream);

}  // namespace spoctree
