// The whole chain, mesh -> solid -> tree -> stream -> tree -> rebuilt mesh, and its judgement by
// the input mesh alone.
#pragma once

#include <string>

#include "common/geometry/tolerances.hpp"
#include "common/tree/octree.hpp"
#include "server/build/sp_rules.hpp"
#include "server/mesh/polygon_soup.hpp"
#include "server/solid/solid.hpp"
#include "tests/support/mesh_judge.hpp"

namespace spoctree {

struct ChainOptions {
  double flat_tolerance = kDefaultFlatTolerance;
  SpRules rules;
  std::size_t points = 10000;
  /// Intermediate levels are rebuilt for models of at most so many nodes.
  std::size_t rebuild_levels_up_to = 3000;
  std::size_t surface_samples = 3000;
  /// Whether the vertices rebuilt must be as many as the input's corners: where no two faces are
  /// nearly parallel.
  bool count_vertices = false;
};

/// What the judgement measured, for the record.
struct ChainFigures {
  std::size_t triangles = 0, planes = 0, root_planes = 0, levels = 0, nodes = 0, references = 0,
              depth_limited = 0, bytes = 0;
  double volume_error = 0, area_error = 0, distance = 0;  ///< relative
  std::size_t vertices = 0, input_corners = 0;
};

/// Runs the chain and adds a failure for everything that contradicts the input.
ChainFigures judge_chain(const std::string& name, const PolygonSoup& soup,
                         const ChainOptions& options = {});

PlainMesh to_plain(const PolygonSoup& soup);
PolygonSoup to_soup(const PlainMesh& mesh);

}  // namespace spoctree
