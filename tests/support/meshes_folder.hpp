// Where the real meshes lie that some tests use, if anywhere.
#pragma once

#include <cstdlib>

namespace spoctree {

/// The folder that the environment variable SPOCTREE_MESHES names; null if it is unset or empty.
inline const char* meshes_folder() {
  const char* folder = std::getenv("SPOCTREE_MESHES");
  return folder != nullptr && *folder != '\0' ? folder : nullptr;
}

}  // namespace spoctree
