// Says where a VERTEX node's expression ends, token by token, and how deep it is.
#pragma once

#include <cstdint>
#include <vector>

#include "common/tree/octree.hpp"

namespace spoctree {

/// An expression in preorder is complete when every split has had both its parts; so it needs no
/// length. Holds one bit of state per split that is still open.
class ExpressionMeter {
 public:
  /// REQUIRES: !is_done().
  void take(std::uint32_t token) {
    ++token_count_;
    if (token >= kFirstPlaneToken) {
      open_splits_.push_back(kInside);
      return;
    }
    while (!open_splits_.empty() && open_splits_.back() == kOutside) open_splits_.pop_back();
    if (!open_splits_.empty()) open_splits_.back() = kOutside;
  }
  bool is_done() const { return token_count_ > 0 && open_splits_.empty(); }
  std::size_t token_count() const { return token_count_; }
  std::size_t depth() const { return open_splits_.size(); }
  void restart() {
    token_count_ = 0;
    open_splits_.clear();
  }

 private:
  static constexpr bool kInside = false;  ///< the part that comes next or is under way
  static constexpr bool kOutside = true;
  std::size_t token_count_ = 0;
  std::vector<bool> open_splits_;
};

}  // namespace spoctree
