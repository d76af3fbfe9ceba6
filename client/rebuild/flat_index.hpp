// A hash table for inner loops: 64-bit keys to 32-bit values, in one flat array.
#pragma once

#include <bit>
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

  bool empty() const { return filled_ == 0; }

  /// Makes room for so many entries at once.
  void reserve(std::size_t count) {
    if (2 * count > slots_.size()) rehash(std::bit_ceil(2 * count));
  }

  void insert(std::uint64_t key, std::uint32_t value) {
    if (2 * ++filled_ > slots_.size()) rehash(2 * slots_.size());
    place({key, value});
  }

  /// The first value under `key`, or kNone.
  std::uint32_t find(std::uint64_t key) const {
    return find(key, [](std::uint32_t) { return true; });
  }

  /// The first value under `key` that `accept(value)` takes, or kNone.
  template <class Accept>
  std::uint32_t find(std::uint64_t key, Accept&& accept) const {
    for (std::size_t i = start_of(key); slots_[i].value != kNone; i = next(i)) {
      if (slots_[i].key == key && accept(slots_[i].value)) return slots_[i].value;
    }
    return kNone;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t value = kNone;
  };

  void rehash(std::size_t size) {
    std::vector<Slot> old(size);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.value != kNone) place(slot);
    }
  }
  std::size_t start_of(std::uint64_t key) const { return mix_bits(key) & (slots_.size() - 1); }
  std::size_t next(std::size_t i) const { return (i + 1) & (slots_.size() - 1); }
  void place(Slot slot) {
    std::size_t i = start_of(slot.key);
    while (slots_[i].value != kNone) i = next(i);
    slots_[i] = slot;
  }

  std::vector<Slot> slots_;  // a power of two of them, at most half filled
  std::size_t filled_ = 0;
};

}  // namespace spoctree
