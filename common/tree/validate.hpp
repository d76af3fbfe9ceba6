// Names every broken invariant of a tree.
#pragma once

#include <string>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// The broken invariants of `tree`, one line each, at most `limit` of them; empty for a valid tree.
/// Checked: the universe and every plane are valid; level sizes follow from the GREY counts, and no
/// level is empty; no level deeper than kMaxDepth; statements are finite and not negative; columns
/// have matching lengths; kinds are known; reference counts fit the kind (White, Black: 0; Convex,
/// Vertex >= 1; Concave >= 2); references are in range, distinct within a node, and appear for the
/// first time in increasing order; no node repeats a plane of an ancestor; expressions are
/// well-formed and use planes of their node. Linear in the tree's size. REQUIRES: limit > 0.
std::vector<std::string> validate(const Octree& tree, std::size_t limit = 20);

/// True if all numbers are finite and not negative, and what is certain is not more than what is
/// possible.
bool is_valid(const LevelStatement& statement);

/// What is wrong with a node of `kind` that has `count` planes; nullptr if nothing is.
const char* plane_count_error(NodeKind kind, std::size_t count);

/// True if `tokens` is one well-formed preorder expression over `plane_count` planes.
bool is_well_formed(std::span<const std::uint32_t> tokens, std::uint32_t plane_count);

}  // namespace spoctree
