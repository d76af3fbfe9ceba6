// A soup whose faces bring their own copies of their points into one where faces that meet share.
#pragma once

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// Makes exactly equal points one (no tolerance; -0.0 equals 0.0) and removes points that no face
/// uses. The remaining points keep their order, and faces theirs. Corners that have become equal to
/// the one before them are left out, and so are the faces that have collapsed by that
/// (soup.collapsed). A face may still have a point twice, where it touches itself. Linear.
/// REQUIRES: corners are numbers of points, coordinates are not NaN.
void merge_equal_points(PolygonSoup& soup);

}  // namespace spoctree
