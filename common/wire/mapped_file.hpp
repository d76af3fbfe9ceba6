// A file's bytes as memory, without reading them first.
#pragma once

#include <filesystem>
#include <string_view>

namespace spoctree {

/// A file mapped read-only. Throws BadInput naming the path and the system's reason when it cannot
/// be opened or is not a regular file. A file that is replaced by renaming (AtomicFile) keeps its
/// old bytes here; one that is shortened in place must not be read any more.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;

  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
};

}  // namespace spoctree
