#include "tests/support/model_solid.hpp"

#include <stdexcept>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/import_solid.hpp"
#include "tools/model/models.hpp"

namespace spoctree {

Solid model_solid(const std::string& name, std::optional<int> size) {
  const model::PolygonMesh made = model::make_model(name, size);
  PolygonSoup soup;
  soup.points = made.points;
  for (const model::Loop& face : made.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    if (const std::string wrong = close_face(soup); !wrong.empty()) throw std::logic_error(wrong);
  }
  return import_solid(soup, name, {});
}

}  // namespace spoctree
