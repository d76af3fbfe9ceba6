#include "server/commands/info_command.hpp"

#include <cstdio>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "common/program/output.hpp"
#include "common/report/json_text.hpp"
#include "common/report/level_rows.hpp"
#include "common/report/model_note.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/spo_file.hpp"
#include "server/commands/describe_solid.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/solid/import_solid.hpp"

namespace spoctree {

namespace {

/// A name and its value, written as JSON.
using Fields = std::vector<std::pair<const char*, std::string>>;

std::string to_json(const Fields& fields) {
  std::string json;
  for (const auto& [name, value] : fields) {
    json += json.empty() ? '{' : ',';
    json += quote_json(name) + ":" + value;
  }
  return json + "}\n";
}

std::string to_lines(const Fields& fields) {
  std::string text;
  for (const auto& [name, value] : fields) {
    std::string line = std::string(name) + ":";
    line.resize(24, ' ');
    text += line + value + '\n';
  }
  return text;
}

std::string to_json(Vec3 v) {
  std::string json = "[";
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) json += ',';
    json += to_text(v[axis]);
  }
  return json + ']';
}

std::string info_of_spo(const InfoArguments& arguments) {
  const SpoFile file(arguments.file);
  const Octree tree = file.tree();
  const StreamInfo& info = file.info();
  const auto rows = level_rows(tree, file.level_bytes());
  Fields fields = {
      {"file", quote_json(arguments.file)},
      {file.is_whole() ? "model_id" : "partial_id", quote_json(to_hex(file.frames_hash()))},
      {"total_bytes", std::to_string(file.frames().size())},
      {"level_count", std::to_string(info.level_count)},
      {"levels_in_file", std::to_string(file.level_count())},
      {"node_count", std::to_string(info.node_count)},
      {"plane_count", std::to_string(info.plane_count)},
      {"encoding", quote_json("plain")},
      {"center", to_json(info.universe.center)},
      {"side", to_text(info.universe.side())},
      {"diagonal", to_text(info.universe.diagonal())},
      {"scale_exponent", std::to_string(info.universe.scale_exponent)},
      {"half_side", to_text(info.universe.half_side)},
      {"units", quote_json(info.source.units)},
      {"source_name", quote_json(info.source.name)},
      {"source_hash", quote_json(to_hex(info.source.hash))},
      {"build_options", quote_json(info.source.build_options)},
  };
  if (!arguments.as_json) return to_lines(fields) + to_table(rows) + note_on_levels(info.source);
  fields.emplace_back("levels", levels_to_json(rows));
  return to_json(fields);
}

std::string info_of_mesh(const InfoArguments& arguments) {
  const PolygonSoup soup = read_mesh(arguments.file);
  const Solid solid = import_solid(soup, arguments.file, {});
  Vec3 lower = soup.points.front();
  Vec3 upper = lower;
  for (const Vec3 point : soup.points) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  const SolidReport& report = solid.report;
  std::string remarks;
  for (const std::string& remark : soup.remarks) {
    remarks.append(remarks.empty() ? "" : ",").append(quote_json(remark));
  }
  const Fields fields = {
      {"file", quote_json(arguments.file)},
      {"faces", std::to_string(soup.face_count())},
      {"points", std::to_string(soup.points.size())},
      {"facets", std::to_string(solid.facet_count())},
      {"planes", std::to_string(solid.planes.size())},
      {"volume", to_text(solid.volume)},
      {"lower", to_json(lower)},
      {"upper", to_json(upper)},
      {"was_turned", report.was_turned ? "true" : "false"},
      {"triangulated_faces", std::to_string(report.triangulated_faces)},
      {"uneven_faces", std::to_string(report.uneven_faces)},
      {"largest_unevenness", to_text(report.largest_unevenness)},
      {"merged_points", std::to_string(report.merged_points)},
      {"planes_before_merging", std::to_string(report.planes_before_merging)},
      {"largest_move", to_text(report.largest_move)},
      {"remarks", "[" + remarks + "]"},
      {"flat_tolerance", quote_json(describe_flat_tolerance(report.flat_tolerance))},
  };
  return arguments.as_json ? to_json(fields) : to_lines(fields);
}

}  // namespace

void run_info(const InfoArguments& arguments) {
  const bool is_spo = arguments.file.ends_with(".spo");
  print(is_spo ? info_of_spo(arguments) : info_of_mesh(arguments));
}

}  // namespace spoctree
