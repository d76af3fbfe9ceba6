// Any bytes into any of the mesh readers: the first byte selects the format, the rest is the file.
// A reader may throw BadInput and nothing else, and a soup keeps what read_mesh.hpp promises.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "common/base/errors.hpp"
#include "server/mesh/read_mesh.hpp"
#include "tests/unit/mesh/mesh_test_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spoctree;
  if (size == 0) return 0;
  const std::string_view file(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const PolygonSoup soup = parse_mesh(static_cast<MeshFormat>(data[0] % 4), file, "input");
    if (!mesh_test::broken_promise(soup).empty()) std::abort();
  } catch (const BadInput&) {
  }
  return 0;
}
