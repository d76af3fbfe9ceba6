// A solid as a mesh file, for those who compare with it.
#pragma once

#include <string>

#include "server/solid/solid.hpp"

namespace spoctree {

/// The solid's triangles in the OFF format, in model units: each coordinate is the double nearest
/// to it (so that a solid far from the origin loses what doubles lose there), written as the
/// shortest decimal that reads back as that double, 17 digits at most.
std::string to_off(const Solid& solid);

}  // namespace spoctree
