// Cells -> columns of text.
#pragma once

#include <string>
#include <vector>

namespace spoctree {

using TableRow = std::vector<std::string>;

/// One line per row, every column as wide as its widest cell, cells to the right of their column,
/// except in the last one, which may be text of any length. REQUIRES: rows of equal length.
std::string align_columns(const std::vector<TableRow>& rows);

}  // namespace spoctree
