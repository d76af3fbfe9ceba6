// spoctree-server serve: files and folders -> models under names -> connections.
#pragma once

#include <string>
#include <vector>

#include "common/wire/limits.hpp"
#include "server/commands/build_model.hpp"

namespace spoctree {

struct ServeArguments {
  std::vector<std::string> paths;  ///< .spo files, meshes, folders of both
  std::string listen = "127.0.0.1:" + std::to_string(kDefaultPort);
  ModelOptions options;  ///< for the meshes
};

/// Serves until SIGTERM or SIGINT. Throws UsageError when two models would have one name, BadInput
/// when a file named is not a model, NetworkError when the address cannot be listened on. What does
/// not belong to a model in a folder is left out, and said.
void run_serve(const ServeArguments& arguments);

}  // namespace spoctree
