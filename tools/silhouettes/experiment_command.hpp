// The command `experiment`: repeats the paper's evaluation.
#pragma once

#include <string>

#include "tools/silhouettes/experiment.hpp"

namespace spoctree {

struct ExperimentArguments {
  std::string folder;  ///< for the tables and charts; empty: none are written
  bool variants = false;
  ExperimentOptions options;
};

/// Prints the table, our averages beside the paper's, and the exact cases; with `variants` also
/// what other readings of the paper would give.
void run_experiment_command(const ExperimentArguments& arguments);

}  // namespace spoctree
