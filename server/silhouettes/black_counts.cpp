#include "server/silhouettes/black_counts.hpp"

namespace spoctree {

BlackCounts::BlackCounts(const Mask& mask)
    : stride_(static_cast<std::size_t>(mask.width) + 1),
      sums_(stride_ * (static_cast<std::size_t>(mask.height) + 1)) {
  for (int row = 0; row < mask.height; ++row) {
    std::uint32_t in_row = 0;
    const std::size_t above = static_cast<std::size_t>(row) * stride_;
    for (int column = 0; column < mask.width; ++column) {
      in_row += mask.at(column, row);
      const auto next = static_cast<std::size_t>(column) + 1;
      sums_[above + stride_ + next] = sums_[above + next] + in_row;
    }
  }
}

}  // namespace spoctree
