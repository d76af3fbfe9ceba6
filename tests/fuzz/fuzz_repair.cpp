// Small soups of any kind into repair and import. Repair never throws, and makes up no points;
// import may refuse what is left, or makes a solid, of which there is nothing more to repair.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "common/base/errors.hpp"
#include "server/solid/import_solid.hpp"
#include "server/solid/repair.hpp"
#include "tests/fuzz/soup_of_bytes.hpp"

namespace {

using namespace spoctree;

void require(bool is_true) {
  if (!is_true) std::abort();
}

void check(const PolygonSoup& soup) {
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    require(soup.face(f).size() >= 3);
    require(!repeated_vertex(soup.face(f)));
    for (const std::uint32_t corner : soup.face(f)) require(corner < soup.points.size());
  }
}

void require_points_of(const PolygonSoup& soup, const PolygonSoup& original) {
  const auto is_before = [](const glm::dvec3& p, const glm::dvec3& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::vector<glm::dvec3> known = original.points;
  std::sort(known.begin(), known.end(), is_before);
  for (const glm::dvec3& p : soup.points) {
    require(std::binary_search(known.begin(), known.end(), p, is_before));
  }
}

void check(const Solid& solid) {
  require(solid.volume > 0);
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    for (const std::uint32_t n : solid.triangles[t].neighbour) {
      const auto& back = solid.triangles[n].neighbour;
      require(std::find(std::begin(back), std::end(back), t) != std::end(back));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const PolygonSoup soup = soup_of_bytes({reinterpret_cast<const char*>(data), size});
  if (soup.face_count() == 0) return 0;
  const Repair repaired = repair(soup);
  check(repaired.soup);
  require_points_of(repaired.soup, soup);
  ImportOptions options;
  options.turn_shells = true;
  for (const double tolerance : {0.0, 1e-6}) {
    options.flat_tolerance = tolerance;
    try {
      check(import_solid(repaired.soup, "input", options));
      require(repair(repaired.soup).changes.empty());
    } catch (const BadInput&) {
    }
    try {
      check(import_solid(soup, "input", options));
    } catch (const BadInput&) {
    }
  }
  return 0;
}
