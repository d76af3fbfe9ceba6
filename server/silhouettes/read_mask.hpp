// A picture file -> a mask.
#pragma once

#include <filesystem>
#include <string_view>

#include "server/silhouettes/mask.hpp"

namespace spoctree {

/// Reads PBM and PGM (plain and raw) and PNG files; the content says which it is. The object is
/// what is bright (at least half of white, before a black background where a PNG is transparent),
/// and in PBM files the bits that are 1. Throws BadInput, naming the file and the place in it, for
/// anything that is not such a picture or has more than kMostMaskPixels pixels in a row or column.
Mask read_mask(const std::filesystem::path& path);

/// The same for a file's content; `name` stands before error messages.
Mask parse_mask(std::string_view bytes, std::string_view name);

}  // namespace spoctree
