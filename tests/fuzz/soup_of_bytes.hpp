// Short strings of bytes as polygon soups, and back: what the fuzzer of repair plays with.
#pragma once

#include <string>
#include <string_view>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// The first byte says how many points there are (1 to 64), the second how coordinates are spread
/// (three bytes a point are whole numbers, or with noise below 10^-6, or with exponents of their
/// own, middling or extreme) and what precision the soup claims. Then each face: a byte for its number of corners (3 to 6), a byte for
/// each. Bytes run out as zeros; faces end with the bytes. The soup is as read_mesh leaves it, but
/// for faces that a reader would refuse, which are left out; it may have no faces.
PolygonSoup soup_of_bytes(std::string_view bytes);

/// Bytes that make a soup much like this one: its points scaled into whole numbers from -127 to
/// 127. REQUIRES: at most 64 points, faces of 3 to 6 corners.
std::string bytes_of_soup(const PolygonSoup& soup);

}  // namespace spoctree
