#include "common/report/level_rows.hpp"

#include <algorithm>
#include <cassert>

#include "common/report/json_text.hpp"
#include "common/report/text_table.hpp"

namespace spoctree {

std::vector<LevelRow> level_rows(const Octree& tree, std::span<const LevelBytes> costs) {
  assert(costs.size() == tree.levels.size());
  std::vector<LevelRow> rows;
  std::uint32_t known_planes = 0;
  for (std::size_t k = 0; k < tree.levels.size(); ++k) {
    const Level& level = tree.levels[k];
    LevelRow row;
    row.level = static_cast<std::uint32_t>(k);
    row.cost = costs[k];
    row.nodes = level.count_kinds();
    // Planes are numbered in order of first appearance.
    std::uint32_t planes = known_planes;
    for (const std::uint32_t plane : level.references) planes = std::max(planes, plane + 1);
    row.new_planes = planes - known_planes;
    known_planes = planes;
    row.plane_references = level.references.size();
    row.error_percent = 100 * (level.statement.error_bound / tree.universe.diagonal());
    row.inner_volume = level.statement.inner_volume;
    row.outer_volume = level.statement.outer_volume;
    row.inner_area = level.statement.inner_area;
    row.outer_area = level.statement.outer_area;
    rows.push_back(row);
  }
  return rows;
}

std::string to_table(std::span<const LevelRow> rows) {
  TableRow headings = {"level", "bytes", "total bytes"};
  for (const char* kind : kNodeKindNames) headings.emplace_back(kind);
  for (const char* rest : {"new planes", "references", "error %", "inner volume", "outer volume"})
    headings.emplace_back(rest);
  std::vector<TableRow> lines = {headings};
  for (const LevelRow& row : rows) {
    TableRow cells = {std::to_string(row.level), std::to_string(row.cost.bytes),
                      std::to_string(row.cost.total_bytes)};
    for (const std::uint32_t count : row.nodes) cells.push_back(std::to_string(count));
    cells.push_back(std::to_string(row.new_planes));
    cells.push_back(std::to_string(row.plane_references));
    cells.push_back(to_short_text(row.error_percent));
    cells.push_back(to_short_text(row.inner_volume));
    cells.push_back(to_short_text(row.outer_volume));
    lines.push_back(std::move(cells));
  }
  return align_columns(lines);
}

std::string to_csv(std::span<const LevelRow> rows) {
  std::string text = "level,bytes,total_bytes";
  for (const char* kind : kNodeKindNames) text += std::string(",") + kind;
  text +=
      ",new_planes,plane_references,error_percent,inner_volume,outer_volume,"
      "inner_area,outer_area\n";
  for (const LevelRow& row : rows) {
    text += std::to_string(row.level) + ',' + std::to_string(row.cost.bytes) + ',' +
            std::to_string(row.cost.total_bytes);
    for (const std::uint32_t count : row.nodes) text += ',' + std::to_string(count);
    text += ',';
    text += std::to_string(row.new_planes) + ',' + std::to_string(row.plane_references);
    for (const double value :
         {row.error_percent, row.inner_volume, row.outer_volume, row.inner_area, row.outer_area})
      text += ',' + to_text(value);
    text += '\n';
  }
  return text;
}

std::string levels_to_json(std::span<const LevelRow> rows) {
  std::string json = "[";
  for (const LevelRow& row : rows) {
    json += row.level == 0 ? "\n" : ",\n";
    json += R"({"level":)" + std::to_string(row.level);
    json += R"(,"bytes":)" + std::to_string(row.cost.bytes);
    json += R"(,"total_bytes":)" + std::to_string(row.cost.total_bytes);
    json += R"(,"nodes":{)";
    for (int kind = 0; kind < kNodeKindCount; ++kind) {
      if (kind > 0) json += ',';
      json += quote_json(kNodeKindNames[kind]) + ":" +
              std::to_string(row.nodes[static_cast<std::size_t>(kind)]);
    }
    json += R"(},"new_planes":)" + std::to_string(row.new_planes);
    json += R"(,"plane_references":)" + std::to_string(row.plane_references);
    json += R"(,"error":)" + to_text(row.error_percent);
    json += R"(,"inner_volume":)" + to_text(row.inner_volume);
    json += R"(,"outer_volume":)" + to_text(row.outer_volume);
    json += R"(,"inner_area":)" + to_text(row.inner_area);
    json += R"(,"outer_area":)" + to_text(row.outer_area) + "}";
  }
  return json + "\n]";
}

std::string to_json(std::string_view model, std::span<const LevelRow> rows) {
  const std::uint64_t total = rows.empty() ? 0 : rows.back().cost.total_bytes;
  return R"({"model":)" + quote_json(model) + R"(,"total_bytes":)" + std::to_string(total) +
         R"(,"levels":)" + levels_to_json(rows) + "}\n";
}

}  // namespace spoctree
