// Running the programs as their users do.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace spoctree::test {

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Names of the entries, sorted.
  std::vector<std::string> entries() const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& bytes);

using Arguments = std::vector<std::string>;

/// What a program has left. `code` is -signal if a signal ended it.
struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// A program under way. A limit of two minutes ends what does not end by itself.
class Program {
 public:
  Program(const std::string& program, const Arguments& arguments);
  /// Kills it if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  /// The first line of its standard output, as soon as it is there.
  std::string first_line() const;
  Outcome wait();

 private:
  TemporaryFolder folder_;
  pid_t pid_ = -1;
};

Outcome run_server(const Arguments& arguments);
Outcome run_client(const Arguments& arguments);

/// spoctree-server serve ... on a free port of the loopback.
class ServerProcess {
 public:
  explicit ServerProcess(const Arguments& paths, const std::string& listen = "127.0.0.1:0");
  const std::string& address() const { return address_; }
  std::uint16_t port() const;
  std::string url(const std::string& name) const { return "spo://" + address_ + "/" + name; }
  Program& program() { return program_; }

 private:
  Program program_;
  std::string address_;
};

/// Waits until `is_true()`, which somebody else's progress makes true; false after a minute.
template <typename Condition>
bool wait_until(Condition&& is_true);

/// The text has exactly one line, which begins with the program's name.
void expect_one_complaint(const Outcome& outcome, const std::string& program);

/// A .spo file's bytes: a model of tools/model (as spoctree-model makes it), built by
/// spoctree-server --leaf-planes 0, so that small models have several levels. Built once per test
/// program.
const std::string& spo_of(const std::string& model, int size = 0);
/// The same model as a mesh file's text.
std::string off_of(const std::string& model, int size = 0);

}  // namespace spoctree::test

#include <chrono>
#include <thread>

template <typename Condition>
bool spoctree::test::wait_until(Condition&& is_true) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!is_true()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}
