// Where the real meshes lie that some tests use, if anywhere.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace spoctree {

/// The folder that the environment variable SPOCTREE_MESHES names; null if it is unset or empty.
inline const char* meshes_folder() {
  const char* folder = std::getenv("SPOCTREE_MESHES");
  return folder != nullptr && *folder != '\0' ? folder : nullptr;
}

/// What a test on a mesh, or on a model, is called: only letters, digits and underlines may be in
/// it.
inline std::string test_name_of(const std::filesystem::path& mesh) {
  std::string name = mesh.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace spoctree
