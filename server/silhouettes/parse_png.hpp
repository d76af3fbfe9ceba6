// The bytes of a PNG file -> a mask.
#pragma once

#include <string_view>

#include "server/silhouettes/find_object.hpp"

namespace spoctree {

/// See read_mask.hpp. The size is judged before anything is unpacked.
MaskReading parse_png(std::string_view bytes, std::string_view name);

}  // namespace spoctree
