// What a node takes of its region, as a table over the sides of its planes.
#pragma once

#include <cstdint>
#include <span>

#include "common/base/plain_vector.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// Sides of a few planes: bit k is set if outside the k-th.
using Sides = std::uint32_t;

/// Says what is material by the sides of planes: the own planes of a node, in their order, and then
/// planes that bound it, outside of which nothing is. Sums are "alternating" over the sectors of
/// planes that meet: what is material counts minus once for each of these planes that it is outside
/// of.
class MaterialTable {
 public:
  static constexpr unsigned kMaxPlanes = 10;  ///< of a VERTEX or CONCAVE node

  /// Takes a node (GREY: what is inside all its planes). False if it has too many planes.
  /// O(expression * 2^planes / 64).
  bool take(NodeKind kind, unsigned planes, std::span<const std::uint32_t> expression);

  bool is_material(Sides sides) const {
    const Sides own = sides & own_mask_;
    return static_cast<bool>(((sides & ~own_mask_) == 0) & ((words_[own >> 6] >> (own & 63)) & 1));
  }
  /// The sum where planes with these bits (unset in `sides`) meet.
  int sum(Sides sides, Sides k) const {
    return int{is_material(sides)} - int{is_material(sides | k)};
  }
  int sum(Sides sides, Sides k, Sides l) const { return sum(sides, k) - sum(sides | l, k); }
  int sum(Sides sides, Sides k, Sides l, Sides m) const {
    return sum(sides, k, l) - sum(sides | m, k, l);
  }

  /// Sets of sides, if the node has at most six planes: bit s stands for sides s of these. If it
  /// has more, all sets are all there is, and everything below answers too much.
  using SidesSet = std::uint64_t;

  /// The sums around all points where planes k and l meet, as binary digits of how much they are
  /// above the least that they can be. For sides with k or l set they are nonsense.
  struct PairSums {
    SidesSet digits[3];
    unsigned zero;  ///< what they are where the sum is zero
  };
  PairSums sums_of_pair(unsigned k, unsigned l) const;
  /// Where sums are not zero.
  SidesSet not_zero(const PairSums& sums) const;
  /// Where there is a sum with plane m (for sides without it): where they differ on its two sides.
  SidesSet not_zero_with(const PairSums& sums, unsigned m) const;
  /// What is possible if only the planes in doubt may have other sides than these: nothing if all
  /// that is outside of a bound.
  SidesSet possible(Sides sides, Sides in_doubt) const;

 private:
  bool is_one_word() const { return own_mask_ < 64; }
  bool is_own(unsigned k) const { return ((own_mask_ >> k) & 1) != 0; }
  void tabulate(std::span<const std::uint32_t> expression);

  Sides own_mask_ = 0;
  std::uint64_t words_[(std::size_t{1} << kMaxPlanes) / 64];  ///< bit s: sides s are material
  PlainVector<std::uint64_t> parts_;                          // of an expression
};

}  // namespace spoctree
