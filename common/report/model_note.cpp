#include "common/report/model_note.hpp"

namespace spoctree {

std::string note_on_levels(const SourceInfo& source) {
  const std::string& options = source.build_options;
  if (options.starts_with("kind=silhouettes ")) {
    return "octree from silhouettes: the solid is the cubes that project into all masks, and every "
           "level contains it; of the object that was seen nothing is certain\n";
  }
  if (!options.starts_with("kind=classical ")) return {};
  const bool is_full = options.find(" partial=full") != std::string::npos;
  return std::string("classical octree, ") +
         (is_full ? "partial cells full: every level contains the solid"
                  : "partial cells void or as their centre: no level need contain the solid; "
                    "error % holds both ways, of the cubes from the solid and of the solid from "
                    "the cubes") +
         "; volumes are those of the cubes\n";
}

}  // namespace spoctree
