// The bytes of a PBM or PGM file -> a mask.
#pragma once

#include <string_view>

#include "server/silhouettes/find_object.hpp"

namespace spoctree {

/// See read_mask.hpp. One picture a file: what follows it is an error. REQUIRES: bytes that begin
/// with P1, P2, P4 or P5.
MaskReading parse_netpbm(std::string_view bytes, std::string_view name);

}  // namespace spoctree
