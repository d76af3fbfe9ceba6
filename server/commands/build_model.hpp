// A mesh file -> a solid -> a tree with certified levels -> a .spo file's bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/tolerances.hpp"
#include "common/tree/octree.hpp"
#include "server/build/classifier.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// Above this, merging faces would no longer be about rounding.
inline constexpr double kLargestFlatTolerance = 0.05;

/// What the user can set.
struct ModelOptions {
  TreeRules rules;                       ///< depths of 0 to kMaxDepth
  std::optional<double> flat_tolerance;  ///< see ImportOptions; to kLargestFlatTolerance
  bool repair = false;                   ///< see server/solid/repair.hpp
};

/// What came of a mesh file.
struct Model {
  Octree tree;
  std::string spo;                   ///< the .spo file's bytes
  std::vector<std::string> changes;  ///< what was done to the file's faces, a line each
  SolidReport report;
  std::size_t plane_count = 0;  ///< of the solid, after merging
  double volume = 0;            ///< model units cubed
  std::size_t depth_limited_nodes = 0;
  double import_seconds = 0;
  double build_seconds = 0;
  double certify_seconds = 0;
};

/// Called with what is being done, and about how much of the whole time has passed; by any thread,
/// one at a time.
using BuildProgress = std::function<void(const char* step, double fraction)>;

/// Called with the solid that the model will be of, in its merged form, before it is built.
using SolidObserver = std::function<void(const Solid& solid)>;

/// Reads, judges, builds and encodes. The same model for the same file and options, seconds apart.
/// Throws BadInput as read_mesh and import_solid do.
Model build_model(const std::filesystem::path& mesh, const ModelOptions& options,
                  const BuildProgress& progress, const SolidObserver& observe = {});

}  // namespace spoctree
