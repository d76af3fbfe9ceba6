#include "tests/end_to_end/programs.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tools/model/models.hpp"

namespace spoctree::test {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "spoctree-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::entries() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

Program::Program(const std::string& program, const Arguments& arguments) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const std::string out = folder_.file("out");
  const std::string err = folder_.file("err");
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ > 0) return;
  // The child: only calls that are safe after a fork.
  const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  const int err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  ::alarm(120);
  ::execv(words[0], words.data());
  ::_exit(127);
}

Program::~Program() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Program::send(int signal) const {
  if (pid_ > 0) ::kill(pid_, signal);  // -1 would be every process there is
}

std::string Program::first_line() const {
  std::string text;
  wait_until([&] {
    text = read_file(folder_.file("out"));
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
    return text.find('\n') != std::string::npos || ended.si_pid == pid_;
  });
  return text.substr(0, text.find('\n'));
}

Outcome Program::wait() {
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return {code, read_file(folder_.file("out")), read_file(folder_.file("err"))};
}

Outcome run_server(const Arguments& arguments) {
  return Program(SPOCTREE_SERVER_PROGRAM, arguments).wait();
}

Outcome run_client(const Arguments& arguments) {
  return Program(SPOCTREE_CLIENT_PROGRAM, arguments).wait();
}

namespace {
Arguments serve_arguments(const Arguments& paths, const std::string& listen) {
  Arguments arguments = {"serve"};
  arguments.insert(arguments.end(), paths.begin(), paths.end());
  arguments.insert(arguments.end(), {"--listen", listen});
  return arguments;
}
}  // namespace

ServerProcess::ServerProcess(const Arguments& paths, const std::string& listen)
    : program_(SPOCTREE_SERVER_PROGRAM, serve_arguments(paths, listen)) {
  const std::string line = program_.first_line();
  const std::string expected = "listening on ";
  if (line.compare(0, expected.size(), expected) != 0)
    throw std::runtime_error("the server does not listen: " + program_.wait().err);
  address_ = line.substr(expected.size());
}

std::uint16_t ServerProcess::port() const {
  return static_cast<std::uint16_t>(std::stoi(address_.substr(address_.rfind(':') + 1)));
}

void expect_one_complaint(const Outcome& outcome, const std::string& program) {
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.find(program + ": "), 0U) << outcome.err;
}

std::string off_of(const std::string& model, int size) {
  return model::to_off(
      model::make_model(model, size > 0 ? std::optional<int>(size) : std::nullopt));
}

const std::string& spo_of(const std::string& model, int size) {
  static std::map<std::pair<std::string, int>, std::string> made;
  std::string& bytes = made[{model, size}];
  if (bytes.empty()) {
    const TemporaryFolder folder;
    write_file(folder.file(model + ".off"), off_of(model, size));
    const Outcome outcome = run_server({"build", folder.file(model + ".off"), "-o",
                                        folder.file("model.spo"), "--leaf-planes", "0"});
    if (outcome.code != 0) throw std::runtime_error("cannot build " + model + ": " + outcome.err);
    bytes = read_file(folder.file("model.spo"));
  }
  return bytes;
}

}  // namespace spoctree::test
