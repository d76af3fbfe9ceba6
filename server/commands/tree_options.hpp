// Options of the command line -> which tree is built, and its name in the stream.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "server/build/classifier.hpp"

namespace spoctree {

/// Adds --kind, --max-depth, --leaf-planes and --partial. `rules`, which must live as long as the
/// command, is set when the command line has been read; options that would do nothing for the kind
/// asked for, and a classical tree without a depth, are then refused.
void add_tree_options(CLI::App& command, TreeRules& rules);

/// "name=value" pairs, blank between: how to build the tree again.
std::string describe_rules(const TreeRules& rules);

}  // namespace spoctree
