#include "common/report/text_table.hpp"

#include <algorithm>

namespace spoctree {

std::string align_columns(const std::vector<TableRow>& rows) {
  if (rows.empty()) return {};
  const std::size_t last = rows.front().size() - 1;
  std::vector<std::size_t> widths(last, 0);
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < last; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < last; ++i) {
      text.append(widths[i] - row[i].size(), ' ');
      text += row[i] + "  ";
    }
    text += row[last] + '\n';
  }
  return text;
}

}  // namespace spoctree
