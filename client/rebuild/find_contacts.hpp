// Carriers' edges -> where they touch or cross.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"
#include "client/rebuild/chain.hpp"
#include "client/rebuild/vertex_welder.hpp"

namespace spoctree {

/// `vertex` is to be put into an edge, at `along` of its length.
struct Cut {
  std::uint32_t edge = 0;
  double along = 0;
  std::uint32_t vertex = 0;
  auto operator<=>(const Cut&) const = default;
};

/// The edges of every carrier that is `active`, as rows of a table.
struct EdgesOfCarriers {
  struct Edge {
    std::uint32_t number;  ///< in the chain
    std::uint32_t a;
    std::uint32_t b;
  };
  std::vector<std::uint32_t> begin;
  std::vector<Edge> edges;
  std::vector<std::uint32_t> edge_begin;  ///< edges + 1 offsets into the chain

  EdgesOfCarriers(const Chain& chain, const std::vector<bool>& active);
};

/// The cuts for all contacts of edges with an end in `new_ends` (empty: of all); crossings become
/// vertices. In parallel; the order does not depend on the threads. About O(n log n) in the edges
/// of a carrier, if these are small or few.
std::vector<Cut> find_cuts(const Chain& chain, const EdgesOfCarriers& rows,
                           const Carriers& carriers, const std::vector<bool>& new_ends,
                           VertexWelder& welder);

}  // namespace spoctree
