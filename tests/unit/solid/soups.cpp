#include "tests/unit/solid/soups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <set>

#include "common/base/errors.hpp"

namespace spoctree::solid_test {

namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

RationalVector to_rational(Vec3 v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

Rational dot(const RationalVector& p, const RationalVector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Rational determinant(const RationalVector& p, const RationalVector& q, const RationalVector& r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

void expect_neighbours_agree(const Solid& solid) {
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = solid.triangles[t].vertex[i];
      const std::uint32_t to = solid.triangles[t].vertex[(i + 1) % 3];
      ASSERT_LT(solid.triangles[t].neighbour[i], solid.triangles.size());
      const SolidTriangle& other = solid.triangles[solid.triangles[t].neighbour[i]];
      int matches = 0;
      for (int j = 0; j < 3; ++j) {
        if (other.vertex[j] == to && other.vertex[(j + 1) % 3] == from) {
          ++matches;
          EXPECT_EQ(other.neighbour[j], t);
        }
      }
      EXPECT_EQ(matches, 1) << "edge " << i << " of triangle " << t;
    }
  }
}

void expect_facets_are_their_triangles(const Solid& solid) {
  std::vector<std::set<std::uint32_t>> vertices(solid.facet_count());
  std::vector<std::uint32_t> first(solid.facet_count(), ~0u);
  for (std::uint32_t t = 0; t < solid.triangles.size(); ++t) {
    const SolidTriangle& triangle = solid.triangles[t];
    ASSERT_LT(triangle.facet, solid.facet_count());
    first[triangle.facet] = std::min(first[triangle.facet], t);
    vertices[triangle.facet].insert(std::begin(triangle.vertex), std::end(triangle.vertex));
  }
  EXPECT_TRUE(std::is_sorted(first.begin(), first.end())) << "facets are not in order";
  ASSERT_EQ(solid.facet_vertex_begin.size(), solid.facet_count() + 1);
  for (std::uint32_t f = 0; f < solid.facet_count(); ++f) {
    const auto listed = solid.vertices_of_facet(f);
    EXPECT_TRUE(std::equal(listed.begin(), listed.end(), vertices[f].begin(), vertices[f].end()));
  }
}

void expect_planes_contain_their_facets(const Solid& solid) {
  const Rational most(solid.largest_incidence_gap);
  std::set<std::uint32_t> used;
  for (std::uint32_t f = 0; f < solid.facet_count(); ++f) {
    ASSERT_LT(solid.facet_plane[f], solid.planes.size());
    used.insert(solid.facet_plane[f]);
    const Plane& plane = solid.planes[solid.facet_plane[f]];
    EXPECT_TRUE(is_valid(plane));
    for (const std::uint32_t v : solid.vertices_of_facet(f)) {
      const Rational inside =
          Rational(plane.offset) - dot(to_rational(plane.normal), to_rational(solid.vertices[v]));
      EXPECT_GE(inside, 0) << "vertex " << v << " sticks out of facet " << f;
      EXPECT_LE(inside, most) << "vertex " << v << " of facet " << f;
    }
  }
  EXPECT_EQ(used.size(), solid.planes.size()) << "a plane is not used";
}

void expect_volume(const Solid& solid) {
  Rational six_volumes = 0;
  for (const SolidTriangle& t : solid.triangles) {
    six_volumes += determinant(to_rational(solid.vertices[t.vertex[0]]),
                               to_rational(solid.vertices[t.vertex[1]]),
                               to_rational(solid.vertices[t.vertex[2]]));
  }
  const double scale = solid.universe.scale();
  const double volume = (six_volumes / 6).convert_to<double>() * scale * scale * scale;
  EXPECT_GT(volume, 0) << "the faces point inwards";
  EXPECT_NEAR(solid.volume / volume, 1, 1e-14);
}

}  // namespace

PolygonSoup make_soup(const std::vector<glm::dvec3>& points, const std::vector<Face>& faces) {
  PolygonSoup soup;
  soup.points = points;
  for (const Face& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

PolygonSoup box(glm::dvec3 lower, glm::dvec3 upper) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y,
                        i & 4 ? upper.z : lower.z);
  }
  return make_soup(
      points, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}});
}

PolygonSoup prism(const std::vector<glm::dvec2>& polygon, double height) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  std::vector<glm::dvec3> points;
  for (const glm::dvec2 p : polygon) points.emplace_back(p.x, p.y, 0);
  for (const glm::dvec2 p : polygon) points.emplace_back(p.x, p.y, height);
  std::vector<Face> faces(2);
  for (std::uint32_t i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return make_soup(points, faces);
}

PolygonSoup reversed(const PolygonSoup& soup) {
  PolygonSoup turned = soup;
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    std::reverse(turned.corners.begin() + soup.first_corner[i],
                 turned.corners.begin() + soup.first_corner[i + 1]);
  }
  return turned;
}

PolygonSoup together(const PolygonSoup& a, const PolygonSoup& b) {
  PolygonSoup both = a;
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  for (std::size_t i = 0; i < b.face_count(); ++i) {
    for (const std::uint32_t corner : b.face(i)) {
      both.corners.push_back(corner + static_cast<std::uint32_t>(a.points.size()));
    }
    both.first_corner.push_back(static_cast<std::uint32_t>(both.corners.size()));
  }
  return both;
}

PolygonSoup without_face(const PolygonSoup& soup, std::size_t i) {
  std::vector<Face> faces;
  for (std::size_t j = 0; j < soup.face_count(); ++j) {
    if (j != i) faces.emplace_back(soup.face(j).begin(), soup.face(j).end());
  }
  return make_soup(soup.points, faces);
}

std::string import_error(const PolygonSoup& soup, double flat_tolerance) {
  try {
    import_solid(soup, "it", {flat_tolerance});
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

Solid import_it(const PolygonSoup& soup, double flat_tolerance) {
  return import_solid(soup, "it", {flat_tolerance});
}

void expect_sound(const Solid& solid) {
  EXPECT_TRUE(is_valid(solid.universe));
  for (const Vec3 v : solid.vertices) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(v[i]), solid.universe.half_side);
      EXPECT_EQ(std::ldexp(v[i], kGridBits), std::nearbyint(std::ldexp(v[i], kGridBits)));
    }
  }
  expect_neighbours_agree(solid);
  expect_facets_are_their_triangles(solid);
  expect_planes_contain_their_facets(solid);
  expect_volume(solid);
}

}  // namespace spoctree::solid_test
