// A file's precision and its points -> whether, and how coarsely, its coordinates were rounded.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "server/mesh/precision.hpp"

namespace spoctree {

/// For each axis, the unit that coordinates along it were rounded to, in the file's units; 0 where
/// they say what they mean: a box of 100 by 50 that is written with one decimal was not rounded.
///
/// It is the spacing of the file's numbers at the largest coordinate (coordinate_spacing), unless
/// the coordinates, each different one counted once and without its sign, are rounder than rounded
/// numbers are by chance (with a chance far below 10^-3): they end with more zeros, are multiples
/// of five too often, or are all multiples of something larger. A model less than 300 units large,
/// and along an axis one of less than 5 units or of three different coordinates at most, is taken
/// for what it says. n log n.
glm::dvec3 find_rounding(const Precision& precision, std::span<const glm::dvec3> points);

}  // namespace spoctree
