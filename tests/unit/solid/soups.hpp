// Small polygon soups made by hand, and what every solid must satisfy, whatever it was made from.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "server/solid/import_solid.hpp"

namespace spoctree::solid_test {

using Face = std::vector<std::uint32_t>;

PolygonSoup make_soup(const std::vector<glm::dvec3>& points, const std::vector<Face>& faces);

/// Six quadrilaterals that face outwards: bottom, top, front (-y), right (+x), back, left.
/// Corner x + 2 y + 4 z has one bit per axis.
PolygonSoup box(glm::dvec3 lower, glm::dvec3 upper);

/// A prism over a polygon in the plane z = 0, counter-clockwise from above. Its faces are the
/// bottom, the top, and a quadrilateral for each side.
PolygonSoup prism(const std::vector<glm::dvec2>& polygon, double height);

PolygonSoup reversed(const PolygonSoup& soup);

/// Both, with no point shared.
PolygonSoup together(const PolygonSoup& a, const PolygonSoup& b);

/// The soup without its face `i`.
PolygonSoup without_face(const PolygonSoup& soup, std::size_t i);

/// The text of the BadInput that importing the soup as "it" throws; empty if it throws none.
std::string import_error(const PolygonSoup& soup, double flat_tolerance = 1e-12);

Solid import_it(const PolygonSoup& soup, double flat_tolerance = 1e-12);

/// Adds a failure for everything about the solid that contradicts solid.hpp, checked with rational
/// numbers: neighbours, facets, planes, the incidence gap, the volume, outward faces.
void expect_sound(const Solid& solid);

}  // namespace spoctree::solid_test
