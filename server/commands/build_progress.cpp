#include "server/commands/build_progress.hpp"

#include <string>

#include "common/program/remaining_time.hpp"

namespace spoctree {

BuildProgress show_progress(ProgressLine& line, const std::filesystem::path& mesh) {
  return [&line, name = mesh.filename().string(), elapsed = Elapsed(), shown = std::string()](
             const char* step, double fraction) mutable {
    // A new step is shown at once, its progress now and then.
    if (shown == step && !line.wants_text()) return;
    shown = step;
    line.show(name + ": " + step + " " + describe_progress(fraction, elapsed.seconds()));
  };
}

}  // namespace spoctree
