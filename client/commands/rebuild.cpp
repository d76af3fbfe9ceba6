#include "client/commands/commands.hpp"
#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface.hpp"
#include "common/base/errors.hpp"
#include "common/program/output.hpp"

namespace spoctree {

void run_rebuild(const RebuildArguments& arguments) {
  if (are_one_file(arguments.stream.source, arguments.output))
    throw UsageError(arguments.output + ": the mesh would be written over the model itself");
  LevelStream stream(arguments.stream);
  while (stream.next_level()) {
  }
  stream.progress_line().show("rebuilding level " + std::to_string(stream.level()));
  const Surface surface = rebuild_surface(stream.tree(), stream.level());
  write_output(arguments.output, to_off(make_polygon_mesh(surface, stream.tree().universe)));
}

}  // namespace spoctree
