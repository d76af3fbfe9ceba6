#include "client/draw/write_json.hpp"

#include <charconv>

namespace spoctree {

namespace {

void append_number(std::string& text, double value) {
  char buffer[32];
  // Adding zero turns -0 into 0.
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0);
  text.append(buffer, result.ptr);
}

void append_point(std::string& text, Vec3 point) {
  text += '[';
  append_number(text, point.x);
  text += ',';
  append_number(text, point.y);
  text += ',';
  append_number(text, point.z);
  text += ']';
}

}  // namespace

std::string to_json(const VisibleLines& lines, const Universe& universe, std::uint32_t level) {
  std::string json = "{\"level\":" + std::to_string(level) + ",\"lines\":[";
  const char* separator = "\n";
  for (const VisibleLine& line : lines) {
    json += separator;
    separator = ",\n";
    json += "{\"a\":";
    append_point(json, universe.to_model(line.a));
    json += ",\"b\":";
    append_point(json, universe.to_model(line.b));
    json += line.kind == LineKind::Crease ? ",\"kind\":\"crease\"" : ",\"kind\":\"silhouette\"";
    json += line.hidden ? ",\"hidden\":true}" : ",\"hidden\":false}";
  }
  json += lines.empty() ? "]}\n" : "\n]}\n";
  return json;
}

}  // namespace spoctree
