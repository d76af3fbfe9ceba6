// Fuzzes the readers of masks, and what is built of a mask that can be read.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "server/silhouettes/build_from_silhouettes.hpp"
#include "server/silhouettes/read_mask.hpp"
#include "server/silhouettes/views.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spoctree;
  if (size == 0) return 0;
  try {
    Mask mask = parse_mask({reinterpret_cast<const char*>(data) + 1, size - 1}, "mask").mask;
    if (mask.width > 300 || mask.height > 300) return 0;
    const Silhouette silhouette{data[0] % kViewCount, std::move(mask)};
    SilhouetteOptions options;
    options.rules.max_depth = 5;
    options.grow = data[0] >= 128;
    const auto trees = build_from_silhouettes({}, std::span(&silhouette, 1), options);
    if (!validate(trees.front()).empty()) std::abort();
  } catch (const BadInput&) {
  }
  return 0;
}
