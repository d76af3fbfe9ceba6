// Mesh -> tree -> answers at every level, judged by the mesh alone.
#pragma once

#include <string>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

struct QueryJudgementOptions {
  std::size_t points = 2000;
  std::size_t rays = 500;
  /// Measures of the levels of trees of at most so many nodes are judged.
  std::size_t measure_up_to = 20000;
};

/// Asks points (half of them 1e-6 to 1e-2 of the diagonal off the surface), rays (from outside,
/// from inside, aimed at vertices and edges) and measures at every level, and adds a failure for
/// everything that contradicts the mesh. Only what is flat to 1e-12 is merged, and the merged mesh
/// is the judge.
void judge_queries(const std::string& name, const PolygonSoup& soup,
                   const QueryJudgementOptions& options = {});

}  // namespace spoctree
