// A file that is either whole or absent: written under a temporary name, renamed when finished.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "common/base/temporary_name.hpp"

namespace spoctree {

/// Collects bytes in a temporary file beside `path`; `commit` flushes and renames it over `path`.
/// Destroyed without `commit`, the temporary file is removed and `path` is as it was before. Where
/// `path` is a device or a pipe there is nothing to replace: it is written as it stands. Where it
/// is a symbolic link, the file that it points to is replaced, and the link stays. Throws BadInput
/// (naming the path and the system's reason) when the file cannot be created, written or renamed.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  std::filesystem::path path_;       ///< as given
  std::filesystem::path target_;     ///< the same with links followed
  std::filesystem::path temporary_;  ///< beside the target
  std::optional<TemporaryName> temporary_name_;
  std::FILE* file_ = nullptr;
};

/// Writes `bytes` to `path` as one AtomicFile.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace spoctree
