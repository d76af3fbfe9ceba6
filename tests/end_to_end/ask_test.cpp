// spoctree-client classify, ray and measure, as users run them.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/end_to_end/programs.hpp"
#include "tests/end_to_end/sockets.hpp"

namespace spoctree::test {
namespace {

/// The mechanical piece stands on z = 0, is 120 wide (x from -60) and has a back at y = 70.
class Ask : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    write_file(folder_.file(name), bytes);
    return folder_.file(name);
  }
  std::string piece() const { return put("piece.spo", spo_of("mechanical-piece")); }
  Outcome ask(const std::string& command, const std::string& questions,
              const Arguments& more = {}) const {
    Arguments arguments = {command, piece(), put("questions.txt", questions)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_client(arguments);
  }

  const std::string& spo_ = spo_of("mechanical-piece");
  const SpoFile file_{spo_, "piece"};
  const std::uint32_t last_ = file_.level_count() - 1;
  TemporaryFolder folder_;
};

const char* const kPoints =
    "# where?\n"
    "-50 40 10\n"
    "\n"
    "-50 40 0\n"
    "-60 70 0\n"
    "-50 40 -1\n"
    "1e300 0 0\n"
    "-50 40 1e-9";

TEST_F(Ask, ClassifySaysWherePointsLie) {
  const Outcome outcome = ask("classify", kPoints);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "in\non\non\nout\nout\nin\n");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Ask, ClassifyAtTheFirstLevelDoesNotKnowTheInside) {
  const Outcome outcome = ask("classify", kPoints, {"--level", "0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "unknown\nunknown\nunknown\nout\nout\nunknown\n");
}

TEST_F(Ask, RaySaysWhereTheBoundaryIsCrossedFirst) {
  const Outcome outcome = ask("ray",
                              "-50 40 -10 0 0 1\n"   // onto the bottom
                              "-50 40 -10 0 0 20\n"  // the same, t in larger units
                              "-50 40 10 0 0 -1\n"   // from inside: out of the bottom
                              "-100 40 10 1 0 0\n"   // onto the side
                              "-50 40 -10 0 0 -1\n"  // away from it
                              "-50 40 0 0 0 -1\n");  // from the boundary outwards
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "hit 10 0 0 -1\nhit 0.5 0 0 -1\nhit 10 0 0 -1\nhit 40 -1 0 0\nmiss\nmiss\n");
}

TEST_F(Ask, RaysMayStartAsFarOffAsDoublesReach) {
  const Outcome outcome = ask("ray",
                              "-1e20 40 10 1 0 0\n"
                              "-1e300 40 10 2e280 0 0\n"
                              "-50 40 -1e200 0 0 4\n"
                              "-1e20 40 1e4 1 0 0\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "hit 1e+20 -1 0 0\nhit 5e+19 -1 0 0\nhit 2.5e+199 0 0 -1\nmiss\n");
}

TEST_F(Ask, RayBoundsWhatItCannotKnow) {
  const Outcome outcome = ask("ray", "-50 40 -10 0 0 1\n-50 40 -10 0 0 -1\n", {"--level", "0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  double first = 0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str(), "between %lf inf\nmiss\n", &first), 1) << outcome.out;
  EXPECT_LE(first, 10);
  EXPECT_NEAR(first, 10, 1e-9);
}

TEST_F(Ask, MeasureSaysTheSameAsTheMeshDoes) {
  const Outcome outcome = run_client({"measure", piece()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("box         x -60 to 60, y 0 to 70, z 0 to 78\n"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("components  1\ncavities    0\n"), std::string::npos);
  const Outcome json = run_client({"measure", piece(), "--json", "--level", "1"});
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(json.out.find("{\"model\":\"piece\",\"units\":\"\",\"level\":1,\"exact\":false,"), 0u)
      << json.out;
  EXPECT_NE(json.out.find("\"components\":null,\"cavities\":null}"), std::string::npos);
}

TEST_F(Ask, AnswersComeBeforeTheLineThatIsWrong) {
  const std::pair<Arguments, const char*> cases[] = {
      {{"classify", "-50 40 10\n-50 40\n"}, "questions.txt: line 2: 2 numbers where 3 belong"},
      {{"classify", "-50 40 10\n-50 40 nan\n"}, "questions.txt: line 2: 'nan' is not a finite"},
      {{"classify", "-50 40 10\n\n# 1\nx 1 2\n"}, "questions.txt: line 4: 'x' is not a number"},
      {{"ray", "-50 40 10 0 0 1\n1 2 3 0 0 -0\n"}, "questions.txt: line 2: the direction is 0 0 0"},
      {{"ray", "-50 40 10 0 0 1\n1 2 3\n"}, "questions.txt: line 2: 3 numbers where 6 belong"},
  };
  for (const auto& [asked, error] : cases) {
    const Outcome outcome = ask(asked[0], asked[1]);
    EXPECT_EQ(outcome.code, 3);
    expect_one_complaint(outcome, "spoctree-client");
    EXPECT_NE(outcome.err.find(error), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1) << outcome.out;
  }
}

TEST_F(Ask, NamesAFileOfQuestionsThatIsNotThere) {
  const Outcome outcome = run_client({"classify", piece(), folder_.file("nothing.txt")});
  EXPECT_EQ(outcome.code, 3);
  expect_one_complaint(outcome, "spoctree-client");
  EXPECT_NE(outcome.err.find("nothing.txt: cannot read: No such file"), std::string::npos);
  EXPECT_EQ(run_client({"ray", piece(), folder_.path().string()}).code, 3);
}

TEST_F(Ask, RefusesALevelBeyondTheLast) {
  for (const char* command : {"classify", "ray", "measure"}) {
    const Outcome outcome = run_client({command, piece(), "--level", std::to_string(last_ + 1)});
    EXPECT_EQ(outcome.code, 2) << command;
    expect_one_complaint(outcome, "spoctree-client");
  }
}

TEST_F(Ask, StandardInputIsAnsweredLineByLine) {
  const std::string questions = folder_.file("questions");
  ASSERT_EQ(::mkfifo(questions.c_str(), 0600), 0);
  const std::string answers = folder_.file("answers");
  Program shell("/bin/sh", {"-c", "exec " SPOCTREE_CLIENT_PROGRAM " classify '" + piece() +
                                      "' < '" + questions + "' > '" + answers + "'"});
  const int pipe = ::open(questions.c_str(), O_WRONLY);
  ASSERT_GE(pipe, 0);
  std::string expected;
  const std::pair<std::string, std::string> turns[] = {
      {"-50 40 10\n", "in\n"}, {"-50 40 -10\n-50 40 0\n", "out\non\n"}, {"0 0", ""}};
  for (const auto& [question, answer] : turns) {
    ASSERT_EQ(::write(pipe, question.data(), question.size()),
              static_cast<ssize_t>(question.size()));
    expected += answer;
    EXPECT_TRUE(wait_until([&] { return read_file(answers) == expected; })) << read_file(answers);
  }
  ASSERT_EQ(::write(pipe, " -1", 3), 3);
  ::close(pipe);
  EXPECT_EQ(shell.wait().code, 0);
  EXPECT_EQ(read_file(answers), expected + "out\n");
}

/// Reads the one request that a client sends.
GetRequest receive_request(const Socket& socket) {
  FrameReader frames(kMaxRequestPayloadBytes);
  while (true) {
    if (const auto frame = frames.next()) return std::get<GetRequest>(open_request(*frame));
    const std::string bytes = socket.receive();
    if (bytes.empty()) throw std::runtime_error("the client went away");
    frames.feed(bytes);
  }
}

TEST_F(Ask, ALevelAnswersWithoutTheLevelsBehindIt) {
  const std::string questions = put("questions.txt", kPoints);
  for (const char* command : {"classify", "measure"}) {
    FakeServer server([&](Socket socket) {
      EXPECT_EQ(receive_request(socket).levels, 3u);
      socket.send(*file_.slice(3));
      socket.receive();  // no more comes; the client leaves
    });
    Arguments arguments = {command, server.url(), "--level", "2"};
    if (command == std::string("classify")) arguments.push_back(questions);
    const Outcome remote = run_client(arguments);
    EXPECT_EQ(remote.code, 0) << remote.err;
    EXPECT_NE(remote.out, "");
  }
  const ServerProcess server({piece()});
  for (std::uint32_t level = 0; level <= last_; ++level) {
    const Arguments more = {questions, "--level", std::to_string(level)};
    Arguments remote = {"classify", server.url("piece")};
    Arguments local = {"classify", piece()};
    remote.insert(remote.end(), more.begin(), more.end());
    local.insert(local.end(), more.begin(), more.end());
    EXPECT_EQ(run_client(remote).out, run_client(local).out);
  }
}

TEST_F(Ask, FollowAnswersEachQuestionWithTheFirstLevelThatCan) {
  const Outcome all = ask("classify", kPoints, {"--follow"});
  EXPECT_EQ(all.code, 0) << all.err;
  // What --follow must say: the first level whose own answer is not `unknown`.
  std::string expected;
  std::vector<bool> done(6, false);
  const int line_of[] = {2, 4, 5, 6, 7, 8};
  std::vector<std::string> up_to;  // everything said up to a level
  for (std::uint32_t level = 0; level <= last_; ++level) {
    const Outcome one = ask("classify", kPoints, {"--level", std::to_string(level)});
    std::istringstream answers(one.out);
    std::string answer;
    for (std::size_t i = 0; std::getline(answers, answer); ++i) {
      if (done.at(i) || answer == "unknown") continue;
      done[i] = true;
      expected += std::to_string(level) + ' ' + std::to_string(line_of[i]) + ' ' + answer + '\n';
    }
    up_to.push_back(expected);
  }
  EXPECT_EQ(all.out, expected);

  // And it says so while the stream arrives: each level is withheld until the one before has
  // answered.
  const std::string output = folder_.file("answers");
  FakeServer server([&](Socket socket) {
    receive_request(socket);
    std::uint64_t begin = 0;
    for (std::uint32_t level = 0; level <= last_; ++level) {
      const std::uint64_t end = file_.level_bytes()[level].total_bytes;
      socket.send(file_.frames().substr(begin, end - begin));
      EXPECT_TRUE(wait_until([&] { return read_file(output) == up_to[level]; })) << level;
      if (up_to[level] == expected) return;
      begin = end;
    }
  });
  Program shell("/bin/sh",
                {"-c", "exec " SPOCTREE_CLIENT_PROGRAM " classify --follow " + server.url() + " '" +
                           put("q", kPoints) + "' > '" + output + "'"});
  const Outcome outcome = shell.wait();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_file(output), expected);
}

TEST_F(Ask, FollowSaysUnknownOnlyAtTheLevelAskedFor) {
  const Outcome outcome = ask("classify", "-50 40 10\n-50 40 -1\n", {"--follow", "--level", "0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "0 2 out\n0 1 unknown\n");
}

// A file of a part of the levels: its last level answers, and may not know.
TEST_F(Ask, APartOfAModelAnswersAsItsLastLevelDoes) {
  const std::string part = folder_.file("part.spo");
  ASSERT_EQ(run_client({"fetch", piece(), "-o", part, "--levels", "2"}).code, 0);
  const std::string questions = put("questions.txt", kPoints);
  EXPECT_EQ(run_client({"classify", part, questions}).out,
            run_client({"classify", piece(), questions, "--level", "1"}).out);
  EXPECT_NE(run_client({"measure", part, "--json"}).out.find("\"exact\":false"), std::string::npos);
}

}  // namespace
}  // namespace spoctree::test
