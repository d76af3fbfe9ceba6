#include "client/draw/write_json.hpp"

#include <charconv>

#include "client/draw/drawing.hpp"
#include "common/report/json_text.hpp"

namespace spoctree {

namespace {

void append_number(std::string& text, double value) {
  char buffer[32];
  // Adding zero turns -0 into 0.
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0);
  text.append(buffer, result.ptr);
}

void append_vector(std::string& text, const char* name, Vec3 vector) {
  text += '"';
  text += name;
  text += "\":[";
  append_number(text, vector.x);
  text += ',';
  append_number(text, vector.y);
  text += ',';
  append_number(text, vector.z);
  text += ']';
}

void append_plane(std::string& text, PlaneRef plane, const Universe& universe) {
  const std::string name = name_of(plane, universe);
  text += plane.is_wall() ? quote_json(name) : name;
}

const char* truth(bool value) { return value ? "true" : "false"; }

void append_view(std::string& json, const View& view, const Universe& universe) {
  json += "{\"name\":" + quote_json(view.name) + ',';
  append_vector(json, "toward_viewer", view.camera.toward_viewer());
  json += ',';
  append_vector(json, "right", view.camera.right());
  json += ',';
  append_vector(json, "up", view.camera.up());
  if (view.camera.is_perspective()) {
    json += ',';
    append_vector(json, "eye", universe.to_model(view.camera.eye()));
  }
  json += '}';
}

/// What a line or a stretch of one knows of the tree.
void append_origin(std::string& json, const PlaneRef (&planes)[2], const LineSource& source,
                   const Universe& universe) {
  json += "\"planes\":[";
  append_plane(json, planes[0], universe);
  json += ',';
  append_plane(json, planes[1], universe);
  json += std::string("],\"node\":\"") + name_of(source.kind) +
          "\",\"level\":" + std::to_string(source.level) +
          ",\"inherited\":" + truth(source.is_inherited);
}

void append_stretches(std::string& json, const std::vector<LineStretch>& stretches,
                      const Universe& universe) {
  json += ",\"stretches\":";
  char separator = '[';
  for (const LineStretch& stretch : stretches) {
    json += separator;
    json += "{\"end\":";
    append_number(json, stretch.end);
    json += ',';
    append_origin(json, stretch.planes, stretch.source, universe);
    json += '}';
    separator = ',';
  }
  json += ']';
}

void append_line(std::string& json, const VisibleLine& line, const Universe& universe,
                 std::size_t view) {
  json += '{';
  append_vector(json, "a", universe.to_model(line.a));
  json += ',';
  append_vector(json, "b", universe.to_model(line.b));
  json += line.kind == LineKind::Crease ? ",\"kind\":\"crease\"" : ",\"kind\":\"silhouette\"";
  json += std::string(",\"hidden\":") + truth(line.hidden) + ",\"step\":" + truth(line.is_step);
  json += ',';
  append_origin(json, line.planes, line.source, universe);
  if (!line.stretches.empty()) append_stretches(json, line.stretches, universe);
  json += ",\"view\":" + std::to_string(view) + '}';
}

}  // namespace

std::string to_json(std::span<const Picture> pictures, const Universe& universe,
                    std::string_view model, std::uint32_t level) {
  std::string json =
      "{\"model\":" + quote_json(model) + ",\"level\":" + std::to_string(level) + ",\"views\":[";
  const char* separator = "\n";
  for (const Picture& picture : pictures) {
    json += separator;
    append_view(json, picture.view, universe);
    separator = ",\n";
  }
  json += "],\n\"lines\":[";
  separator = "\n";
  for (std::size_t view = 0; view < pictures.size(); ++view) {
    for (const VisibleLine& line : pictures[view].lines) {
      json += separator;
      append_line(json, line, universe, view);
      separator = ",\n";
    }
  }
  json += "]}\n";
  return json;
}

}  // namespace spoctree
