// Any bytes into one of the mesh readers (SPOCTREE_FUZZ_FORMAT says which). A reader may throw
// BadInput and nothing else, and a soup keeps what read_mesh.hpp promises.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/read_mesh.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

namespace {

using namespace spoctree;

#ifdef SPOCTREE_FUZZ_BINARY_STL
// A binary STL file is one by its size: the facet count follows from it, and bytes beyond the last
// whole facet are dropped.
std::string file_of(std::string_view input) {
  constexpr std::size_t kHeader = 80;
  constexpr std::size_t kFacet = 50;
  std::string file(input.substr(0, kHeader));
  file.resize(kHeader, '\0');
  input.remove_prefix(std::min(input.size(), kHeader + 4));
  const auto facets = static_cast<std::uint32_t>(input.size() / kFacet);
  mesh_test::append(file, facets);
  return file + std::string(input.substr(0, kFacet * facets));
}
#else
std::string_view file_of(std::string_view input) { return input; }
#endif

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = file_of({reinterpret_cast<const char*>(data), size});
  try {
    const PolygonSoup soup = parse_mesh(MeshFormat::SPOCTREE_FUZZ_FORMAT, file, "input");
    if (!mesh_test::broken_promise(soup).empty()) std::abort();
  } catch (const BadInput&) {
  }
  return 0;
}
