#include "server/silhouettes/read_mask.hpp"

#include <cstring>
#include <string>

#include "common/base/errors.hpp"
#include "common/base/file_kind.hpp"
#include "common/wire/mapped_file.hpp"
#include "server/silhouettes/parse_netpbm.hpp"
#include "server/silhouettes/parse_png.hpp"

namespace spoctree {

MaskReading read_mask(const std::filesystem::path& path) {
  const MappedFile file(path);
  return parse_mask(file.bytes(), path.string());
}

MaskReading parse_mask(std::string_view bytes, std::string_view name) {
  if (bytes.starts_with("\x89PNG")) return parse_png(bytes, name);
  if (bytes.size() >= 2 && bytes[0] == 'P' && std::strchr("1245", bytes[1]) != nullptr)
    return parse_netpbm(bytes, name);
  if (const auto kind = find_file_kind(bytes))
    throw BadInput(std::string(name) + ": is " + kind->name + ", not a PBM, PGM or PNG file");
  throw BadInput(std::string(name) + ": byte 0: neither a PBM nor a PGM nor a PNG file");
}

}  // namespace spoctree
