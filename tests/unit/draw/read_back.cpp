#include "tests/unit/draw/read_back.hpp"

#include <cstdlib>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace spoctree::test {

namespace {

// Regular expressions of the standard library recurse for every letter: not for whole tags.

std::string attribute(const std::string& tag, const std::string& name) {
  const std::string before = ' ' + name + "=\"";
  const std::size_t begin = tag.find(before);
  if (begin == std::string::npos) return "";
  const std::size_t value = begin + before.size();
  return tag.substr(value, tag.find('"', value) - value);
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
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::string text = svg.substr(at, svg.find('>', at) + 1 - at);
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
  static const std::regex name_pattern("[A-Za-z][-A-Za-z0-9]*");
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    const bool is_closing = text.compare(at + 1, 1, "/") == 0;
    at += is_closing ? 2 : 1;
    const auto take_name = [&] {
      const std::size_t end = text.find_first_of(" \n=/>\"<", at);
      const std::string name = end == std::string::npos ? "" : text.substr(at, end - at);
      at += name.size();
      return name;
    };
    const std::string element = take_name();
    if (!std::regex_match(element, name_pattern)) return false;
    while (text.find_first_of(" \n", at) == at) {
      at = text.find_first_not_of(" \n", at);
      if (at == std::string::npos) return false;
      if (text[at] == '>' || text[at] == '/') break;
      if (!std::regex_match(take_name(), name_pattern) || text.compare(at, 2, "=\"") != 0)
        return false;
      const std::size_t end = text.find_first_of("\"<", at + 2);
      if (end == std::string::npos || text[end] != '"') return false;
      at = end + 1;
    }
    const bool is_empty = text.compare(at, 2, "/>") == 0;
    if (!is_empty && text.compare(at, 1, ">") != 0) return false;
    if (is_closing) {
      if (open.empty() || open.back() != element) return false;
      open.pop_back();
    } else if (!is_empty) {
      open.push_back(element);
    }
  }
  return open.empty();
}

}  // namespace spoctree::test
