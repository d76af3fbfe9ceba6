// A hash table for inner loops: 64-bit keys to 32-bit values, in one flat array.
#pragma once

#include <cstdint>
#include <vector>

namespace spoctree {

/// Spreads the bits of a key over the whole word (the finalizer of SplitMix64).
inline std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Open addressing with linear probing. Equal keys may stand several times; the caller tells their
/// values apart.
class FlatIndex {
 public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  FlatIndex() : slots_(64) {}

  void insert(std::uint64_t key, std::uint32_t value) {
    if (2 * (filled_ + 1) > slots_.size()) grow();
    place({key, value});
    ++filled_;
  }

  /// The first value under `key` that `accept(value)` takes, or kNone.
  template <class Accept>
  std::uint32_t find(std::uint64_t key, Accept&& accept) const {
    const std::size_t slot = find_slot(key, accept);
    return slot == kNoSlot ? kNone : slots_[slot].value;
  }

  /// The same, and removes it.
  template <class Accept>
  std::uint32_t take(std::uint64_t key, Accept&& accept) {
    const std::size_t slot = find_slot(key, accept);
    if (slot == kNoSlot) return kNone;
    const std::uint32_t value = slots_[slot].value;
    slots_[slot].value = kTaken;
    return value;
  }

  void prefetch(std::uint64_t key) const { __builtin_prefetch(&slots_[start_of(key)]); }

 private:
  static constexpr std::uint32_t kTaken = static_cast<std::uint32_t>(-2);
  static constexpr std::size_t kNoSlot = static_cast<std::size_t>(-1);
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t value = kNone;
  };

  std::size_t start_of(std::uint64_t key) const { return mix_bits(key) & (slots_.size() - 1); }

  template <class Accept>
  std::size_t find_slot(std::uint64_t key, Accept&& accept) const {
    for (std::size_t i = start_of(key);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].value == kNone) return kNoSlot;
      if (slots_[i].key == key && slots_[i].value != kTaken && accept(slots_[i].value)) return i;
    }
  }

  void place(Slot slot) {
    std::size_t i = start_of(slot.key);
    while (slots_[i].value != kNone) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = slot;
  }

  /// Makes room, also by forgetting what was taken.
  void grow() {
    std::size_t alive = 0;
    for (const Slot& slot : slots_) alive += slot.value < kTaken ? 1 : 0;
    std::vector<Slot> old(4 * alive > slots_.size() ? 2 * slots_.size() : slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.value < kTaken) place(slot);
    }
    filled_ = alive;
  }

  std::vector<Slot> slots_;  // a power of two of them, at most half filled
  std::size_t filled_ = 0;   // taken ones included
};

}  // namespace spoctree
