#include "server/commands/tree_options.hpp"

#include <map>
#include <memory>
#include <optional>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

const std::map<std::string, PartialCells> kPartialNames = {
    {"full", PartialCells::Full}, {"void", PartialCells::Void}, {"half", PartialCells::Half}};

/// As they are given.
struct TreeOptions {
  std::string kind = "sp";
  std::optional<std::uint32_t> max_depth;
  std::optional<std::uint32_t> leaf_planes;
  std::optional<std::string> partial;
};

TreeRules to_rules(const TreeOptions& options) {
  if (options.kind == "sp") {
    if (options.partial) throw UsageError("--partial is for --kind classical");
    return SpRules{options.leaf_planes,
                   options.max_depth.value_or(static_cast<std::uint32_t>(kMaxDepth))};
  }
  if (options.leaf_planes) throw UsageError("--leaf-planes is for --kind sp");
  if (!options.max_depth) {
    throw UsageError("--kind classical needs --max-depth: what is round has no last level");
  }
  return ClassicalRules{*options.max_depth, kPartialNames.at(options.partial.value_or("full"))};
}

}  // namespace

void add_tree_options(CLI::App& command, TreeRules& rules) {
  const auto options = std::make_shared<TreeOptions>();
  command
      .add_option("--kind", options->kind,
                  "sp: planes in the nodes, exact; classical: full, void and mixed cells alone")
      ->check(CLI::IsMember({"sp", "classical"}))
      ->capture_default_str();
  command
      .add_option("--max-depth", options->max_depth,
                  "cells at this depth are leaves whatever they hold; sp stays exact (30 unless "
                  "given)")
      ->check(CLI::Range(0, kMaxDepth));
  command
      .add_option("--leaf-planes", options->leaf_planes,
                  "sp: cells with at most so many planes are leaves: fewer nodes, longer "
                  "expressions; 0: the paper's rule alone (16 unless given, and more in small "
                  "cells)")
      ->check(CLI::Range(0, 1000));
  command
      .add_option("--partial", options->partial,
                  "classical: cells still mixed at the depth limit are full (unless given), void, "
                  "or, with half, what their centre is (full if it lies on the boundary)")
      ->check(CLI::IsMember({"full", "void", "half"}));
  command.parse_complete_callback([options, &rules] { rules = to_rules(*options); });
}

std::string describe_rules(const TreeRules& rules) {
  if (const auto* classical = std::get_if<ClassicalRules>(&rules)) {
    std::string text = "kind=classical max-depth=" + std::to_string(classical->max_depth);
    for (const auto& [name, partial] : kPartialNames) {
      if (partial == classical->partial) text += " partial=" + name;
    }
    return text;
  }
  const SpRules& sp = std::get<SpRules>(rules);
  return "max-depth=" + std::to_string(sp.max_depth) +
         (sp.leaf_planes ? " leaf-planes=" + std::to_string(*sp.leaf_planes) : std::string());
}

}  // namespace spoctree
