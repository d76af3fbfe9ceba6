// The small solids, each with one property that a test or a picture needs.
#pragma once

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// 100 mm wide, centred at the origin.
PolygonMesh make_cube();

/// Its six corners 50 mm from the origin, on the axes.
PolygonMesh make_octahedron();

/// A rhombic dodecahedron: all that is seen as a square on its corner, of 100 mm from corner to
/// corner, along each of the axes.
PolygonMesh make_diamond();

/// An L of 80 x 60 mm with legs 20 mm thick, extruded 40 mm: one concave edge.
PolygonMesh make_l_bracket();

/// A plate of 100 x 60 x 20 mm with two square windows: genus 2.
PolygonMesh make_double_torus();

/// A cavity inside a cavity: boxes of 100, 60, 30 and 10 mm with the same centre, by turns full
/// and empty. Four shells.
PolygonMesh make_nested_boxes();

/// A box of 40 mm and an octahedron, which do not touch.
PolygonMesh make_two_parts();

/// A block of 80 x 80 mm whose top rises to two opposite corners and falls to the others: around
/// the middle of the top, edges are convex and concave by turns.
PolygonMesh make_saddle();

}  // namespace spoctree::model
