#include "client/commands/commands.hpp"
#include "common/program/output.hpp"
#include "common/report/level_rows.hpp"
#include "common/report/model_note.hpp"

namespace spoctree {

void run_levels(const LevelsArguments& arguments) {
  LevelStream stream(arguments.stream);
  while (stream.next_level()) {
  }
  stream.progress_line().clear();
  const auto rows = level_rows(stream.tree(), stream.decoder().level_bytes());
  switch (arguments.format) {
    case LevelsArguments::Format::Table:
      return print(to_table(rows) + note_on_levels(stream.decoder().info().source));
    case LevelsArguments::Format::Csv:
      return print(to_csv(rows));
    case LevelsArguments::Format::Json:
      return print(to_json(stream.model_name(), rows));
  }
}

}  // namespace spoctree
