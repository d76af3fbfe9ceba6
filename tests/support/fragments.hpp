// Solids whose faces are cut into pieces that do not meet their neighbours' corners, as programs
// for constructive geometry write them, and soups whose corners differ by rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

using Fragment = std::vector<glm::dvec3>;

/// The faces of a solid with convex faces.
struct FragmentSolid {
  std::vector<Fragment> faces;
  double volume = 0;  ///< known without the faces
};

/// Unit cubes of an n x n x n lattice that are joined by faces only (no edge or corner of the union
/// is touched from two sides); their outer faces.
FragmentSolid random_cubes(int n, Random& random);

/// A straight prism over a regular polygon, turned and moved at random.
FragmentSolid random_prism(int corners, Random& random);

/// Every face cut by `cuts` planes through it, each of which cuts the pieces that it meets with one
/// chance in two. Along the axes, or in any direction.
std::vector<Fragment> cut_at_random(const std::vector<Fragment>& faces, int cuts, bool along_axes,
                                    Random& random);

/// Each coordinate as it is read back after it was written with so many digits (%.*g).
void round_to_digits(std::vector<Fragment>& fragments, int digits);

/// Each coordinate of each corner of each face moved by -amount, 0 or amount.
void add_noise(std::vector<Fragment>& fragments, double amount, Random& random);

/// What read_mesh makes of such a file: polygons, or (is_stl) triangles around their first corners.
PolygonSoup soup_of(const std::vector<Fragment>& fragments, bool is_stl, Precision precision = {});

}  // namespace spoctree
