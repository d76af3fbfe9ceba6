#include "common/base/atomic_file.hpp"

#include <unistd.h>

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
}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path_, ignored);
  temporary_ = path_;
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    temporary_ += ".tmp" + std::to_string(::getpid());
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
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(path_, "write");
}

void AtomicFile::commit() {
  const bool flushed = std::fflush(file_) == 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  std::error_code error;
  if (flushed && closed && temporary_name_) std::filesystem::rename(temporary_, path_, error);
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
