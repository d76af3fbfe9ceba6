// Patches and triangles that were in one plane before coordinates were rounded -> one patch.
#pragma once

#include <vector>

#include "server/solid/flat_surface.hpp"
#include "server/solid/flat_tolerance.hpp"
#include "server/solid/planar_patch.hpp"

namespace spoctree {

/// Joins neighbouring patches, and triangles that are in none, where rounding explains why they are
/// not in one plane: the best fitting pair first, as in hierarchical clustering of faces. A patch
/// is explained by rounding if
/// - its corners' distances from their plane of least squares are within half a unit along the axes
///   and, all together, no larger than those of numbers rounded at random (chi-squared test, of the
///   whole patch and of what each pair adds): a bend that rounding could hide but hardly would,
///   stays;
/// - it is no plane parallel to an axis, up to one unit: rounding leaves those as they are, and a
///   step of one unit in them was meant.
///
/// `patches` are flat within tolerance.spread; those that were joined are replaced, unless that
/// saves next to none: then false. O(n log n) for n triangles as a rule. REQUIRES:
/// tolerance.has_rounding().
bool join_rounded(std::vector<PlanarPatch>& patches, const FlatSurface& surface,
                  const FlatTolerance& tolerance);

}  // namespace spoctree
