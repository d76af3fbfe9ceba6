#include <algorithm>
#include <vector>

#include "client/commands/commands.hpp"
#include "common/program/output.hpp"
#include "common/report/text_table.hpp"
#include "common/wire/hash.hpp"
#include "common/wire/percent_text.hpp"

namespace spoctree {

void run_list(const ListArguments& arguments) {
  const Address server = parse_server(arguments.server);
  const auto models = fetch_catalog(server);
  std::vector<TableRow> rows = {{"bytes", "levels", "nodes", "planes", "id", "source", "name"}};
  for (const CatalogEntry& model : models) {
    rows.push_back({std::to_string(model.byte_count), std::to_string(model.level_count),
                    std::to_string(model.node_count), std::to_string(model.plane_count),
                    to_hex(model.model_id),
                    "spo://" + to_text(server) + "/" + percent_encoded(model.name), model.name});
  }
  print(align_columns(rows));
}

}  // namespace spoctree
