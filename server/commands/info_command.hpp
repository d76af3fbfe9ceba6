// spoctree-server info: what a .spo file or a mesh file holds.
#pragma once

#include <string>

namespace spoctree {

struct InfoArguments {
  std::string file;
  bool as_json = false;
};

/// Throws BadInput when the file is not what its name says.
void run_info(const InfoArguments& arguments);

}  // namespace spoctree
