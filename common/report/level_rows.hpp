// A tree, whole or in part -> what each of its levels holds and costs, as text, CSV and JSON.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/tree/octree.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// One level in the paper's table.
struct LevelRow {
  std::uint32_t level = 0;
  LevelBytes cost;
  std::array<std::uint32_t, kNodeKindCount> nodes{};  ///< of each kind
  std::uint32_t new_planes = 0;                       ///< that appear for the first time
  std::uint64_t plane_references = 0;
  double error_percent = 0;  ///< certified bound, in % of the universe cube's diagonal
  double inner_volume = 0;   ///< model units cubed
  double outer_volume = 0;
  double inner_area = 0;  ///< model units squared; not in the table for people
  double outer_area = 0;
};

/// The rows of a tree's levels. `costs` has one entry per level. Linear in the tree's size.
std::vector<LevelRow> level_rows(const Octree& tree, std::span<const LevelBytes> costs);

/// Columns for people, with a line of headings.
std::string to_table(std::span<const LevelRow> rows);

/// The names of the columns, then a line per level.
std::string to_csv(std::span<const LevelRow> rows);

/// {"model":…,"total_bytes":…,"levels":[…]}: the fields of LevelRow, `error` for error_percent.
std::string to_json(std::string_view model, std::span<const LevelRow> rows);

/// The array of `levels` alone.
std::string levels_to_json(std::span<const LevelRow> rows);

}  // namespace spoctree
