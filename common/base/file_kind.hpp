// The first bytes of a file -> what kind of file it is, to be named where another was expected.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace spoctree {

struct FileKind {
  std::string name;      ///< with its article: "a STEP file"
  std::string hint;      ///< what to do with it to get a mesh, as "export it as STL"; may be empty
  bool is_mesh = false;  ///< of a format that spoctree-server reads
  std::string_view extension =
      {};  ///< what its name should end in: ".stl"; of meshes and of .spo files
};

/// What `bytes`, a whole file or (of a large one) its beginning, evidently is: by the marks with
/// which formats begin. Nothing if it has none; a mesh that is damaged may still have its mark. Of
/// binary STL and OBJ, which have no mark, those that are clearly so are known. Looks at some
/// thousand bytes, and of a zip archive at the names in it (O(bytes)).
std::optional<FileKind> find_file_kind(std::string_view bytes);

}  // namespace spoctree
