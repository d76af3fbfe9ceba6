#include "server/build/certify.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "common/base/parallel.hpp"
#include "common/tree/pieces.hpp"
#include "server/build/certify_cubes.hpp"
#include "server/build/error_bound.hpp"
#include "server/build/level_survey.hpp"

namespace spoctree {

namespace {

/// Enough parts of a tree to keep any number of threads busy; always as many, so that the result
/// does not depend on the threads.
constexpr std::uint32_t kPartsWanted = 128;

constexpr std::size_t kFirstParts = 4;

/// The share of the survey in all the work, about.
constexpr double kSurveyShare = 0.8;

WalkOptions grey_nodes() {
  WalkOptions options;
  options.inner_nodes_only = true;
  return options;
}

/// The level whose nodes are the parts of a survey.
std::uint32_t choose_part_level(const Octree& tree) {
  std::uint32_t level = 0;
  while (level + 1 < tree.levels.size() && tree.levels[level].grey_count < kPartsWanted) ++level;
  return level;
}

std::vector<Subtree> parts_at(const Octree& tree, std::uint32_t level) {
  std::vector<Subtree> parts(1);
  for (std::uint32_t k = 0; k < level; ++k) {
    std::vector<Subtree> next;
    for (const Subtree& part : parts) {
      std::vector<Subtree> children = children_of(tree, grey_nodes(), part);
      std::move(children.begin(), children.end(), std::back_inserter(next));
    }
    parts = std::move(next);
  }
  return parts;
}

/// Adds what is in the parts, in their order.
void survey_parts(const BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
                  std::span<const Subtree> parts, std::vector<GreyRegions>& levels) {
  std::vector<std::vector<GreyRegions>> surveyed(parts.size());
  parallel_for(parts.size(), [&](std::size_t i) {
    LevelSurvey part(built, solid, queries, LevelSurvey::kAllLevels);
    part.set_attained(levels);
    walk_pieces(built.tree, grey_nodes(), parts[i], part);
    surveyed[i] = std::move(part.levels());
  });
  for (auto& part : surveyed) {
    for (std::size_t k = 0; k < levels.size(); ++k) levels[k].add(std::move(part[k]));
  }
}

/// The regions of all levels: what is above the parts first, then part by part in their order.
std::vector<GreyRegions> survey(const BuiltOctree& built, const Solid& solid,
                                const SolidQueries& queries, ProgressMeter& progress) {
  const std::uint32_t part_level = choose_part_level(built.tree);
  LevelSurvey top(built, solid, queries, part_level);
  walk_pieces(built.tree, grey_nodes(), top);
  std::vector<GreyRegions> levels = std::move(top.levels());
  const std::vector<Subtree> parts = parts_at(built.tree, part_level);
  // What the first few have attained spares the others most of their distances; as many at a time
  // for any number of threads.
  for (std::size_t begin = 0; begin < parts.size();) {
    const std::size_t count = std::min(parts.size() - begin, std::max(kFirstParts, begin));
    survey_parts(built, solid, queries, std::span(parts).subspan(begin, count), levels);
    begin += count;
    progress.add(kSurveyShare * static_cast<double>(count) / static_cast<double>(parts.size()));
  }
  return levels;
}

}  // namespace

void certify(BuiltOctree& built, const Solid& solid, const SolidQueries& queries,
             const ProgressReport& report) {
  if (built.is_classical) return certify_cubes(built, solid, queries, report);
  ProgressMeter progress(report);
  progress.add(0);
  const std::vector<GreyRegions> regions = survey(built, solid, queries, progress);
  const std::vector<double> bounds = error_bounds(regions, built, solid, queries);
  progress.add(1 - kSurveyShare);

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
