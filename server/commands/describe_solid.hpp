// What import found in a mesh file and did to it, in words.
#pragma once

#include <string>

#include "server/solid/solid.hpp"

namespace spoctree {

/// In a line, with the reason.
std::string describe_flat_tolerance(const FlatToleranceTaken& taken);

/// The same for a list of options, "name=value name=value".
std::string flat_tolerance_options(const FlatToleranceTaken& taken);

/// A few lines. `plane_count` is the number of planes after merging, `volume` in model units cubed.
std::string describe_solid(const std::string& name, const SolidReport& report,
                           std::size_t plane_count, double volume);

}  // namespace spoctree
