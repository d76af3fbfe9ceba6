#include "server/build/incidence.hpp"

#include <algorithm>

namespace spoctree {

Incidence::Incidence(const Solid& solid) : begin_(solid.vertices.size() + 1, 0) {
  for (const std::uint32_t vertex : solid.facet_vertices) ++begin_[vertex + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  planes_.resize(solid.facet_vertices.size());
  std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t facet = 0; facet < solid.facet_count(); ++facet) {
    for (const std::uint32_t vertex : solid.vertices_of_facet(facet)) {
      planes_[end[vertex]++] = solid.facet_plane[facet];
    }
  }
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    std::sort(planes_.begin() + begin_[i], planes_.begin() + begin_[i + 1]);
  }
}

}  // namespace spoctree
