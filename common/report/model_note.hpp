// How a stream was built -> what its levels promise, where that is not what SP-Octrees do.
#pragma once

#include <string>

#include "common/wire/stream_info.hpp"

namespace spoctree {

/// A line, or nothing for an SP-Octree: there, every level contains the solid and the last one is
/// the solid. A classical octree (its build options begin with "kind=classical") is only near it,
/// and unless its partial cells are full, no level need contain it.
std::string note_on_levels(const SourceInfo& source);

}  // namespace spoctree
