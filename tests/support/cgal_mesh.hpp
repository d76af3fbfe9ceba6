// Mesh files and polygons as CGAL understands them: for judges that share no code with the product.
#pragma once

#include <array>
#include <string>

#include "tests/support/plain_mesh.hpp"

namespace spoctree {

/// Any file that CGAL reads as a polygon soup; points with equal coordinates become one.
/// Throws BadInput.
PlainMesh read_with_cgal(const std::string& path);

/// The triangles of a simple, nearly flat polygon of `points`, turned as it is.
/// Throws std::runtime_error where CGAL finds none.
std::vector<std::array<std::uint32_t, 3>> triangulate_with_cgal(
    const std::vector<Vec3>& points, const std::vector<std::uint32_t>& polygon);

}  // namespace spoctree
