// What a server sends for a `get`: a slice of the file, or why not. No sockets here.
#pragma once

#include <string_view>
#include <variant>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"

namespace spoctree {

/// The frames to send, in the file's memory, or the error to send.
using GetAnswer = std::variant<std::string_view, ErrorMessage>;

/// The frames of `file` that `request` asks for and does not hold yet (whatever its name says).
/// BadOffset where there are none or `held` ends inside a frame; ChangedModel where the held bytes
/// are not those of the file.
GetAnswer answer_get(const SpoFile& file, const GetRequest& request);

}  // namespace spoctree
