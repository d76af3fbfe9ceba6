#include "common/base/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <string>
#include <system_error>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {
[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw BadInput(path.string() + ": cannot " + what + ": " + std::strerror(errno));
}

/// Where the symbolic links that start at `path` end: a rename would replace the link itself.
std::filesystem::path follow_links(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as the system: then it is a circle, and cannot be created
  std::error_code error;
  for (int links = 0; links < kMostLinks; ++links) {
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) break;
    const auto target = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;  // an absolute target replaces all of it
  }
  return path;
}

/// Different for every file that is being written, in this process and others.
std::string unique_suffix() {
  static std::atomic<unsigned> count = 0;
  return ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

/// The name that /proc has for an open file.
std::string name_in_proc(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }
}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path, Storage storage)
    : path_(std::move(path)), target_(follow_links(path_)) {
  std::error_code ignored;
  const auto status = std::filesystem::status(target_, ignored);
  temporary_ = target_;
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    temporary_ += unique_suffix();
    if (storage == Storage::Unnamed && open_unnamed()) return;
    temporary_name_.emplace(temporary_.string());
  }
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ == nullptr) fail(path_, "create");
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  if (has_temporary_name()) std::filesystem::remove(temporary_, ignored);
}

/// False where that cannot be, or where the name to come would be refused: the named way then says
/// why.
bool AtomicFile::open_unnamed() {
  if (!target_.has_filename() || temporary_.filename().native().size() > NAME_MAX) return false;
  const auto folder = target_.has_parent_path() ? target_.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  // Without /proc it could not be named later.
  if (::access(name_in_proc(descriptor).c_str(), F_OK) == 0) {
    file_ = ::fdopen(descriptor, "wb");
  }
  if (file_ == nullptr) ::close(descriptor);
  is_unnamed_ = file_ != nullptr;
  return is_unnamed_;
}

/// Under a temporary name, because a link cannot replace a file.
bool AtomicFile::give_name() {
  temporary_name_.emplace(temporary_.string());
  is_unnamed_ = false;
  return ::linkat(AT_FDCWD, name_in_proc(::fileno(file_)).c_str(), AT_FDCWD, temporary_.c_str(),
                  AT_SYMLINK_FOLLOW) == 0;
}

void AtomicFile::write(std::string_view bytes) {
  if (bytes.empty()) return;  // whose data may be null
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(path_, "write");
}

void AtomicFile::commit() {
  int reason = 0;
  const auto succeeds = [&reason](bool done) {
    if (!done && reason == 0) reason = errno;
    return done;
  };
  bool is_good = succeeds(std::fflush(file_) == 0);
  if (is_good && is_unnamed_) is_good = succeeds(give_name());
  is_good = succeeds(std::fclose(file_) == 0) && is_good;
  file_ = nullptr;
  if (is_good && has_temporary_name()) {
    is_good = succeeds(std::rename(temporary_.c_str(), target_.c_str()) == 0);
  }
  if (is_good) return;
  std::error_code ignored;
  if (has_temporary_name()) std::filesystem::remove(temporary_, ignored);
  errno = reason;
  fail(path_, "write");
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace spoctree
