#include "tests/support/read_drawing.hpp"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

using boost::property_tree::ptree;

Vec3 point_of(const ptree& list) {
  if (list.size() != 3) throw BadInput("a point has three coordinates");
  Vec3 point{0.0};
  int axis = 0;
  for (const auto& [key, value] : list) point[axis++] = value.get_value<double>();
  return point;
}

}  // namespace

std::vector<DrawnLine> read_drawing(const std::string& path) {
  try {
    ptree root;
    boost::property_tree::read_json(path, root);
    std::vector<DrawnLine> lines;
    for (const auto& [key, line] : root.get_child("lines")) {
      lines.push_back({point_of(line.get_child("a")), point_of(line.get_child("b")),
                       line.get<bool>("hidden", false)});
    }
    return lines;
  } catch (const boost::property_tree::ptree_error& error) {
    throw BadInput(path + ": " + error.what());
  }
}

}  // namespace spoctree
