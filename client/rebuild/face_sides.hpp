// Nodes -> the sides of their planes on which faces can lie.
#pragma once

#include <cstdint>
#include <vector>

#include "client/rebuild/carriers.hpp"

namespace spoctree {

/// Per carrier, on which sides faces of T_k can lie: bit 0 for the side of its own normal, bit 1
/// for the other one. More levels only add to it.
class FaceSides {
 public:
  /// Adds what the nodes of one level say. REQUIRES: the carriers of its planes. O(level).
  void add(const Level& level, const Carriers& carriers);

  /// Of all carriers there are: on walls, faces can lie on either side.
  std::vector<std::uint8_t> of(const Carriers& carriers) const;

 private:
  std::vector<std::uint8_t> sides_;
};

}  // namespace spoctree
