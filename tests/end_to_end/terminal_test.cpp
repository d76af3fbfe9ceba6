// What a user at a terminal sees of a long command, and what Ctrl-C leaves of it.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <regex>
#include <thread>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/end_to_end/programs.hpp"
#include "tests/end_to_end/sockets.hpp"
#include "tests/end_to_end/terminal.hpp"

namespace spoctree::test {
namespace {

/// What was shown as lines: each begins where the cursor went back to the first column.
std::vector<std::string> lines_of(const std::string& shown) {
  std::vector<std::string> lines(1);
  for (const char c : shown) {
    if (c == '\r' || c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  std::erase_if(lines, [](const std::string& line) { return line.empty(); });
  return lines;
}

class Terminal : public testing::Test {
 protected:
  /// A mesh that takes a second or so to build.
  std::string large_mesh() const {
    const std::string path = folder_.file("large.off");
    write_file(path, off_of("wavy-sphere", 120));
    return path;
  }
  TemporaryFolder folder_;
};

TEST_F(Terminal, ABuildShowsItsStepHowFarItIsAndHowLongItTakes) {
  const std::string mesh = large_mesh();
  TerminalProgram server(SPOCTREE_SERVER_PROGRAM, {"build", mesh, "-o", folder_.file("large.spo")});
  EXPECT_EQ(server.wait(), 0) << server.shown();
  // Name, step, percent, time so far, time left.
  const std::regex pattern(
      "large\\.off: ([a-z]+) +([0-9]+) %, ([0-9]+) s(, [0-9]+ s left)?\x1b\\[K");
  std::vector<std::string> steps;
  int last_percent = 0;
  bool is_time_left_told = false;
  std::smatch match;
  for (const std::string& line : lines_of(server.shown())) {
    if (!line.ends_with("\x1b[K") || line == "\x1b[K") continue;  // the summary, and clearing
    ASSERT_TRUE(std::regex_match(line, match, pattern)) << line;
    EXPECT_LE(line.size(), 79 + 3);
    if (steps.empty() || steps.back() != match[1]) steps.push_back(match[1]);
    const int percent = std::stoi(match[2]);
    EXPECT_GE(percent, last_percent);
    EXPECT_LE(percent, 100);
    last_percent = percent;
    is_time_left_told |= match[4].matched;
  }
  EXPECT_EQ(steps,
            (std::vector<std::string>{"reading", "judging", "building", "certifying", "encoding"}));
  EXPECT_TRUE(is_time_left_told);
  // The line is gone before the summary comes.
  EXPECT_NE(server.shown().find("\r\x1b[K" + mesh), std::string::npos) << server.shown();
}

TEST_F(Terminal, NothingIsShownWhereNobodyLooks) {
  const Outcome outcome = run_server({"build", large_mesh(), "-o", folder_.file("large.spo")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Terminal, CtrlCInAnyStepOfABuildLeavesNothing) {
  const std::string mesh = large_mesh();
  for (const std::string step : {"reading", "judging", "building", "certifying", "encoding"}) {
    TemporaryFolder output;
    TerminalProgram server(SPOCTREE_SERVER_PROGRAM, {"build", mesh, "-o", output.file("large.spo"),
                                                     "--save-solid", output.file("solid.off")});
    ASSERT_TRUE(server.wait_for(": " + step)) << server.shown();
    server.press_ctrl_c();
    const int code = server.wait();
    if (code == 0) {  // done before the key was pressed
      EXPECT_EQ(output.entries(), (std::vector<std::string>{"large.spo", "solid.off"})) << step;
      continue;
    }
    EXPECT_EQ(code, -SIGINT) << step;
    // Nothing is left on the terminal either.
    EXPECT_TRUE(server.shown().ends_with("\r\x1b[K")) << step << server.shown();
    EXPECT_EQ(output.entries(), std::vector<std::string>{}) << step;
  }
}

TEST_F(Terminal, AServerThatStillBuildsEndsByTheSignal) {
  const std::string mesh = large_mesh();
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    TerminalProgram server(SPOCTREE_SERVER_PROGRAM, {"serve", mesh, "--listen", "127.0.0.1:0"});
    ASSERT_TRUE(server.wait_for(": building")) << server.shown();
    server.send(signal);
    const int code = server.wait();
    // Built before the signal came, it ends as a server does.
    const bool was_serving = server.shown().find("listening on") != std::string::npos;
    EXPECT_EQ(code, was_serving && signal != SIGKILL ? 0 : -signal);
    EXPECT_EQ(folder_.entries(), std::vector<std::string>{"large.off"});
  }
}

TEST_F(Terminal, CtrlCWhileRebuildingOrDrawingLeavesNothing) {
  const std::string spo = folder_.file("large.spo");
  write_file(spo, spo_of("wavy-sphere", 120));
  for (const std::string command : {"rebuild", "draw"}) {
    TemporaryFolder output;
    const std::string name = command == "draw" ? "out.svg" : "out.off";
    TerminalProgram client(SPOCTREE_CLIENT_PROGRAM, {command, spo, "-o", output.file(name)});
    ASSERT_TRUE(client.wait_for("ing level ")) << client.shown();
    client.press_ctrl_c();
    const int code = client.wait();
    if (code == 0) {  // done before the key was pressed
      EXPECT_EQ(output.entries(), std::vector<std::string>{name});
      continue;
    }
    EXPECT_EQ(code, -SIGINT);
    EXPECT_EQ(output.entries(), std::vector<std::string>{});
  }
}

TEST_F(Terminal, ADrawingShowsItsStepHowFarItIsAndHowLongItTakes) {
  const std::string spo = folder_.file("large.spo");
  write_file(spo, spo_of("wavy-sphere", 120));
  TerminalProgram client(SPOCTREE_CLIENT_PROGRAM, {"draw", spo, "-o", folder_.file("out.svg")});
  EXPECT_EQ(client.wait(), 0) << client.shown();
  const std::regex pattern(
      "([a-z]+) level [0-9]+ +([0-9]+) %, ([0-9]+) s(, [0-9]+ s left)?\x1b\\[K");
  std::vector<std::string> steps;
  int last_percent = 0;
  std::smatch match;
  for (const std::string& line : lines_of(client.shown())) {
    if (line.find("ing level ") == std::string::npos) continue;  // what is received
    ASSERT_TRUE(std::regex_match(line, match, pattern)) << line;
    if (steps.empty() || steps.back() != match[1]) steps.push_back(match[1]);
    const int percent = std::stoi(match[2]);
    EXPECT_GE(percent, last_percent);
    EXPECT_LE(percent, 100);
    last_percent = percent;
  }
  EXPECT_EQ(steps, (std::vector<std::string>{"rebuilding", "preparing", "drawing", "writing"}));
}

TEST_F(Terminal, CtrlCInAnyStepOfAPageKeepsTheLevelsBefore) {
  const std::string spo = folder_.file("large.spo");
  write_file(spo, spo_of("wavy-sphere", 120));
  for (const std::string step : {"rebuilding", "preparing", "drawing"}) {
    TemporaryFolder output;
    TerminalProgram client(SPOCTREE_CLIENT_PROGRAM,
                           {"draw", spo, "--html", output.file("out.html")});
    ASSERT_TRUE(client.wait_for(step + " level 5")) << client.shown();
    client.press_ctrl_c();
    EXPECT_EQ(client.wait(), -SIGINT) << client.shown();
    EXPECT_EQ(output.entries(), std::vector<std::string>{"out.html"}) << step;
    const std::string page = read_file(output.file("out.html"));
    EXPECT_TRUE(page.ends_with("</html>\n")) << step;
    std::size_t levels = 0;
    for (std::size_t at = page.find("<section>"); at != std::string::npos;
         at = page.find("<section>", at + 1)) {
      ++levels;
    }
    // Level 5 was done, perhaps, before the key was pressed; not many more.
    EXPECT_GE(levels, 5U) << step;
    EXPECT_LE(levels, 6U) << step;
  }
}

/// Sends the frames of the first `levels` levels at once, and then bytes of the next one every now
/// and then, until `is_enough`.
void trickle(const Socket& socket, const SpoFile& file, std::uint32_t levels,
             const std::atomic<bool>& is_enough) {
  FrameReader frames(kMaxRequestPayloadBytes);
  while (!frames.next()) frames.feed(socket.receive());
  const std::uint64_t begin = file.level_bytes()[levels - 1].total_bytes;
  socket.send(file.frames().substr(0, begin));
  const std::uint64_t end = file.level_bytes()[levels].total_bytes - 1;
  for (std::uint64_t at = begin; at < end && !is_enough; ++at) {
    if (!socket.send(file.frames().substr(at, 1))) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  socket.receive();  // until the client is gone
}

TEST_F(Terminal, CtrlCKeepsTheWholeLevelsOfAFetchThatIsToBeResumed) {
  const std::string& spo = spo_of("wavy-sphere", 40);
  const SpoFile file(spo, "sphere");
  TemporaryFolder output;
  const std::string path = output.file("out.spo");
  std::atomic<bool> is_enough = false;
  FakeServer server([&](Socket socket) { trickle(socket, file, 3, is_enough); });
  TerminalProgram client(SPOCTREE_CLIENT_PROGRAM, {"fetch", server.url(), "-o", path, "--resume"});
  ASSERT_TRUE(client.wait_for("level 3 of 0..")) << client.shown();
  client.press_ctrl_c();
  EXPECT_EQ(client.wait(), -SIGINT) << client.shown();
  is_enough = true;
  EXPECT_NE(client.shown().find("holds 3 whole levels"), std::string::npos) << client.shown();
  EXPECT_EQ(output.entries(), std::vector<std::string>{"out.spo"});
  EXPECT_EQ(SpoFile(path).level_count(), 3U);
}

TEST_F(Terminal, ATransmissionShowsItsLevelBytesErrorAndTime) {
  const std::string& spo = spo_of("wavy-sphere", 40);
  const SpoFile file(spo, "sphere");
  std::atomic<bool> is_enough = false;
  FakeServer server([&](Socket socket) { trickle(socket, file, 3, is_enough); });
  TerminalProgram client(SPOCTREE_CLIENT_PROGRAM,
                         {"fetch", server.url(), "-o", folder_.file("out.spo")});
  const std::regex pattern(
      "level 3 of 0\\.\\.[0-9]+, [0-9]+ bytes, error [0-9.]+ %, +[0-9]+ %, [0-9]+ s");
  EXPECT_TRUE(client.wait_for([&](const std::string& shown) {
    return std::regex_search(shown, pattern);
  })) << client.shown();
  client.press_ctrl_c();
  EXPECT_EQ(client.wait(), -SIGINT);
  is_enough = true;
  EXPECT_EQ(folder_.entries(), std::vector<std::string>{});
}

}  // namespace
}  // namespace spoctree::test
