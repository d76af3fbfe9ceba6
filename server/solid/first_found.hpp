// How often something was found in a mesh, and the first places, for one line of text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spoctree {

/// So many places are named; what is found more often is counted.
inline constexpr std::size_t kMostPlacesNamed = 3;

/// Counts what is added and keeps the kMostPlacesNamed smallest keys, in order. A key says where a
/// place comes in the file, so that the first places are named whatever the order of the search.
template <class Key>
class FirstFound {
 public:
  void add(const Key& key) {
    ++count_;
    const auto after = std::upper_bound(first_.begin(), first_.end(), key);
    if (first_.size() == kMostPlacesNamed && after == first_.end()) return;
    first_.insert(after, key);
    if (first_.size() > kMostPlacesNamed) first_.pop_back();
  }

  /// As if all that was added to `other` were added here.
  void add_all(const FirstFound& other) {
    for (const Key& key : other.first_) add(key);
    count_ += other.count_ - other.first_.size();
  }

  std::size_t count() const { return count_; }
  const std::vector<Key>& first() const { return first_; }

  /// "first at A, B and C"; "at A and B" if there are no more. `place` turns a key into text.
  template <class Place>
  std::string places(const Place& place) const {
    std::string text = count_ > first_.size() ? "first at " : "at ";
    for (std::size_t i = 0; i < first_.size(); ++i) {
      if (i > 0) text += i + 1 == first_.size() ? " and " : ", ";
      text += place(first_[i]);
    }
    return text;
  }

 private:
  std::size_t count_ = 0;
  std::vector<Key> first_;
};

}  // namespace spoctree
