// Which cells a surface passes through, by rational numbers: the judge of classical octrees.
#pragma once

#include <memory>
#include <vector>

#include "server/solid/solid.hpp"
#include "tests/support/mesh_judge.hpp"

namespace spoctree {

/// What the cells of a regular grid are, by the definition alone: every cell is compared with every
/// triangle. For small grids and meshes.
class CellOracle {
 public:
  enum class Cell { Void, Full, Mixed };

  explicit CellOracle(const Solid& solid);

  /// Mixed: a triangle meets the cell's interior (decided exactly, by separating axes). A triangle
  /// that meets its walls alone does not count. Others are what their centre is.
  Cell cell(Vec3 lower, double side) const;
  /// All 8^depth cells, by z, y, x.
  std::vector<Cell> cells(int depth) const;
  const MeshJudge& judge() const { return judge_; }

 private:
  double half_side_;
  PlainMesh mesh_;
  MeshJudge judge_;
};

}  // namespace spoctree
