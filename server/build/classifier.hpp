// The variable part of the builder: what a cell becomes, for each kind of tree.
#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "server/build/cell.hpp"
#include "server/build/classical_rules.hpp"
#include "server/build/sp_rules.hpp"
#include "server/solid/solid_queries.hpp"

namespace spoctree {

/// Classifies cells one after the other, top down. Not thread-safe: one for each thread.
class Classifier {
 public:
  virtual ~Classifier() = default;

  /// Decides on a cell whose corner states are propagated (corner_states.hpp). Exact.
  virtual void classify(Cell& cell, Decision& decision) = 0;

  /// Bracket the visit of a GREY node's children: its planes are "resolved" there.
  virtual void push(const std::vector<std::uint32_t>& planes) = 0;
  virtual void pop(const std::vector<std::uint32_t>& planes) = 0;
};

/// The kind of tree, with what is chosen about it.
using TreeRules = std::variant<SpRules, ClassicalRules>;

/// REQUIRES: the arguments outlive the result.
std::unique_ptr<Classifier> make_classifier(const Solid& solid, const Incidence& incidence,
                                            const SolidQueries& queries, const TreeRules& rules);

}  // namespace spoctree
