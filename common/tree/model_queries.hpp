// The questions of query_index.hpp in the model's own coordinates.
#pragma once

#include "common/tree/query_index.hpp"

namespace spoctree {

/// Where a point of the model lies. It is rounded to the grid as the mesh's vertices were (2^-53 of
/// the universe cube at most), so that a point of a face parallel to the axes is exactly on it.
/// Planes of other faces are rounded outwards: a vertex of the mesh is On or, by less than 2^-51,
/// In; any other point of such a face, being rounded itself, may be Out by as little.
/// Complexity: QueryIndex::classify.
PointClass classify_in_model(const QueryIndex& index, Vec3 point);

/// The first crossing of the ray origin + t direction, t > 0, with the boundary: times in units of
/// the direction as it is given, whatever its length; infinite if beyond what doubles can hold. The
/// origin is rounded as points are; one that is far off is first moved along the ray.
/// REQUIRES: finite numbers, a direction other than 0. Complexity and error: QueryIndex::first_hit.
RayAnswer first_hit_in_model(const QueryIndex& index, Vec3 origin, Vec3 direction);

}  // namespace spoctree
