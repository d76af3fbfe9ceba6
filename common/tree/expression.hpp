// Reading of expressions (see octree.hpp) token by token.
#pragma once

#include <cstdint>
#include <span>
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

/// For every token of a well-formed expression, the index behind the expression that starts there.
/// O(its length).
inline void find_ends(std::span<const std::uint32_t> tokens, std::vector<std::uint32_t>& ends) {
  const auto count = static_cast<std::uint32_t>(tokens.size());
  ends.resize(count);
  for (std::uint32_t i = count; i-- > 0;) {
    // A split: behind the second of the two expressions that follow.
    ends[i] = tokens[i] < kFirstPlaneToken ? i + 1 : ends[ends[i + 1]];
  }
}

/// The union of `plane_count` half-spaces (a CONCAVE node's) as an expression: in if inside the
/// first plane, else in if inside the second, ..., else out.
inline void union_of(std::uint32_t plane_count, std::vector<std::uint32_t>& tokens) {
  tokens.clear();
  for (std::uint32_t plane = 0; plane < plane_count; ++plane) {
    tokens.push_back(kFirstPlaneToken + plane);
    tokens.push_back(kInToken);
  }
  tokens.push_back(kOutToken);
}
/// The number of each kInToken among the kInTokens, in preorder; of other tokens, how many stand
/// before.
inline void number_in_cells(std::span<const std::uint32_t> tokens,
                            std::vector<std::uint32_t>& numbers) {
  numbers.resize(tokens.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    numbers[i] = count;
    if (tokens[i] == kInToken) ++count;
  }
}

inline std::vector<std::uint32_t> union_of(std::uint32_t plane_count) {
  std::vector<std::uint32_t> tokens;
  union_of(plane_count, tokens);
  return tokens;
}

}  // namespace spoctree
