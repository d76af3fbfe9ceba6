// spoctree-server serve, over real sockets.

#include <gtest/gtest.h>
#include <signal.h>

#include <thread>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"
#include "tests/end_to_end/programs.hpp"
#include "tests/end_to_end/sockets.hpp"

namespace spoctree::test {
namespace {

using std::filesystem::exists;

class Serve : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    write_file(folder_.file(name), bytes);
    return folder_.file(name);
  }
  std::string piece() const { return put("piece.spo", spo_of("mechanical-piece")); }

  /// The one frame that a server sends before it closes the connection, as an error.
  static ErrorMessage last_words(const Socket& socket) {
    const std::string bytes = socket.receive_all();
    const auto frame = read_frame(bytes, 0, 0);
    EXPECT_TRUE(frame && frame->bytes.size() == bytes.size()) << bytes.size() << " bytes";
    return frame ? open_error(*frame) : ErrorMessage{};
  }

  TemporaryFolder folder_;
};

TEST_F(Serve, SendsTheFileByteForByte) {
  const ServerProcess server({piece()});
  const Outcome outcome = run_client({"fetch", server.url("piece"), "-o", folder_.file("got.spo")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_file(folder_.file("got.spo")), spo_of("mechanical-piece"));
}

TEST_F(Serve, BuildsMeshesFirstAndNamesModelsAfterTheirFiles) {
  const ServerProcess server({put("saddle.off", off_of("saddle")), piece(), "--leaf-planes", "0"});
  const Outcome list = run_client({"list", "spo://" + server.address()});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_NE(list.out.find("saddle"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("piece"), std::string::npos) << list.out;
  EXPECT_EQ(run_client({"fetch", server.url("saddle"), "-o", folder_.file("got.spo")}).code, 0);
  EXPECT_EQ(read_file(folder_.file("got.spo")), spo_of("saddle"));
}

TEST_F(Serve, RepairsMeshesIfToldToAndSaysSo) {
  std::string open = off_of("cube");  // "OFF", the counts, eight points, six faces
  open.erase(open.rfind("4 "));
  open.replace(open.find("8 6"), 3, "8 5");
  const std::string mesh = put("box.off", open);
  EXPECT_EQ(run_server({"build", mesh, "-o", folder_.file("no.spo")}).code, 3);
  const Outcome built = run_server({"build", "--repair", mesh, "-o", folder_.file("built.spo")});
  EXPECT_EQ(built.code, 0) << built.err;
  EXPECT_NE(built.out.find("\nfilled: 1 hole with 2 faces, at ("), std::string::npos) << built.out;
  ServerProcess server({mesh, "--repair"});
  EXPECT_EQ(run_client({"fetch", server.url("box"), "-o", folder_.file("got.spo")}).code, 0);
  EXPECT_EQ(read_file(folder_.file("got.spo")), read_file(folder_.file("built.spo")));
  server.program().send(SIGTERM);
  const Outcome served = server.program().wait();
  EXPECT_NE(served.err.find("filled: 1 hole with 2 faces, at ("), std::string::npos) << served.err;
}

TEST_F(Serve, ServesWhatIsInAFolderAndLeavesOutWhatIsNoModel) {
  piece();
  put("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  put("notes.txt", "not a model");
  ServerProcess server({folder_.path().string()});
  const Outcome list = run_client({"list", "spo://" + server.address()});
  EXPECT_NE(list.out.find("piece"), std::string::npos) << list.out;
  EXPECT_EQ(list.out.find("open"), std::string::npos) << list.out;
  server.program().send(SIGTERM);
  EXPECT_NE(server.program().wait().err.find("open.off"), std::string::npos);
}

TEST_F(Serve, RefusesTwoModelsOfOneName) {
  const std::string mesh = put("piece.off", off_of("mechanical-piece"));
  const Outcome outcome = run_server({"serve", piece(), mesh, "--listen", "127.0.0.1:0"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("piece.spo"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("piece.off"), std::string::npos) << outcome.err;
}

TEST_F(Serve, ListensOnIPv6) {
  const Outcome probe = [&] {
    Program server(SPOCTREE_SERVER_PROGRAM, {"serve", piece(), "--listen", "[::1]:0"});
    server.first_line();
    server.send(SIGTERM);
    return server.wait();
  }();
  if (probe.code == 4) GTEST_SKIP() << "no IPv6 here: " << probe.err;
  const ServerProcess server({piece()}, "[::1]:0");
  EXPECT_EQ(server.address().find("[::1]:"), 0U) << server.address();
  EXPECT_EQ(run_client({"levels", server.url("piece")}).code, 0);
}

TEST_F(Serve, OneModelNeedsNoName) {
  const ServerProcess server({piece()});
  EXPECT_EQ(run_client({"levels", "spo://" + server.address()}).code, 0);
}

TEST_F(Serve, AnUnknownModelIsAnErrorThatListsWhatThereIs) {
  const ServerProcess server({piece(), put("cube.spo", spo_of("cube"))});
  const Outcome outcome = run_client({"levels", server.url("peace")});
  EXPECT_EQ(outcome.code, 3);
  expect_one_complaint(outcome, "spoctree-client");
  for (const char* name : {"peace", "piece", "cube"})
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
}

TEST_F(Serve, AnswersOneRequestAfterTheOtherAlsoAfterAnError) {
  const ServerProcess server({piece()});
  const Socket socket = Socket::connect_to(server.port());
  // All at once: the server reads on where it stopped.
  socket.send(seal_request(GetRequest{"piece", 1, {}}) + seal_request(GetRequest{"other", 0, {}}) +
              seal_request(GetRequest{"piece", 0, {8, 0}}) + seal_request(ListRequest{}) +
              seal_request(GetRequest{"piece", 0, {}}));
  socket.end_sending();
  const std::string answers = socket.receive_all();
  FrameReader frames;
  frames.feed(answers);
  std::vector<FrameType> types;
  while (const auto frame = frames.next()) types.push_back(frame->type);
  using enum FrameType;
  const std::vector<FrameType> expected = {Header,  Chunk, LevelEnd,  // level 0
                                           Error,                     // no such model
                                           Error,    // byte 8 is inside the first frame
                                           Catalog,  //
                                           Header,  Chunk, LevelEnd, Chunk, LevelEnd};  // and so on
  ASSERT_GT(types.size(), expected.size());
  types.resize(expected.size());
  EXPECT_EQ(types, expected);
  EXPECT_TRUE(answers.ends_with(SpoFile(folder_.file("piece.spo")).frames()));
}

TEST_F(Serve, ASlowClientDelaysNobody) {
  const std::string spo = spo_of("sphere", 48);
  const ServerProcess server({put("sphere.spo", spo)});
  // This client asks for far more than the system buffers, and takes nothing.
  const Socket slow = Socket::connect_to(server.port());
  const std::size_t times = 1 + (std::size_t{32} << 20) / spo.size();
  std::string requests;
  for (std::size_t i = 0; i < times; ++i) requests += seal_request(GetRequest{"sphere", 0, {}});
  std::thread asking([&] { slow.send(requests); });
  for (const char* name : {"first.spo", "second.spo"}) {
    EXPECT_EQ(run_client({"fetch", server.url("sphere"), "-o", folder_.file(name)}).code, 0);
    EXPECT_EQ(read_file(folder_.file(name)), spo);
  }
  // It gets everything when it wants to.
  const std::string first = slow.receive_exactly(spo.size() / 2);
  EXPECT_EQ(first, spo.substr(0, spo.size() / 2));
  std::size_t total = first.size();
  std::thread ending([&] {
    asking.join();
    slow.end_sending();
  });
  for (std::string part = slow.receive(); !part.empty(); part = slow.receive())
    total += part.size();
  ending.join();
  EXPECT_EQ(total, times * SpoFile(folder_.file("sphere.spo")).frames().size());
}

TEST_F(Serve, GarbageIsAnsweredWithAnErrorAndDoesNoHarm) {
  const ServerProcess server({piece()});
  std::string noise;
  for (unsigned i = 0, x = 1; i < 50'000; ++i) {
    x = x * 1664525 + 1013904223;
    noise += static_cast<char>(x >> 24);
  }
  const std::string request = seal_request(GetRequest{"piece", 0, {}});
  std::string flipped = request;
  flipped[40] = static_cast<char>(flipped[40] ^ 1);
  const std::string too_long = seal_frame(FrameType::Request, std::string(2048, '\0'));
  const std::string other_type = seal_frame(FrameType::Catalog, request.substr(16));
  for (const std::string& garbage :
       {noise, std::string("GET / HTTP/1.1\r\n\r\n"), flipped, too_long, other_type,
        seal_frame(FrameType::Request, ""), std::string(4096, '\0')}) {
    const Socket socket = Socket::connect_to(server.port());
    socket.send(garbage);
    const ErrorMessage error = last_words(socket);
    EXPECT_EQ(error.code, ErrorCode::BadRequest) << error.text;
    EXPECT_NE(error.text, "");
  }
  for (const std::string& broken_off : {std::string(), request.substr(0, 5), request}) {
    Socket socket = Socket::connect_to(server.port());
    socket.send(broken_off);
    socket.reset();
  }
  EXPECT_EQ(run_client({"levels", server.url("piece")}).code, 0);
}

TEST_F(Serve, ASignalEndsItWithCodeZeroAndClosesConnections) {
  for (const int signal : {SIGTERM, SIGINT}) {
    ServerProcess server({piece()});
    const Socket silent = Socket::connect_to(server.port());
    const Socket served = Socket::connect_to(server.port());
    served.send(seal_request(ListRequest{}));
    EXPECT_FALSE(served.receive().empty());
    server.program().send(signal);
    const Outcome outcome = server.program().wait();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(silent.receive(), "");
    EXPECT_EQ(served.receive(), "");
  }
}

TEST_F(Serve, HasAnExitCodeForEveryFailure) {
  const std::string spo = piece();
  const std::string cut = put("cut.spo", spo_of("cube").substr(0, 300));
  const ServerProcess other({spo});
  struct Case {
    Arguments arguments;
    int code;
  };
  for (const Case& c : std::vector<Case>{
           {{}, 2},
           {{"serve"}, 2},
           {{"serve", spo, "--listen", "nonsense:port"}, 2},
           {{"serve", spo, "--listen", "1:2:3"}, 2},
           {{"serve", spo, "--no-such-option"}, 2},
           {{"serve", folder_.file("absent.spo")}, 3},
           {{"serve", cut}, 3},
           {{"serve", spo, "--listen", other.address()}, 4},
           {{"build", spo}, 2},
           {{"build", folder_.file("absent.off"), "-o", folder_.file("x.spo")}, 3},
           {{"build", put("cube.off", off_of("cube")), "-o", folder_.file("no/such/x.spo")}, 3},
           {{"build", folder_.file("cube.off"), "-o", folder_.file("x.spo"), "--max-depth", "31"},
            2},
           {{"info", cut}, 3},
           {{"info", put("empty.stl", "")}, 3}}) {
    const Outcome outcome = run_server(c.arguments);
    std::string words;
    for (const std::string& word : c.arguments) words += word + " ";
    EXPECT_EQ(outcome.code, c.code) << words << outcome.err;
    expect_one_complaint(outcome, "spoctree-server");
    EXPECT_FALSE(exists(folder_.file("x.spo"))) << words;
  }
}

TEST_F(Serve, BuildSaysWhatItBuiltAndInfoRepeatsIt) {
  const std::string mesh = put("piece.off", off_of("mechanical-piece"));
  const Outcome build = run_server({"build", mesh, "-o", folder_.file("piece.spo")});
  EXPECT_EQ(build.code, 0) << build.err;
  EXPECT_EQ(build.err, "") << "no progress where there is no terminal";
  EXPECT_NE(build.out.find("43 planes"), std::string::npos) << build.out;
  const Outcome info = run_server({"info", folder_.file("piece.spo"), "--json"});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_NE(info.out.find("\"plane_count\":43"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("\"source_name\":\"piece.off\""), std::string::npos) << info.out;
  const Outcome of_mesh = run_server({"info", mesh, "--json"});
  EXPECT_EQ(of_mesh.code, 0) << of_mesh.err;
  EXPECT_NE(of_mesh.out.find("\"planes\":43"), std::string::npos) << of_mesh.out;
}

TEST_F(Serve, BuildWritesNoTwoThingsIntoOneFile) {
  const std::string mesh = put("cube.off", off_of("cube"));
  const std::string other_name = folder_.file("same.off");
  std::filesystem::create_hard_link(mesh, other_name);
  const std::string spo = folder_.file("x.spo");
  for (const Arguments& arguments :
       std::vector<Arguments>{{"build", mesh, "-o", mesh},
                              {"build", mesh, "-o", other_name},
                              {"build", mesh, "-o", spo, "--save-solid", mesh},
                              {"build", mesh, "-o", spo, "--save-solid", spo},
                              {"build", mesh, "-o", "-", "--save-solid", "-"}}) {
    const Outcome outcome = run_server(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    expect_one_complaint(outcome, "spoctree-server");
    EXPECT_EQ(read_file(mesh), off_of("cube"));
    EXPECT_FALSE(exists(spo));
  }
}

TEST_F(Serve, BuildsTheSameBytesAgain) {
  const std::string mesh = put("saddle.off", off_of("saddle"));
  EXPECT_EQ(run_server({"build", mesh, "-o", folder_.file("again.spo"), "--leaf-planes", "0"}).code,
            0);
  EXPECT_EQ(read_file(folder_.file("again.spo")), spo_of("saddle"));
}

TEST_F(Serve, BuildsTheSameBytesWithAnyNumberOfThreads) {
  const std::string mesh = put("sphere.off", off_of("sphere", 40));
  for (const char* const threads : {"1", "2", "3", "8"}) {
    const std::string output = folder_.file(std::string("threads-") + threads + ".spo");
    const Outcome outcome =
        run_server({"build", mesh, "-o", output, "--threads", threads, "--leaf-planes", "0"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(read_file(output) == spo_of("sphere", 40)) << threads;
  }
  for (const char* const threads : {"0", "-1", "x", "1025"}) {
    EXPECT_EQ(run_server({"build", mesh, "-o", "-", "--threads", threads}).code, 2) << threads;
  }
}

}  // namespace
}  // namespace spoctree::test
