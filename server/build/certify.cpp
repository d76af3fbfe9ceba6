#include "server/build/certify.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "common/tree/pieces.hpp"
#include "server/build/error_bound.hpp"
#include "server/build/level_survey.hpp"

namespace spoctree {

namespace {

/// The share of the survey in all the work, about.
constexpr double kSurveyShare = 0.8;

WalkOptions grey_nodes() {
  WalkOptions options;
  options.inner_nodes_only = true;
  return options;
}

}  // namespace

void certify(BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
             const ProgressReport& report) {
  ProgressMeter progress(report);
  progress.add(0);
  LevelSurvey survey(built, solid, queries, LevelSurvey::kAllLevels);
  walk_pieces(built.tree, grey_nodes(), survey);
  progress.add(kSurveyShare);
  const std::vector<GreyRegions>& regions = survey.levels();
  std::vector<double> bounds(regions.size(), 0.0);
  oneapi::tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t k) {
    if (built.tree.levels[k].grey_count > 0) bounds[k] = error_bound(regions[k], built, solid, queries);
    progress.add((1 - kSurveyShare) / static_cast<double>(regions.size()));
  });

  const double unit = built.tree.universe.scale();
  const double unit_volume = unit * unit * unit;
  double inner = 0;
  double inner_area = 0;
  const double whole_area = std::accumulate(built.leaf_areas.begin(), built.leaf_areas.end(), 0.0);
  double bound = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < built.tree.levels.size(); ++k) {
    LevelStatement& statement = built.tree.levels[k].statement;
    inner += built.leaf_volumes[k];
    statement.inner_volume = inner * unit_volume;
    statement.outer_volume = (inner + regions[k].volume.value()) * unit_volume;
    inner_area += built.leaf_areas[k];
    statement.inner_area = inner_area * (unit * unit);
    statement.outer_area = whole_area * (unit * unit);
    // T_k lies in T_k-1: what bounds the one bounds the other, whichever was found more tightly.
    bound = std::min(bound, bounds[k] * unit);
    statement.error_bound = bound;
  }
}

}  // namespace spoctree
