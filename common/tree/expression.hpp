// Reading of expressions (see octree.hpp) token by token.
#pragma once

#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// Behind the expression that starts at `token`. REQUIRES: it is well-formed. O(its length).
inline const std::uint32_t* skip_expression(const std::uint32_t* token) {
  for (std::size_t wanted = 1; wanted > 0; ++token) {
    wanted = *token < kFirstPlaneToken ? wanted - 1 : wanted + 1;
  }
  return token;
}

/// The union of `plane_count` half-spaces (a CONCAVE node's) as an expression: in if inside the
/// first plane, else in if inside the second, ..., else out.
inline std::vector<std::uint32_t> union_of(std::uint32_t plane_count) {
  std::vector<std::uint32_t> tokens;
  tokens.reserve(2 * std::size_t{plane_count} + 1);
  for (std::uint32_t plane = 0; plane < plane_count; ++plane) {
    tokens.push_back(kFirstPlaneToken + plane);
    tokens.push_back(kInToken);
  }
  tokens.push_back(kOutToken);
  return tokens;
}

}  // namespace spoctree
