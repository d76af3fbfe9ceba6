#include "tools/silhouettes/build_command.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "common/base/errors.hpp"
#include "common/base/parallel.hpp"
#include "common/program/output.hpp"
#include "common/program/remaining_time.hpp"
#include "common/report/json_text.hpp"
#include "common/report/level_rows.hpp"
#include "common/report/text_table.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/mapped_file.hpp"
#include "common/wire/spo_file.hpp"
#include "common/wire/spo_writer.hpp"
#include "server/silhouettes/state_levels.hpp"
#include "server/silhouettes/views.hpp"
#include "tools/silhouettes/find_masks.hpp"
#include "tools/silhouettes/view_cube.hpp"

namespace spoctree {

namespace {

namespace fs = std::filesystem;

/// The files of the views wanted, in the order wanted.
std::vector<MaskFile> choose_masks(const SilhouetteBuildArguments& arguments) {
  const std::vector<MaskFile> all = find_masks(arguments.masks);
  const auto find = [&](std::size_t view) {
    return std::find_if(all.begin(), all.end(),
                        [view](const MaskFile& mask) { return mask.view == view; });
  };
  std::vector<MaskFile> chosen;
  if (arguments.views.empty()) {
    chosen = all;
  } else {
    for (const std::size_t view : parse_views(arguments.views)) {
      const auto mask = find(view);
      if (mask == all.end()) {
        throw BadInput(arguments.masks.front() + ": no mask of view " +
                       std::string(all_views()[view].name));
      }
      chosen.push_back(*mask);
    }
  }
  if (arguments.order.empty()) return chosen;
  std::vector<MaskFile> ordered;
  for (const std::size_t view : parse_views(arguments.order)) {
    for (const MaskFile& mask : chosen) {
      if (mask.view == view) ordered.push_back(mask);
    }
  }
  if (ordered.size() < chosen.size()) throw UsageError("--order leaves out views that are there");
  return ordered;
}

/// After the views of each kind, in their order; the last stage is after all of them.
std::vector<std::size_t> find_stages(const std::vector<MaskFile>& masks) {
  std::vector<std::size_t> stages;
  for (std::size_t i = 1; i <= masks.size(); ++i) {
    if (i == masks.size() || all_views()[masks[i - 1].view].kind != all_views()[masks[i].view].kind)
      stages.push_back(i);
  }
  return stages;
}

SourceInfo describe_source(const std::vector<MaskFile>& masks, std::size_t used,
                           const SilhouetteOptions& options) {
  SourceInfo source;
  Hasher hasher;
  std::string views;
  for (std::size_t i = 0; i < used; ++i) {
    hasher.add(MappedFile(masks[i].path).bytes());
    if (!views.empty()) views += ',';
    views += all_views()[masks[i].view].name;
  }
  const fs::path first = fs::absolute(masks.front().path).parent_path();
  source.name = first.filename().string();
  source.hash = hasher.hash();
  source.build_options = "kind=silhouettes max-depth=" + std::to_string(options.rules.max_depth) +
                         " black-fraction=" + to_text(options.rules.black_fraction) +
                         " corner-fraction=" + to_text(options.rules.corner_fraction) +
                         (options.grow ? " grow" : "") + " views=" + views;
  return source;
}

/// "cup.spo" -> "cup-3.spo".
std::string stage_name(const std::string& output, std::size_t views) {
  const fs::path path(output);
  return (path.parent_path() /
          (path.stem().string() + "-" + std::to_string(views) + path.extension().string()))
      .string();
}

/// Combinations that cannot be meant, found before any work.
void check(const SilhouetteBuildArguments& arguments) {
  for (const double fraction : {arguments.black_fraction, arguments.corner_fraction}) {
    if (!(fraction >= 0 && fraction <= 1)) throw UsageError("a fraction is between 0 and 1");
  }
  if (arguments.stages && arguments.output == "-")
    throw UsageError("--stages makes several files, which standard output cannot hold");
}

std::vector<Octree> build_trees(const Universe& cube, const std::vector<Silhouette>& silhouettes,
                                const SilhouetteOptions& options, const std::string& masks) {
  try {
    return build_from_silhouettes(cube, silhouettes, options);
  } catch (const BadInput& error) {
    throw BadInput(masks + ": " + error.what());
  }
}

void warn(const std::string& text) {
  std::fprintf(stderr, "spoctree-silhouettes: %s\n", text.c_str());
}

/// Which of the first `used` masks leave nothing.
std::string why_empty(const std::vector<MaskFile>& masks,
                      const std::vector<Silhouette>& silhouettes, SilhouetteOptions options,
                      std::size_t used) {
  for (std::size_t i = 0; i < used; ++i) {
    if (!silhouettes[i].mask.has_object()) return masks[i].path.string() + " shows no object";
  }
  options.stages.clear();
  for (std::size_t i = 1; i <= used; ++i) options.stages.push_back(i);
  const std::vector<double> volumes =
      volumes_from_silhouettes(std::span(silhouettes).first(used), options);
  std::size_t empty = 0;
  while (empty + 1 < used && volumes[empty] > 0) ++empty;
  const std::string last = masks[empty].path.string();
  if (empty == 0) return last + " alone leaves no cell that is full";
  return last + " shows nothing of what the masks before it leave";
}

/// A mask must not be lost by writing over it.
void require_other_files(const std::vector<MaskFile>& masks, const std::string& output) {
  std::error_code ignored;
  for (const MaskFile& mask : masks) {
    if (output != "-" && fs::equivalent(mask.path, output, ignored))
      throw UsageError(output + ": --output is a mask itself");
  }
}

}  // namespace

void run_silhouette_build(const SilhouetteBuildArguments& arguments) {
  const Elapsed elapsed;
  check(arguments);
  const std::vector<MaskFile> masks = choose_masks(arguments);
  const std::optional<Universe> found = find_cube(arguments.masks);
  const Universe cube = !arguments.cube.empty() ? parse_cube(arguments.cube, "--cube")
                        : found                 ? *found
                                                : cube_around({0, 0, 0}, 2);
  const FoundSilhouettes found_masks = read_silhouettes(masks);
  const std::vector<Silhouette>& silhouettes = found_masks.silhouettes;
  for (const std::string& remark : found_masks.remarks) warn(remark);
  const double read_s = elapsed.seconds();

  SilhouetteOptions options;
  options.grow = arguments.grow;
  options.rules.black_fraction = arguments.black_fraction;
  options.rules.corner_fraction = arguments.corner_fraction;
  options.rules.max_depth =
      arguments.max_depth >= 0 ? arguments.max_depth : depth_of_pixels(silhouettes);
  options.stages = arguments.stages ? find_stages(masks) : std::vector<std::size_t>{masks.size()};
  std::vector<Octree> trees = build_trees(cube, silhouettes, options, arguments.masks.front());
  const double build_s = elapsed.seconds() - read_s;

  std::vector<TableRow> rows{{"views", "nodes", "black", "volume", "share of the cube", "file"}};
  std::vector<std::string> files(trees.size());
  std::vector<std::string> names(trees.size());
  parallel_for(trees.size(), [&](std::size_t i) {
    state_levels_of_cubes(trees[i]);
    if (const auto broken = validate(trees[i], 1); !broken.empty())
      throw std::logic_error("the program has built an invalid tree (" + broken.front() +
                             "): please report this");
    files[i] = encode_spo(trees[i], describe_source(masks, options.stages[i], options));
    names[i] =
        i + 1 < trees.size() ? stage_name(arguments.output, options.stages[i]) : arguments.output;
    require_other_files(masks, names[i]);
  });
  for (std::size_t i = 0; i < trees.size(); ++i) {
    write_output(names[i], files[i]);
    std::size_t nodes = 0;
    std::size_t black = 0;
    for (const Level& level : trees[i].levels) {
      nodes += level.size();
      black += level.count_kinds()[static_cast<std::size_t>(NodeKind::Black)];
    }
    const double volume = trees[i].levels.back().statement.outer_volume;
    if (volume == 0) {
      warn(names[i] + " is empty: no point of the cube projects into all of its " +
           std::to_string(options.stages[i]) + " masks; " +
           why_empty(masks, silhouettes, options, options.stages[i]));
    }
    const double side = cube.side();
    rows.push_back({std::to_string(options.stages[i]), std::to_string(nodes), std::to_string(black),
                    to_short_text(volume),
                    to_short_text(100 * volume / (side * side * side)) + " %", names[i]});
  }
  const SpoFile last(files.back(), names.back());
  std::string summary =
      align_columns(rows) + to_table(level_rows(trees.back(), last.level_bytes()));
  char line[160];
  std::snprintf(line, sizeof line, "%.3f s (read %.3f, build %.3f, state and write %.3f)\n",
                elapsed.seconds(), read_s, build_s, elapsed.seconds() - read_s - build_s);
  summary += line;
  if (arguments.output == "-") {
    std::fputs(summary.c_str(), stderr);
  } else {
    print(summary);
  }
}

}  // namespace spoctree
