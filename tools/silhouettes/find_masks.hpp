// Folders and picture files -> the silhouettes they hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "server/silhouettes/build_from_silhouettes.hpp"

namespace spoctree {

/// A picture of a view: its file is called like the view, or ends in "-" and the view's name.
struct MaskFile {
  std::size_t view = 0;  ///< index in all_views()
  std::filesystem::path path;
};

/// The masks in folders (all files with the extensions pbm, pgm and png that are called like
/// views), and those named one by one, in the order of all_views(). Throws BadInput for a file
/// whose name names no view, for two files of one view, and if there is none at all.
std::vector<MaskFile> find_masks(const std::vector<std::string>& paths);

/// The cube that a cube.txt in one of the folders, or beside one of the files, names, if there is
/// one: the first.
std::optional<Universe> find_cube(const std::vector<std::string>& paths);

/// Silhouettes, and what was remarked of their files: "face-x.pgm: every pixel is black", once
/// where several files have the same remark.
struct FoundSilhouettes {
  std::vector<Silhouette> silhouettes;
  std::vector<std::string> remarks;
};

/// Those of the files, in their order. Throws BadInput as read_mask does.
FoundSilhouettes read_silhouettes(const std::vector<MaskFile>& files);

}  // namespace spoctree
