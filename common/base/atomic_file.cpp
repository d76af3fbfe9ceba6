#include "common/base/atomic_file.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
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
}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), target_(follow_links(path_)) {
  std::error_code ignored;
  const auto status = std::filesystem::status(target_, ignored);
  temporary_ = target_;
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    temporary_ += unique_suffix();
    temporary_name_.emplace(temporary_.string());
  }
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ == nullptr) fail(path_, "create");
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::error_code ignored;
  if (temporary_name_) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  if (bytes.empty()) return;  // whose data may be null
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(path_, "write");
}

void AtomicFile::commit() {
  const bool flushed = std::fflush(file_) == 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  std::error_code error;
  if (flushed && closed && temporary_name_) std::filesystem::rename(temporary_, target_, error);
  if (flushed && closed && !error) return;
  if (error) errno = error.value();
  const int reason = errno;
  std::error_code ignored;
  if (temporary_name_) std::filesystem::remove(temporary_, ignored);
  errno = reason;
  fail(path_, "write");
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace spoctree
