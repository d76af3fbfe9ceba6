// Closed meshes whose drawings are known by reasoning.
#pragma once

#include <functional>
#include <vector>

#include "tests/support/drawing_judge.hpp"

namespace spoctree {

/// Adds a box's six squares.
void add_box(PlainMesh& mesh, Vec3 lower, Vec3 upper);
PlainMesh box(Vec3 lower, Vec3 upper);

/// Turns the faces of a mesh: a cavity instead of a solid.
PlainMesh turned(PlainMesh mesh);
PlainMesh together(PlainMesh one, const PlainMesh& other);

/// The prism between z = low and z = high over a simple polygon (counter-clockwise), every point
/// then put through `place`, which must not mirror.
PlainMesh prism(
    const std::vector<glm::dvec2>& outline, double low, double high,
    const std::function<Vec3(Vec3)>& place = [](Vec3 p) { return p; });

/// The squares between the cells of a grid of n cells a side that are material and those that are
/// not. Cells must not meet in an edge or a corner only.
PlainMesh cells(int n, const std::function<bool(int, int, int)>& is_material);
/// Is a cell of a cube of 3^order cells a side in the Menger sponge?
bool is_in_sponge(int x, int y, int z, int order);

/// Visible lines.
std::vector<DrawnLine> lines(const std::vector<std::pair<Vec3, Vec3>>& ends);

}  // namespace spoctree
