// Leaves of a classical tree that are less, or more, than the solid in their cell.
#pragma once

#include <cstdint>

namespace spoctree {

/// A leaf whose cell is mixed: its colour was chosen.
struct PartialCell {
  std::uint32_t node = 0;     ///< in its level
  std::uint32_t witness = 0;  ///< a triangle of the solid that touches the cell
};

}  // namespace spoctree
