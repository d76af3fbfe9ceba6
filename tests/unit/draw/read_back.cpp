#include "tests/unit/draw/read_back.hpp"

#include <cstdlib>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace spoctree::test {

namespace {

std::string attribute(const std::string& tag, const std::string& name) {
  std::smatch match;
  const std::regex pattern("\\s" + name + "=\"([^\"]*)\"");
  return std::regex_search(tag, match, pattern) ? match[1].str() : "";
}

void append_path(const std::string& data, const Segment& attributes, std::vector<Segment>& all) {
  static const std::regex token("([Mlhv])|(-?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+))|([^\\s])");
  char command = 0;
  std::vector<double> numbers;
  Vec2 at{0.0};
  for (std::sregex_iterator it(data.begin(), data.end(), token), end; it != end; ++it) {
    if ((*it)[3].matched) throw std::runtime_error("path data: " + (*it)[3].str());
    if ((*it)[1].matched) {
      if (!numbers.empty()) throw std::runtime_error("path data: numbers left over");
      command = (*it)[1].str()[0];
      continue;
    }
    numbers.push_back(std::stod((*it)[2].str()));
    if (command == 'M' && numbers.size() == 2) {
      at = {numbers[0], numbers[1]};
    } else if (command == 'l' && numbers.size() == 2) {
      const Vec2 next = at + Vec2{numbers[0], numbers[1]};
      all.push_back({at, next, attributes.layer, attributes.data});
      at = next;
    } else if (command == 'h' || command == 'v') {
      const Vec2 next = at + (command == 'h' ? Vec2{numbers[0], 0} : Vec2{0, numbers[0]});
      all.push_back({at, next, attributes.layer, attributes.data});
      at = next;
    } else {
      continue;
    }
    numbers.clear();
  }
}

}  // namespace

std::vector<Segment> read_svg(const std::string& svg) {
  std::vector<Segment> segments;
  std::string group;
  static const std::regex tag("<[^>]*>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
    const std::string text = it->str();
    if (text.rfind("<g ", 0) == 0) group = attribute(text, "class");
    if (text == "</g>") group.clear();
    if (text.rfind("<path ", 0) != 0) continue;
    Segment attributes;
    attributes.layer = group.empty() ? attribute(text, "class") : group;
    attributes.data = attribute(text, "data-planes");
    append_path(attribute(text, "d"), attributes, segments);
  }
  return segments;
}

std::vector<std::pair<int, std::string>> read_dxf_pairs(const std::string& dxf) {
  std::istringstream text(dxf);
  std::vector<std::pair<int, std::string>> pairs;
  std::string code;
  std::string value;
  while (std::getline(text, code) && std::getline(text, value))
    pairs.emplace_back(std::stoi(code), value);
  return pairs;
}

std::vector<Segment> read_dxf(const std::string& dxf) {
  std::vector<Segment> segments;
  std::string kind;
  Segment entity;
  bool has_last_vertex = false;
  Vec2 last_vertex{0.0};
  const auto finish = [&] {
    if (kind == "LINE") segments.push_back(entity);
    if (kind == "POLYLINE") has_last_vertex = false;
    if (kind == "VERTEX") {
      if (has_last_vertex) segments.push_back({last_vertex, entity.a, entity.layer, ""});
      last_vertex = entity.a;
      has_last_vertex = true;
    }
  };
  bool is_entity = false;
  for (const auto& [code, value] : read_dxf_pairs(dxf)) {
    if (code == 2 && value == "ENTITIES") is_entity = true;
    if (!is_entity) continue;
    if (code == 0) {
      finish();
      kind = value;
      entity = {};
    }
    if (code == 8) entity.layer = value;
    if (code == 10) entity.a.x = std::stod(value);
    if (code == 20) entity.a.y = std::stod(value);
    if (code == 11) entity.b.x = std::stod(value);
    if (code == 21) entity.b.y = std::stod(value);
    if (code == 1000) entity.data += (entity.data.empty() ? "" : " ") + value;
  }
  return segments;
}

std::vector<Segment> read_hpgl(const std::string& hpgl) {
  std::vector<Segment> segments;
  Vec2 at{0.0};
  std::string pen;
  std::istringstream text(hpgl);
  for (std::string instruction; std::getline(text >> std::ws, instruction, ';');) {
    const std::string name = instruction.substr(0, 2);
    std::istringstream arguments(instruction.substr(2));
    if (name == "SP") pen = instruction.substr(2);
    if (name != "PU" && name != "PD") continue;
    double x = 0;
    double y = 0;
    char comma = 0;
    while (arguments >> x >> comma >> y) {
      const Vec2 next = Vec2{x, y} / 40.0;
      if (name == "PD") segments.push_back({at, next, pen, ""});
      at = next;
      arguments >> comma;
    }
  }
  return segments;
}

bool is_well_formed_xml(const std::string& text) {
  static const std::regex tag(
      "<(/?)([A-Za-z][A-Za-z0-9]*)((?:\\s+[-A-Za-z]+=\"[^\"<]*\")*)\\s*(/?)>");
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    std::smatch match;
    const std::string rest = text.substr(at, 100'000);
    if (!std::regex_search(rest, match, tag, std::regex_constants::match_continuous)) return false;
    at += match.length();
    if (match[1].length() > 0) {
      if (open.empty() || open.back() != match[2].str()) return false;
      open.pop_back();
    } else if (match[4].length() == 0) {
      open.push_back(match[2].str());
    }
  }
  return open.empty();
}

}  // namespace spoctree::test
