#include "server/commands/build_progress.hpp"

namespace spoctree {

BuildProgress show_progress(ProgressLine& line, const std::string& name) {
  return [&line, name](const char* step, double fraction) {
    // A new step is shown at once, its progress now and then.
    if (fraction > 0 && !line.wants_text()) return;
    line.show(name + ": " + step + " " + std::to_string(static_cast<int>(100 * fraction)) + " %");
  };
}

}  // namespace spoctree
