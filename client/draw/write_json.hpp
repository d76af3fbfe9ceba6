// Pictures -> JSON: the lines in space, with all that is known of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "client/draw/sheet.hpp"

namespace spoctree {

/// {"model":...,"level":k,"views":[...],"lines":[...]}, one line of text per view and line.
/// Views: {"name":..., "toward_viewer":[x,y,z],"right":...,"up":...}, unit vectors, and "eye" in
/// model coordinates for perspectives. Lines: {"a":[x,y,z],"b":...,"kind":"crease" or "silhouette",
/// "hidden":false,"step":false,"planes":[...],"node":"convex","level":3,"inherited":false,"view":0}:
/// end points in model coordinates, the number of each plane in the plane table or the cell wall it
/// is, as in "x=12.5" (name_of), where the tree has the line from, and the index of its view.
/// Numbers are the shortest decimals that read back as the same doubles.
std::string to_json(std::span<const Picture> pictures, const Universe& universe,
                    std::string_view model, std::uint32_t level);

}  // namespace spoctree
