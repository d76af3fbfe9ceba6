#include "common/wire/answer_get.hpp"

namespace spoctree {

GetAnswer answer_get(const SpoFile& file, const GetRequest& request) {
  const ResumePoint held = request.held;
  const auto byte = [&] { return "byte " + std::to_string(held.byte); };
  const auto hash = file.hash_before(held.byte);
  if (!hash) {
    // Another version of the model has its boundaries elsewhere: that is the likely reason.
    return ErrorMessage{ErrorCode::BadOffset, byte() + " is not the beginning of a frame"};
  }
  if (held.byte > 0 && *hash != held.hash) {
    return ErrorMessage{ErrorCode::ChangedModel,
                        "the model has changed: the bytes before " + byte() + " are others"};
  }
  if (const auto slice = file.slice(request.levels, held.byte)) return *slice;
  return ErrorMessage{ErrorCode::BadOffset, "nothing of the levels asked for follows " + byte()};
}

}  // namespace spoctree
