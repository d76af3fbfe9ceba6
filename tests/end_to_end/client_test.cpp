// spoctree-client, against the real server and against peers that misbehave.

#include <gtest/gtest.h>

#include <signal.h>
#include <filesystem>

#include <atomic>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/end_to_end/programs.hpp"
#include "tests/end_to_end/sockets.hpp"

namespace spoctree::test {
namespace {

using std::filesystem::exists;

class Client : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    write_file(folder_.file(name), bytes);
    return folder_.file(name);
  }
  std::string piece() const { return put("piece.spo", spo_of("mechanical-piece")); }

  const std::string& spo_ = spo_of("mechanical-piece");
  const SpoFile file_{spo_, "piece"};
  const std::uint32_t last_ = file_.level_count() - 1;
  TemporaryFolder folder_;
};

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

TEST_F(Client, FetchesTheFirstLevelsAndResumesToTheWholeFile) {
  const ServerProcess server({piece()});
  const std::string part = folder_.file("part.spo");
  ASSERT_EQ(run_client({"fetch", server.url("piece"), "-o", part, "--levels", "3"}).code, 0);
  const SpoFile partial(part);
  EXPECT_EQ(partial.level_count(), 3U);
  EXPECT_EQ(partial.frames(), file_.slice(3));

  CountingProxy proxy(server.port());
  const std::string url = "spo://127.0.0.1:" + std::to_string(proxy.port()) + "/piece";
  const Outcome resumed = run_client({"fetch", url, "-o", part, "--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(read_file(part), spo_);
  EXPECT_EQ(proxy.bytes_from_server(), file_.frames().size() - file_.slice(3)->size());
}

TEST_F(Client, ResumingAnotherModelStartsAnew) {
  const ServerProcess server({piece()});
  const ServerProcess other({put("saddle.spo", spo_of("saddle"))});
  const std::string output = folder_.file("out.spo");
  for (const Arguments& extent : {Arguments{}, Arguments{"--levels", "1"}}) {
    Arguments fetch = {"fetch", other.url("saddle"), "-o", output};
    fetch.insert(fetch.end(), extent.begin(), extent.end());
    ASSERT_EQ(run_client(fetch).code, 0);
    const Outcome outcome = run_client({"fetch", server.url("piece"), "-o", output, "--resume"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(read_file(output), spo_);
  }
}

TEST_F(Client, ResumingWhatIsWholeOrDamagedEndsWithTheWholeFile) {
  const ServerProcess server({piece()});
  std::string damaged = spo_;
  damaged[1500] = static_cast<char>(damaged[1500] ^ 4);
  for (const std::string& held : {spo_, damaged, spo_.substr(0, 2000), std::string()}) {
    const std::string output = put("out.spo", held);
    const Outcome outcome = run_client({"fetch", server.url("piece"), "-o", output, "--resume"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(read_file(output), spo_);
  }
}

TEST_F(Client, ResumingDoesNotOverwriteWhatIsNoModel) {
  const ServerProcess server({piece()});
  const std::string output = put("notes.txt", "my notes\n");
  const Outcome outcome = run_client({"fetch", server.url("piece"), "-o", output, "--resume"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("notes.txt: not a .spo file"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_file(output), "my notes\n");
}

TEST_F(Client, WritesThroughASymbolicLink) {
  const std::string target = put("target.spo", "old");
  std::filesystem::create_symlink(target, folder_.file("link.spo"));
  ASSERT_EQ(run_client({"fetch", piece(), "-o", folder_.file("link.spo")}).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.file("link.spo")));
  EXPECT_EQ(read_file(target), spo_);
}

TEST_F(Client, FetchFromAFileCopiesIt) {
  const Outcome outcome = run_client({"fetch", piece(), "-o", folder_.file("copy.spo")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_file(folder_.file("copy.spo")), spo_);
}

TEST_F(Client, LevelsReportsTheBytesOnTheSocket) {
  const ServerProcess server({piece()});
  CountingProxy proxy(server.port());
  const std::string url = "spo://127.0.0.1:" + std::to_string(proxy.port()) + "/piece";
  const Outcome outcome = run_client({"levels", url, "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string expected =
      R"({"model":"piece","total_bytes":)" + std::to_string(proxy.bytes_from_server()) + ",";
  EXPECT_EQ(outcome.out.substr(0, expected.size()), expected);
  EXPECT_EQ(proxy.bytes_from_server(), file_.frames().size());
}

TEST_F(Client, LevelsSaysTheSameOfAServerAndOfAFile) {
  const ServerProcess server({piece()});
  for (const char* format : {"--json", "--csv"}) {
    const Outcome remote = run_client({"levels", server.url("piece"), format});
    const Outcome local = run_client({"levels", folder_.file("piece.spo"), format});
    EXPECT_EQ(remote.out, local.out);
    EXPECT_NE(remote.out, "");
  }
}

TEST_F(Client, AsksForNoMoreLevelsThanItDraws) {
  FakeServer server([&](Socket socket) {
    const GetRequest request = receive_request(socket);
    EXPECT_EQ(request.levels, 3U);
    socket.send(*file_.slice(3));
    socket.receive();  // the client does not wait for more: it leaves
  });
  const Outcome outcome = run_client(
      {"draw", server.url(), "--level", "2", "--format", "json", "-o", folder_.file("2.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(read_file(folder_.file("2.json")).find("\"level\":2"), std::string::npos);
}

TEST_F(Client, DrawsEveryLevelBeforeTheNextOneArrives) {
  const std::string output = folder_.file("drawings");
  const auto drawing = [&](std::uint32_t level) {
    return output + "/level-0" + std::to_string(level) + ".svg";
  };
  FakeServer server([&](Socket socket) {
    receive_request(socket);
    std::uint64_t begin = 0;
    for (std::uint32_t level = 0; level <= last_; ++level) {
      const std::uint64_t end = file_.level_bytes()[level].total_bytes;
      EXPECT_FALSE(exists(drawing(level)));
      socket.send(file_.frames().substr(begin, end - begin));
      // The next level is withheld until the drawing of this one is there.
      EXPECT_TRUE(wait_until([&] { return exists(drawing(level)); })) << "level " << level;
      begin = end;
    }
  });
  const Outcome outcome = run_client({"draw", server.url(), "--level", "all", "-o", output});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(exists(drawing(last_)));
  EXPECT_FALSE(exists(drawing(last_ + 1)));
}

TEST_F(Client, DrawsTheSameFromAServerAndFromAFile) {
  const ServerProcess server({piece()});
  const auto draw = [&](const std::string& source) {
    return run_client({"draw", source, "-o", "-", "--from", "-1,2,0.5", "--level", "3"});
  };
  const Outcome remote = draw(server.url("piece"));
  EXPECT_EQ(remote.code, 0) << remote.err;
  EXPECT_NE(remote.out.find("<svg"), std::string::npos);
  // The title names the model, which has one name in both.
  EXPECT_EQ(remote.out, draw(folder_.file("piece.spo")).out);
}

TEST_F(Client, NamesDrawingsAfterAPattern) {
  const Outcome outcome =
      run_client({"draw", piece(), "--level", "all", "-o", folder_.file("t%d.json")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (std::uint32_t level = 0; level <= last_; ++level) {
    const std::string text =
        read_file(folder_.file(std::string("t").append(std::to_string(level)).append(".json")));
    EXPECT_NE(text.find("\"level\":" + std::to_string(level)), std::string::npos);
  }
}

TEST_F(Client, WritesEveryFormatToStandardOutputAsToAFile) {
  const std::string spo = piece();
  for (const auto& [format, beginning] :
       std::vector<std::pair<std::string, std::string>>{{"svg", "<svg "},
                                                        {"pdf", "%PDF-1.5\n"},
                                                        {"png", "\x89PNG\r\n"},
                                                        {"dxf", "999\npiece, level "},
                                                        {"hpgl", "IN;\nSP"},
                                                        {"json", "{\"model\":\"piece\","}}) {
    const std::string file = folder_.file("drawing." + format);
    ASSERT_EQ(run_client({"draw", spo, "-o", file}).code, 0) << format;
    const Outcome outcome = run_client({"draw", spo, "-o", "-", "--format", format});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, read_file(file)) << format;
    EXPECT_EQ(outcome.out.substr(0, beginning.size()), beginning) << format;
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST_F(Client, DrawsAllLevelsIntoOnePdf) {
  const Outcome outcome =
      run_client({"draw", piece(), "--level", "all", "-o", folder_.file("all.pdf")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string pdf = read_file(folder_.file("all.pdf"));
  EXPECT_EQ(count(pdf, "/Type/Page/"), last_ + 1);
  EXPECT_EQ(count(pdf, "/Dest["), last_ + 1);
  // A name with a place for the level still means a file per level.
  EXPECT_EQ(run_client({"draw", piece(), "--level", "all", "-o", folder_.file("t%d.pdf")}).code, 0);
  EXPECT_EQ(count(read_file(folder_.file("t1.pdf")), "/Type/Page/"), 1U);
}

TEST_F(Client, APdfOfABrokenTransmissionHasTheLevelsThatArrived) {
  FakeServer server([&](Socket socket) {
    receive_request(socket);
    socket.send(file_.frames().substr(0, file_.level_bytes()[1].total_bytes + 10));
  });
  const std::string output = folder_.file("part.pdf");
  const Outcome outcome = run_client({"draw", server.url(), "--level", "all", "-o", output});
  EXPECT_EQ(outcome.code, 4);
  expect_one_complaint(outcome, "spoctree-client");
  EXPECT_EQ(count(read_file(output), "/Type/Page/"), 2U);
}

TEST_F(Client, WritesAPageWithAllLevelsBesideADrawing) {
  const std::string html = folder_.file("piece.html");
  const std::string svg = folder_.file("last.svg");
  const Outcome outcome = run_client({"draw", piece(), "--html", html, "-o", svg});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(count(read_file(html), "<section>"), last_ + 1);
  EXPECT_EQ(read_file(svg), run_client({"draw", piece(), "-o", "-"}).out);
  // The page shows no more levels than were asked for, and calls that whole.
  EXPECT_EQ(run_client({"draw", piece(), "--html", html, "--level", "1"}).code, 0);
  EXPECT_EQ(count(read_file(html), "<section>"), 2U);
  EXPECT_EQ(count(read_file(html), "class=\"note\""), 0U);
}

TEST_F(Client, APageOfABrokenTransmissionSaysSo) {
  for (const int signal : {0, SIGINT}) {
    FakeServer server([&](Socket socket) {
      receive_request(socket);
      socket.send(file_.frames().substr(0, file_.level_bytes()[2].total_bytes + 10));
      if (signal != 0) socket.receive();  // until the client is gone
    });
    TemporaryFolder output;
    Program client(SPOCTREE_CLIENT_PROGRAM,
                   {"draw", server.url(), "--html", output.file("part.html"), "--level", "all",
                    "-o", output.file("level%d.svg")});
    if (signal != 0) {
      ASSERT_TRUE(wait_until([&] { return exists(output.file("level2.svg")); }));
      client.send(signal);
    }
    EXPECT_EQ(client.wait().code, signal == 0 ? 4 : -signal);
    const std::string html = read_file(output.file("part.html"));
    EXPECT_NE(html.find("class=\"note\""), std::string::npos);
    EXPECT_EQ(count(html, "<section>"), 3U);
  }
}

TEST_F(Client, DrawsAFrontViewAtTrueScale) {
  // The piece is 120 wide and 78 high; margins of 5 mm all around.
  const Outcome outcome =
      run_client({"draw", piece(), "--view", "front", "--scale", "1:2", "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"70mm\" "
                             "height=\"49mm\""),
            std::string::npos)
      << outcome.out.substr(0, 200);
}

TEST_F(Client, DrawsSheetsPairsAndPerspectives) {
  const std::string spo = piece();
  const auto json_of = [&](const Arguments& options) {
    Arguments arguments = {"draw", spo, "-o", "-", "--format", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_client(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(count(json_of({"--view", "front,top,iso"}), "\"toward_viewer\""), 3U);
  EXPECT_EQ(count(json_of({"--stereo", "--eye", "0,-300,100"}), "\"eye\""), 2U);
  const std::string anaglyph =
      run_client({"draw", spo, "-o", "-", "--stereo=anaglyph", "--from", "1,-2,1"}).out;
  EXPECT_NE(anaglyph.find("class=\"crease left-eye\""), std::string::npos);
  EXPECT_NE(anaglyph.find("class=\"crease right-eye\""), std::string::npos);
  EXPECT_NE(json_of({"--hidden", "dashed"}).find("\"hidden\":true"), std::string::npos);
  EXPECT_EQ(json_of({"--lines", "silhouette"})
                .find("\"kind\":\"crease\",\"hidden\":false,"
                      "\"step\":false"),
            std::string::npos);
}

// Of a cylinder with N sides, N / 2 are seen, in general: the creases are the rim above them, and
// the N / 2 - 1 edges between them, at which the surface turns by 360 / N degrees.
TEST_F(Client, LeavesOutFacetsUnlessTheyTurnByTwentyDegreesOrTheAngleIsGiven) {
  const auto expect_lines = [&](int sides, const Arguments& options, std::size_t creases) {
    SCOPED_TRACE(sides);
    Arguments arguments = {"draw",     put("round.spo", spo_of("cylinder", sides)),
                           "--from",   "0.55,-0.71,0.44",
                           "-o",       "-",
                           "--format", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_client(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(count(outcome.out, "\"kind\":\"crease\""), creases);
    // Half of each rim, and an edge on either side.
    EXPECT_EQ(count(outcome.out, "\"kind\":\"silhouette\""), static_cast<unsigned>(sides) + 2);
  };
  expect_lines(24, {}, 12);
  expect_lines(24, {"--crease-angle", "0"}, 23);
  expect_lines(24, {"--crease-angle", "15"}, 23);
  expect_lines(24, {"--method", "cells"}, 12);
  expect_lines(18, {}, 17);  // 20 degrees
  expect_lines(12, {}, 11);
  expect_lines(12, {"--crease-angle", "31"}, 6);
}

TEST_F(Client, SaysWhyAPictureIsEmpty) {
  const std::string spo = piece();
  const auto complaint_of = [&](const Arguments& options) {
    Arguments arguments = {"draw", spo, "-o", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_client(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("</svg>"), std::string::npos);
    return outcome.err;
  };
  EXPECT_EQ(complaint_of({"--eye", "0,-300,100"}), "");
  // In the base plate, which is 120 x 70 mm and has no hole there; both eyes are.
  for (const char* stereo : {"--bare", "--stereo"}) {
    const std::string inside = complaint_of({"--eye", "50,40,5", stereo, "--hidden", "dashed"});
    EXPECT_NE(inside.find("the eye is inside the solid"), std::string::npos) << inside;
    EXPECT_EQ(count(inside, "\n"), 1U) << inside;
  }
  EXPECT_NE(complaint_of({"--eye", "50,40,5", "--level", "0"}).find("level 0"), std::string::npos);
  EXPECT_NE(complaint_of({"--eye", "0,-300,0", "--target", "0,-600,0"}).find("empty"),
            std::string::npos);
  // On its upper side, at a corner.
  EXPECT_NE(complaint_of({"--eye", "50,40,14"}).find("exactly on the surface"), std::string::npos);
  // The last level has no steps.
  const std::string steps = complaint_of({"--lines", "step", "--view", "front,top"});
  EXPECT_NE(steps.find("'front' is empty"), std::string::npos) << steps;
  EXPECT_NE(steps.find("'top' is empty"), std::string::npos) << steps;
}

TEST_F(Client, KnowsFormatsByExtensionsInCapitals) {
  const std::string out = folder_.file("OUT.PDF");
  EXPECT_EQ(run_client({"draw", piece(), "-o", out}).code, 0);
  EXPECT_EQ(read_file(out).substr(0, 5), "%PDF-");
}

TEST_F(Client, WritesNothingOverTheModelItself) {
  const std::string model = piece();
  const std::string link = folder_.file("the-same.spo");
  std::filesystem::create_symlink(model, link);
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"draw", model, "-o", model, "--format", "svg"},
           {"draw", link, "-o", folder_.file("a.svg"), "--html", model},
           {"draw", model, "--html", link},
           {"rebuild", model, "-o", link}}) {
    const Outcome outcome = run_client(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("over the model itself"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(read_file(model), spo_);
}

TEST_F(Client, DrawsATinyScaleIntoDxf) {
  EXPECT_EQ(run_client({"draw", piece(), "-o", "-", "--format", "dxf", "--scale", "1e-9"}).code, 0);
}

TEST_F(Client, RebuildsAMeshThatTheServerReads) {
  const Outcome outcome = run_client({"rebuild", piece(), "-o", folder_.file("rebuilt.off")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Outcome info = run_server({"info", folder_.file("rebuilt.off"), "--json"});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_NE(info.out.find("\"planes\":43"), std::string::npos) << info.out;
}

// What a client sees of a server that is killed: the end of the stream, or a reset.
TEST_F(Client, AnInterruptedTransmissionIsANetworkErrorAndLeavesNoFile) {
  for (const bool is_reset : {false, true}) {
    FakeServer server([&](Socket socket) {
      receive_request(socket);
      socket.send(file_.frames().substr(0, file_.frames().size() / 2));
      if (is_reset) socket.reset();
    });
    TemporaryFolder output;
    const Outcome outcome = run_client({"fetch", server.url(), "-o", output.file("out.spo")});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    expect_one_complaint(outcome, "spoctree-client");
    EXPECT_EQ(output.entries(), std::vector<std::string>{});
  }
}

TEST_F(Client, ResumeKeepsTheWholeLevelsOfAnInterruptedTransmission) {
  const std::uint64_t cut = file_.level_bytes()[2].total_bytes + 100;
  TemporaryFolder output;
  const std::string path = output.file("out.spo");
  {
    FakeServer server([&](Socket socket) {
      receive_request(socket);
      socket.send(file_.frames().substr(0, cut));
    });
    const Outcome outcome = run_client({"fetch", server.url(), "-o", path, "--resume"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_EQ(SpoFile(path).level_count(), 3U);
  }
  FakeServer server([&](Socket socket) {
    const GetRequest request = receive_request(socket);
    EXPECT_EQ(request.held, SpoFile(path).resume_point());
    socket.send(file_.frames().substr(request.held.byte));
  });
  EXPECT_EQ(run_client({"fetch", server.url(), "-o", path, "--resume"}).code, 0);
  EXPECT_EQ(read_file(path), spo_);
}

TEST_F(Client, NoSignalLeavesATemporaryFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    TemporaryFolder output;
    std::atomic<bool> is_under_way = false;
    FakeServer server([&](Socket socket) {
      receive_request(socket);
      socket.send(file_.frames().substr(0, 1000));
      is_under_way = true;  // the output was opened before the request was sent
      socket.receive();     // until the client is gone
    });
    Program client(SPOCTREE_CLIENT_PROGRAM, {"fetch", server.url(), "-o", output.file("out.spo")});
    ASSERT_TRUE(wait_until([&] { return is_under_way.load(); }));
    client.send(signal);
    EXPECT_EQ(client.wait().code, -signal);
    EXPECT_EQ(output.entries(), std::vector<std::string>{});
  }
}

TEST_F(Client, AServerThatSpeaksNonsenseIsBadInput) {
  std::string damaged(file_.frames());
  damaged[1500] = static_cast<char>(damaged[1500] ^ 4);
  for (const std::string& answer : {std::string("HTTP/1.1 400 Bad Request\r\n\r\n"), damaged}) {
    FakeServer server([&](Socket socket) {
      receive_request(socket);
      socket.send(answer);
    });
    const Outcome outcome =
        run_client({"rebuild", server.url(), "-o", folder_.file("rebuilt.off")});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    expect_one_complaint(outcome, "spoctree-client");
    EXPECT_FALSE(exists(folder_.file("rebuilt.off")));
  }
}

TEST_F(Client, ABusyServerIsANetworkError) {
  FakeServer server([&](Socket socket) {
    receive_request(socket);
    socket.send(seal_error({ErrorCode::Busy, "come back later"}));
  });
  const Outcome outcome = run_client({"levels", server.url()});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("come back later"), std::string::npos) << outcome.err;
}

TEST_F(Client, ALevelBeyondTheLastIsWrongUsageThatNamesTheLast) {
  const ServerProcess server({piece()});
  const std::string output = folder_.file("out");
  for (const std::string& source : {server.url("piece"), folder_.file("piece.spo")}) {
    for (const Arguments& arguments :
         {Arguments{"draw", source, "-o", output, "--level", std::to_string(last_ + 1)},
          Arguments{"rebuild", source, "-o", output, "--level", "30"},
          Arguments{"fetch", source, "-o", output, "--levels", std::to_string(last_ + 2)}}) {
      const Outcome outcome = run_client(arguments);
      EXPECT_EQ(outcome.code, 2);
      expect_one_complaint(outcome, "spoctree-client");
      EXPECT_NE(outcome.err.find("level " + std::to_string(last_)), std::string::npos)
          << outcome.err;
      EXPECT_FALSE(exists(output));
    }
  }
}

TEST_F(Client, HasAnExitCodeForEveryFailure) {
  const std::string spo = piece();
  const std::string out = folder_.file("out.svg");
  std::string damaged = spo_;
  damaged[2000] = static_cast<char>(damaged[2000] ^ 64);
  struct Case {
    Arguments arguments;
    int code;
  };
  for (const Case& c : std::vector<Case>{
           {{}, 2},
           {{"draw", spo}, 2},
           {{"draw", spo, "-o", out, "--level", "two"}, 2},
           {{"draw", spo, "-o", out, "--level", "all"}, 2},
           {{"draw", spo, "-o", "-", "--level", "all"}, 2},
           {{"draw", spo, "-o", out, "--from", "1,2"}, 2},
           {{"draw", spo, "-o", out, "--from", "0,0,0"}, 2},
           {{"draw", spo, "-o", out, "--crease-angle", "200"}, 2},
           {{"draw", spo, "-o", out, "--format", "bmp"}, 2},
           {{"draw", spo, "-o", folder_.file("out.jpg")}, 2},
           {{"draw", spo, "--html", out, "--format", "svg"}, 2},
           {{"draw", spo, "-o", ""}, 2},
           {{"draw", spo, "-o", out, "--view", ""}, 2},
           {{"draw", spo, "-o", out, "--from", ""}, 2},
           {{"draw", spo, "-o", out, "--level", ""}, 2},
           {{"draw", spo, "-o", out, "--view", "front,front"}, 2},
           {{"draw", spo, "-o", out, "--view", "front,iso", "--projection", "third"}, 2},
           {{"draw", spo, "-o", out, "--view", "front,top", "--projection", "2"}, 2},
           {{"draw", spo, "-o", out, "--scale", "1e-9"}, 2},
           {{"draw", spo, "-o", out, "--page", "10.01x10.01"}, 2},
           {{"draw", spo, "-o", out, "--lines", "silhouette", "--crease-angle", "9"}, 2},
           {{"draw", spo, "-o", out, "--crease-angle", "nan"}, 2},
           {{"draw", spo, "-o", out, "--html", out}, 2},
           {{"draw", spo, "-o", out, "--view", "front,side"}, 2},
           {{"draw", spo, "-o", out, "--view", "front", "--from", "1,0,0"}, 2},
           {{"draw", spo, "-o", out, "--from", "1,0,0", "--eye", "9,9,9"}, 2},
           {{"draw", spo, "-o", out, "--target", "1,0,0"}, 2},
           {{"draw", spo, "-o", out, "--fov", "60"}, 2},
           {{"draw", spo, "-o", out, "--eye", "0,-300,inf"}, 2},
           {{"draw", spo, "-o", out, "--eye", "0,-300,0", "--fov", "wide"}, 2},
           {{"draw", spo, "-o", out, "--stereo=cross"}, 2},
           {{"draw", spo, "-o", out, "--stereo", "--view", "top,iso"}, 2},
           {{"draw", spo, "-o", out, "--stereo", "--eye-separation", "0"}, 2},
           {{"draw", spo, "-o", out, "--eye-separation", "0.1"}, 2},
           {{"draw", spo, "-o", out, "--scale", "1:0"}, 2},
           {{"draw", spo, "-o", out, "--scale", "100", "--page", "A4"}, 2},
           {{"draw", spo, "-o", out, "--page", "letter"}, 2},
           {{"draw", spo, "-o", out, "--dpi", "100"}, 2},
           {{"draw", spo, "-o", out, "--lines", "silhouette,"}, 2},
           {{"draw", spo, "-o", out, "--hidden", "grey"}, 2},
           {{"draw", spo, "-o", out, "--colour-by", "level"}, 2},
           {{"draw", spo, "-o", "-", "--format", "json", "--scale", "2"}, 2},
           {{"draw", spo, "-o", "-", "--format", "png", "--dpi", "5"}, 2},
           {{"levels", spo, "--json", "--csv"}, 2},
           {{"levels", spo, "--rate", "0"}, 2},
           {{"levels", "http://127.0.0.1/x"}, 2},
           {{"levels", "spo://127.0.0.1:70000/x"}, 2},
           {{"list", spo}, 2},
           {{"fetch", spo, "-o", "-"}, 2},
           {{"levels", folder_.file("absent.spo")}, 3},
           {{"levels", put("damaged.spo", damaged)}, 3},
           {{"levels", put("mesh.off", off_of("cube"))}, 3},
           {{"draw", spo, "-o", folder_.file("no/such/folder.svg")}, 3},
           {{"list", "spo://127.0.0.1:1"}, 4},
           {{"levels", "spo://127.0.0.1:1/x"}, 4}}) {
    const Outcome outcome = run_client(c.arguments);
    std::string words;
    for (const std::string& word : c.arguments) words += word + " ";
    EXPECT_EQ(outcome.code, c.code) << words << outcome.err;
    expect_one_complaint(outcome, "spoctree-client");
    EXPECT_FALSE(exists(out)) << words;
  }
}

TEST_F(Client, ARateMakesATransmissionLast) {
  // A lower bound only: nothing can make it faster, anything can make it slower.
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = run_client({"levels", piece(), "--rate", "6000"});
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(passed.count(), static_cast<double>(file_.frames().size()) / 6000 - 0.1);
}

}  // namespace
}  // namespace spoctree::test
