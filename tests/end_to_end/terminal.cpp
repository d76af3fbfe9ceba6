#include "tests/end_to_end/terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

namespace spoctree::test {

TerminalProgram::TerminalProgram(const std::string& program, const Arguments& arguments) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 80;
  pid_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
  if (pid_ < 0) throw std::runtime_error("no terminal");
  if (pid_ > 0) return;
  // The child: only calls that are safe after a fork.
  ::alarm(120);
  ::execv(words[0], words.data());
  ::_exit(127);
}

TerminalProgram::~TerminalProgram() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  ::close(terminal_);
}

/// Waits for a moment at most; false when there will be no more.
bool TerminalProgram::read_some() {
  pollfd ready{terminal_, POLLIN, 0};
  if (::poll(&ready, 1, 100) == 0) return true;
  char bytes[4096];
  const ssize_t count = ::read(terminal_, bytes, sizeof bytes);
  if (count <= 0) return false;  // an error: nobody has the other side open any more
  shown_.append(bytes, static_cast<std::size_t>(count));
  return true;
}

bool TerminalProgram::wait_for(const std::function<bool(const std::string& shown)>& is_there) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!is_there(shown_)) {
    if (std::chrono::steady_clock::now() > deadline || !read_some()) return is_there(shown_);
  }
  return true;
}

bool TerminalProgram::wait_for(const std::string& text) {
  return wait_for([&](const std::string& shown) { return shown.find(text) != std::string::npos; });
}

void TerminalProgram::press_ctrl_c() {
  if (::write(terminal_, "\x03", 1) != 1) throw std::runtime_error("the terminal is gone");
}

void TerminalProgram::send(int signal) const {
  if (pid_ > 0) ::kill(pid_, signal);  // -1 would be every process there is
}

int TerminalProgram::wait() {
  while (read_some()) {
  }
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace spoctree::test
