#include "client/rebuild/material_table.hpp"

#include <algorithm>

namespace spoctree {

namespace {

constexpr auto kAll = ~std::uint64_t{0};

/// Bit s of the k-th word: sides s have bit k.
constexpr std::uint64_t kOutside[6] = {0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc, 0xf0f0f0f0f0f0f0f0,
                                       0xff00ff00ff00ff00, 0xffff0000ffff0000, 0xffffffff00000000};

constexpr std::uint32_t bit(unsigned k) { return std::uint32_t{1} << k; }

}  // namespace

bool MaterialTable::take(NodeKind kind, unsigned planes,
                         std::span<const std::uint32_t> expression) {
  const bool is_mixed = kind == NodeKind::Concave || kind == NodeKind::Vertex;
  if (is_mixed && planes > kMaxPlanes) return false;
  // Others are material inside all their planes: these are as good as bounds.
  own_mask_ = bit(is_mixed ? planes : 0) - 1;
  if (kind == NodeKind::Vertex) {
    tabulate(expression);
  } else if (kind == NodeKind::Concave) {
    // Everything but what is outside all planes.
    std::fill(words_, words_ + (own_mask_ >> 6) + 1, kAll);
    words_[own_mask_ >> 6] &= ~(std::uint64_t{1} << (own_mask_ & 63));
  } else {
    words_[0] = 1;
  }
  return true;
}

/// From the last token to the first, so that what a split chooses from is there: the tables of the
/// two parts, the inner one on top.
void MaterialTable::tabulate(std::span<const std::uint32_t> expression) {
  const std::size_t words = (own_mask_ >> 6) + 1;
  parts_.clear();
  for (std::size_t i = expression.size(); i-- > 0;) {
    const std::uint32_t token = expression[i];
    if (token < kFirstPlaneToken) {
      for (std::size_t w = 0; w < words; ++w) parts_.push_back(token == kInToken ? kAll : 0);
      continue;
    }
    const std::uint32_t k = token - kFirstPlaneToken;
    std::uint64_t* const inside = parts_.end() - words;
    std::uint64_t* const outside = inside - words;
    for (std::size_t w = 0; w < words; ++w) {
      const std::uint64_t of_word = ((w >> (k < 6 ? 0 : k - 6)) & 1) != 0 ? kAll : 0;
      const std::uint64_t is_outside = k < 6 ? kOutside[k] : of_word;
      outside[w] = (outside[w] & is_outside) | (inside[w] & ~is_outside);
    }
    parts_.resize_unset(parts_.size() - words);
  }
  std::copy(parts_.begin(), parts_.begin() + words, words_);
}

MaterialTable::PairSums MaterialTable::sums_of_pair(unsigned k, unsigned l) const {
  PairSums sums{};
  if (!is_one_word()) return sums;
  // Sectors that count minus once add one where they are not material, so that sums are natural
  // numbers.
  std::uint64_t terms[4] = {words_[0]};
  unsigned count = 1;
  for (const unsigned plane : {k, l}) {
    if (!is_own(plane)) continue;  // no material outside of a bound
    for (unsigned i = 0; i < count; ++i) terms[count + i] = ~(terms[i] >> bit(plane));
    count *= 2;
  }
  sums.zero = count / 2;
  for (unsigned i = 0; i < count; ++i) {
    std::uint64_t carry = terms[i];
    for (std::uint64_t& digit : sums.digits) {
      const std::uint64_t both = digit & carry;
      digit ^= carry;
      carry = both;
    }
  }
  return sums;
}

MaterialTable::SidesSet MaterialTable::not_zero(const PairSums& sums) const {
  if (!is_one_word()) return kAll;
  SidesSet result = 0;
  for (unsigned i = 0; i < 3; ++i) {
    result |= ((sums.zero >> i) & 1) != 0 ? ~sums.digits[i] : sums.digits[i];
  }
  return result;
}

MaterialTable::SidesSet MaterialTable::not_zero_with(const PairSums& sums, unsigned m) const {
  if (!is_one_word() || !is_own(m)) return not_zero(sums);
  SidesSet result = 0;
  for (const SidesSet digit : sums.digits) result |= digit ^ (digit >> bit(m));
  return result & ~kOutside[m];
}

MaterialTable::SidesSet MaterialTable::possible(Sides sides, Sides in_doubt) const {
  if ((sides & ~own_mask_) != 0) return 0;
  if (!is_one_word()) return kAll;
  SidesSet result = kAll;
  for (unsigned k = 0; is_own(k); ++k) {
    if ((in_doubt & bit(k)) != 0) continue;
    result &= (sides & bit(k)) != 0 ? kOutside[k] : ~kOutside[k];
  }
  return result;
}

}  // namespace spoctree
