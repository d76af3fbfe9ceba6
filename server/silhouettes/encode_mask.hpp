// A mask -> the bytes of a picture file.
#pragma once

#include <string>
#include <string_view>

#include "server/silhouettes/mask.hpp"

namespace spoctree {

enum class MaskFormat { Pbm, Pgm, Png };

/// "pbm", "pgm", "png": the format's name and the files' extension.
std::string_view name_of(MaskFormat format);

/// A raw PBM file (the object 1), a raw PGM file or a grey PNG (the object white).
std::string encode_mask(const Mask& mask, MaskFormat format);

}  // namespace spoctree
