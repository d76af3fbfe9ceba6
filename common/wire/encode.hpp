// A tree to the frames of its stream.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "common/tree/octree.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// Gives the frames of a full transmission of `tree` to `sink`, in order and one at a time: the
/// header; then for each level its chunks and its end. The bytes are a function of the arguments.
/// Texts of `source` that are too long or not printable are made so (clean_text). Holds one frame
/// in memory; linear in the tree's size.
/// REQUIRES: validate(tree) finds nothing, at least one level. Throws BadInput when the tree is
/// larger than the limits (limits.hpp) or a level's statement is not finite.
void encode_stream(const Octree& tree, const SourceInfo& source,
                   const std::function<void(std::string_view frame)>& sink);

/// The same frames as one string.
std::string encode_stream(const Octree& tree, const SourceInfo& source);

}  // namespace spoctree
