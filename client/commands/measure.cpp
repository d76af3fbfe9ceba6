#include "client/queries/measure.hpp"

#include "client/commands/commands.hpp"
#include "common/program/output.hpp"
#include "common/report/model_note.hpp"

namespace spoctree {

void run_measure(const MeasureArguments& arguments) {
  LevelStream stream(arguments.stream);
  while (stream.next_level()) {
  }
  stream.progress_line().show("measuring level " + std::to_string(stream.level()));
  const Measures measures = measure(stream.tree(), stream.level());
  const SourceInfo& source = stream.decoder().info().source;
  std::string text = arguments.as_json ? to_json(measures, stream.model_name(), source.units)
                                       : to_table(measures, source.units);
  // Of a tree of cubes, what is exact is the cubes.
  const std::string note = note_on_levels(source);
  if (!arguments.as_json && !note.empty()) text += "about       " + note;
  stream.progress_line().clear();
  print(text);
}

}  // namespace spoctree
