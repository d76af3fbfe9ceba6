// A picture file -> a mask.
#pragma once

#include <filesystem>
#include <string_view>

#include "server/silhouettes/find_object.hpp"

namespace spoctree {

/// Reads PBM and PGM (plain and raw) and PNG files; the content says which it is. In PBM files the
/// object is the bits that are 1, in others what find_object finds. Throws BadInput, naming the
/// file and the place in it, for anything that is not such a picture or has more than
/// kMostMaskPixels pixels in a row or column, and as find_object does.
MaskReading read_mask(const std::filesystem::path& path);

/// The same for a file's content; `name` stands before error messages.
MaskReading parse_mask(std::string_view bytes, std::string_view name);

}  // namespace spoctree
