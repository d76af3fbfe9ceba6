#include "server/mesh/parse_stl.hpp"

#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/parse_binary_stl.hpp"
#include "server/mesh/parse_text_stl.hpp"

namespace spoctree {

PolygonSoup parse_stl(std::string_view bytes, std::string_view name) {
  if (bytes.empty()) throw BadInput(std::string(name) + ": the file is empty");
  if (!has_size_of_binary_stl(bytes) && looks_like_text_stl(bytes)) {
    return parse_text_stl(bytes, name);
  }
  return parse_binary_stl(bytes, name);
}

}  // namespace spoctree
