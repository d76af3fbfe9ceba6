// The command `render`: a mesh -> its thirteen silhouettes as picture files.
#pragma once

#include <string>

#include "server/silhouettes/encode_mask.hpp"

namespace spoctree {

struct RenderArguments {
  std::string mesh;
  std::string folder;
  std::string cube;  ///< empty: the universe cube of the mesh
  std::string views = "all";
  int size = 128;              ///< pixels in a row and in a column
  bool square_pixels = false;  ///< the same for face views; others have more of the same pixels
  MaskFormat format = MaskFormat::Pgm;
};

/// Throws BadInput for a mesh that is no solid or does not lie in the cube, and for a folder that
/// cannot be written.
void run_render(const RenderArguments& arguments);

}  // namespace spoctree
