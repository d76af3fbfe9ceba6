// Visible lines -> JSON.
#pragma once

#include <cstdint>
#include <string>

#include "client/lines/visible_line.hpp"

namespace spoctree {

/// {"level":k,"lines":[{"a":[x,y,z],"b":[x,y,z],"kind":"crease","hidden":false},...]}, kinds
/// "crease" and "silhouette", end points in model coordinates as the shortest decimals that read
/// back as the same doubles. One line of text per line.
std::string to_json(const VisibleLines& lines, const Universe& universe, std::uint32_t level);

}  // namespace spoctree
