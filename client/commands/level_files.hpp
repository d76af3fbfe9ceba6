// -o OUT -> the file of each level.
#pragma once

#include <cstdint>
#include <string>

namespace spoctree {

/// The names of the files that a command writes when it may write one per level. OUT is
/// - "-": standard output, for one level only;
/// - a pattern: %d, or %02d and the like, stands for the level's number;
/// - a folder, if one of that name exists, or if it has no extension and all levels are wanted: it
///   is made, and the files in it are level-00.EXTENSION, level-01.EXTENSION, ...;
/// - else the file, for one level only.
class LevelFiles {
 public:
  /// `extension` (as ".svg") is for files in a folder. Throws UsageError when there is one name for
  /// many levels, BadInput when the folder cannot be made.
  LevelFiles(const std::string& output, bool all_levels, const std::string& extension);

  std::string name_of(std::uint32_t level) const;

  /// Whether all levels would go into one file or to standard output, for formats that can.
  static bool is_one_file(const std::string& output);

 private:
  std::string before_;
  std::string after_;
  int digits_ = 0;  ///< 0: as many as there are
  bool has_number_ = false;
};

}  // namespace spoctree
