// How far a build is, on the terminal.
#pragma once

#include <string>

#include "common/program/progress_line.hpp"
#include "server/commands/build_model.hpp"

namespace spoctree {

/// Shows "NAME: building 42 %" on `line`, which must outlive the result.
BuildProgress show_progress(ProgressLine& line, const std::string& name);

}  // namespace spoctree
