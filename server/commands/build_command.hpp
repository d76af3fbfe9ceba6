// spoctree-server build: a mesh file -> a .spo file and a summary.
#pragma once

#include <string>

#include "server/commands/build_model.hpp"

namespace spoctree {

struct BuildArguments {
  std::string mesh;
  std::string output;      ///< "-": standard output (the summary then goes to standard error)
  std::string save_solid;  ///< where to write the solid's triangles; empty: nowhere
  ModelOptions options;
};

/// Throws UsageError if two of the files are one, BadInput as build_model does and when the output
/// cannot be written; then neither output is there.
void run_build(const BuildArguments& arguments);

}  // namespace spoctree
