#include "server/commands/serve_command.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "common/base/errors.hpp"
#include "common/program/output.hpp"
#include "common/program/progress_line.hpp"
#include "common/wire/address.hpp"
#include "server/commands/build_progress.hpp"
#include "server/mesh/read_mesh.hpp"
#include "server/net/log.hpp"
#include "server/net/model_store.hpp"
#include "server/net/server.hpp"

namespace spoctree {

namespace {

namespace fs = std::filesystem;

bool is_spo(const fs::path& path) { return path.extension() == ".spo"; }

void add_model(ModelStore& store, const fs::path& path, const ModelOptions& options) {
  const std::string name = path.stem().string();
  if (is_spo(path)) return store.add_file(name, path);
  store.check_name(name, path.string());
  ProgressLine line;
  Model model = build_model(path, options, show_progress(line, path));
  for (const std::string& change : model.changes) log_info(path.string() + ": " + change);
  store.add_bytes(name, path.string(), std::move(model.spo));
}

// A .spo file stands for the mesh of the same name that it was built from.
bool is_built_already(const fs::path& mesh) {
  std::error_code ignored;
  return !is_spo(mesh) && fs::is_regular_file(fs::path(mesh).replace_extension(".spo"), ignored);
}

// Sorted, so that the same folder gives the same messages in the same order.
std::vector<fs::path> models_in_folder(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (entry->is_regular_file() && (is_spo(path) || format_of_extension(path)))
      paths.push_back(path);
  }
  if (error) throw BadInput(folder.string() + ": cannot read the folder: " + error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

void add_folder(ModelStore& store, const fs::path& folder, const ModelOptions& options) {
  for (const fs::path& path : models_in_folder(folder)) {
    if (is_built_already(path)) continue;
    try {
      add_model(store, path, options);
    } catch (const BadInput& error) {
      log_warning(std::string("not served: ") + error.what());
    }
  }
}

// A connection is a file descriptor, and the usual soft limit is too tight for kMaxConnections.
void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const rlim_t wanted = 2 * kMaxConnections;
  if (limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min(wanted, limit.rlim_max);
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

void run_serve(const ServeArguments& arguments) {
  const Address address = parse_address(arguments.listen);
  ModelStore store;
  for (const std::string& path : arguments.paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      add_folder(store, path, arguments.options);
    } else {
      add_model(store, path, arguments.options);
    }
  }
  if (store.is_empty()) throw BadInput("no model to serve");
  raise_descriptor_limit();
  Server server(store, address);
  print("listening on " + to_text(server.address()) + "\n");
  log_info("serving " + store.names_as_text());
  server.run();
  log_info("ended by a signal");
}

}  // namespace spoctree
