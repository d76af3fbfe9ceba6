// A file that is either whole or absent: written without a name, which it gets when finished.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "common/base/temporary_name.hpp"

namespace spoctree {

/// Collects bytes in a file without a name in the folder of `path`, or (where the system has no
/// such files) under a temporary one; `commit` puts it in the place of `path`. Without `commit`,
/// whatever ends the program, `path` is as it was before; and nothing else is left behind, except
/// that a temporary name survives SIGKILL. Where `path` is a device or a pipe there is nothing to
/// replace: it is written as it stands. Where it is a symbolic link, the file that it points to is
/// replaced, and the link stays. Throws BadInput (naming the path and the system's reason) when the
/// file cannot be created, written or named.
class AtomicFile {
 public:
  enum class Storage { Unnamed, Named };  ///< Unnamed: where the system can
  explicit AtomicFile(std::filesystem::path path, Storage storage = Storage::Unnamed);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  bool open_unnamed();
  bool give_name();
  bool has_temporary_name() const { return temporary_name_.has_value(); }

  std::filesystem::path path_;       ///< as given
  std::filesystem::path target_;     ///< the same with links followed
  std::filesystem::path temporary_;  ///< beside the target; the target itself if it is no file
  std::optional<TemporaryName> temporary_name_;
  bool is_unnamed_ = false;
  std::FILE* file_ = nullptr;
};

/// Writes `bytes` to `path` as one AtomicFile.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace spoctree
