// The objects on which octrees from silhouettes were first tried (Ahuja and Veenstra, PAMI 1989,
// figures 11 and 14). The paper's unit is 50 mm; its cube, cylinder, cone and sphere are in
// blocks.hpp and round_solids.hpp.
#pragma once

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// 100 x 25 x 100 mm around the origin.
PolygonMesh make_slice();

/// Over a square of 100 mm, 100 mm high, around the origin.
PolygonMesh make_pyramid();

/// A pyramid's frustum: from a square of 50 mm at z = 0 to one of 10 mm at z = 40 mm. That is the
/// paper's definition, although the volume it states (0.6293) is another one.
PolygonMesh make_wedge();

/// Over a regular octagon 100 mm wide, 100 mm high, around the origin.
PolygonMesh make_octagonal_prism();

/// 50 mm wide, over a parallelogram with sides of 50 mm that leans by 50 mm on a height of 100 mm.
PolygonMesh make_rectangular_prism();

/// A quarter of a ring, radii 25 and 50 mm, 25 mm high, around z = 0; each arc in `sides` parts.
/// REQUIRES: sides >= 1.
PolygonMesh make_arc(int sides);

/// 12.5 mm wide, around the origin: 1/512 of the cube.
PolygonMesh make_small_cube();

/// A plate of 100 mm with four upright posts, and between them a cylinder with so many sides, of
/// which no view from the side shows all. After figure 14, whose measures are not known.
/// REQUIRES: sides >= 3.
PolygonMesh make_self_occluding(int sides);

}  // namespace spoctree::model
