// The solid of the first picture: a bearing bracket, as in image 2 of Cano, Torres and Velasco,
// "Progressive transmission of polyhedral solids using a hierarchical representation scheme".
#pragma once

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// A bracket of 120 x 70 x 78 mm with 43 boundary planes, 13 of them on its convex hull, as the
/// paper's piece has. Genus 3: a bore of eight sides in the upright, two bolt holes of six sides in
/// the base. Symmetrical in x, front at y = 0, bottom at z = 0.
PolygonMesh make_mechanical_piece();

}  // namespace spoctree::model
