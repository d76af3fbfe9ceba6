// How far a build is, on the terminal.
#pragma once

#include <filesystem>

#include "common/program/progress_line.hpp"
#include "server/commands/build_model.hpp"

namespace spoctree {

/// Shows "MESH: building 42 %, 3 s, 4 s left" on `line`, which must outlive the result; of `mesh`
/// the name alone.
BuildProgress show_progress(ProgressLine& line, const std::filesystem::path& mesh);

}  // namespace spoctree
