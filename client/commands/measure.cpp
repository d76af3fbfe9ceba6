#include "client/queries/measure.hpp"

#include "client/commands/commands.hpp"
#include "common/program/output.hpp"

namespace spoctree {

void run_measure(const MeasureArguments& arguments) {
  LevelStream stream(arguments.stream);
  while (stream.next_level()) {
  }
  stream.progress_line().show("measuring level " + std::to_string(stream.level()));
  const Measures measures = measure(stream.tree(), stream.level());
  const std::string& units = stream.decoder().info().source.units;
  const std::string text =
      arguments.as_json ? to_json(measures, stream.model_name(), units) : to_table(measures, units);
  stream.progress_line().clear();
  print(text);
}

}  // namespace spoctree
