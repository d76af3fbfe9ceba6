// Solids to be looked at from inside, after the figures of C. B. Jones, A new approach to the
// 'hidden line' problem, Computer Journal 14 (3), 1971.
#pragma once

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// The house of figure 2, with walls of 20 cm, floor and ceiling: a living room, a kitchen and a
/// dining room of 2.5 m height, doors from the living room to both others, and a service hatch
/// between these. Nothing leads outside: a box with a cavity of genus 1. In millimetres; the living
/// room is at x < 6000, the kitchen at y > 4000 of the rest; floors are at z = 200.
PolygonMesh make_house_plan();

/// Like the objects of figures 8 to 13: eight buildings on a square of 60 m around a court, one
/// with an archway through it, and a pillar in the middle of the court. In millimetres; the ground
/// is at z = 0, the court at 20000 < x, y < 40000.
PolygonMesh make_city_block();

}  // namespace spoctree::model
