#include "server/commands/build_progress.hpp"

#include <string>

namespace spoctree {

BuildProgress show_progress(ProgressLine& line, const std::filesystem::path& mesh) {
  return [&line, name = mesh.filename().string()](const char* step, double fraction) {
    // A new step is shown at once, its progress now and then.
    if (fraction > 0 && !line.wants_text()) return;
    line.show(name + ": " + step + " " + std::to_string(static_cast<int>(100 * fraction)) + " %");
  };
}

}  // namespace spoctree
