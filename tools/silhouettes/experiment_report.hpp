// What the experiment has found -> tables, and charts like the paper's figures 12, 13 and 15.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/silhouettes/experiment.hpp"

namespace spoctree {

/// Columns for people: average, lowest, highest and standard deviation in percent, per stage.
std::string to_table(const std::vector<ExperimentRow>& rows);

/// A line per object, stage and way of preprocessing.
std::string to_csv(const std::vector<ExperimentRow>& rows);

/// Figure 12: per object, the average without preprocessing (left bar) and with it (right bar),
/// each divided into what 3, 9 and 13 views reach. SVG.
std::string average_chart(const std::vector<ExperimentRow>& rows);

/// Figures 13 and 15: per entry, three bars for 3, 9 and 13 views, from the lowest to the highest
/// ratio, a band around the average as thick as the standard deviation. SVG.
struct StabilityEntry {
  std::string label;
  std::array<Accuracy, 3> stages;
};
std::string stability_chart(const std::vector<StabilityEntry>& entries);

}  // namespace spoctree
