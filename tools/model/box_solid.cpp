#include "tools/model/box_solid.hpp"

#include <algorithm>
#include <cstddef>

#include "tools/model/face_list.hpp"

namespace spoctree::model {

PolygonMesh BoxSolid::mesh() const {
  std::vector<double> at[3];  // the planes' coordinates, ascending
  for (int axis = 0; axis < 3; ++axis) {
    for (const Box& box : boxes_) {
      at[axis].push_back(box.low[axis]);
      at[axis].push_back(box.high[axis]);
    }
    std::sort(at[axis].begin(), at[axis].end());
    at[axis].erase(std::unique(at[axis].begin(), at[axis].end()), at[axis].end());
  }
  // Cell (i, j, k) lies between the planes i and i + 1, and so on; nothing is around the grid.
  using Cell = std::size_t[3];
  const auto is_full = [&](const Cell& cell) {
    glm::dvec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
      if (cell[axis] + 1 >= at[axis].size()) return false;
      middle[axis] = 0.5 * (at[axis][cell[axis]] + at[axis][cell[axis] + 1]);
    }
    bool full = false;
    for (const Box& box : boxes_) {
      const auto is_within = [&](int axis) {
        return box.low[axis] < middle[axis] && middle[axis] < box.high[axis];
      };
      if (is_within(0) && is_within(1) && is_within(2)) full = box.is_full;
    }
    return full;
  };

  FaceList faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Cell above{};
    for (above[axis] = 0; above[axis] < at[axis].size(); ++above[axis]) {
      for (above[u] = 0; above[u] + 1 < at[u].size(); ++above[u]) {
        for (above[v] = 0; above[v] + 1 < at[v].size(); ++above[v]) {
          Cell below = {above[0], above[1], above[2]};
          --below[axis];  // wraps round below the lowest plane: out of the grid
          const bool full_below = above[axis] > 0 && is_full(below);
          if (full_below == is_full(above)) continue;
          const auto corner = [&](std::size_t du, std::size_t dv) {
            glm::dvec3 point;
            point[axis] = at[axis][above[axis]];
            point[u] = at[u][above[u] + du];
            point[v] = at[v][above[v] + dv];
            return point;
          };
          // With u, v the next axes in cyclic order, this is counter-clockwise seen from above.
          if (full_below)
            faces.add({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          else
            faces.add({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
        }
      }
    }
  }
  return faces.mesh();
}

}  // namespace spoctree::model
