// Nothing waits for ever: the server and the connection in this process, with short limits.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "client/net/connection.hpp"
#include "client/source/level_stream.hpp"
#include "common/base/errors.hpp"
#include "common/wire/messages.hpp"
#include "server/net/model_store.hpp"
#include "server/net/server.hpp"
#include "tests/end_to_end/programs.hpp"
#include "tests/end_to_end/sockets.hpp"

namespace spoctree::test {
namespace {

using std::chrono::milliseconds;

class Limits : public testing::Test {
 protected:
  void serve(const ServerLimits& limits) {
    store_.add_bytes("piece", "piece.spo", spo_of("mechanical-piece"));
    server_.emplace(store_, Address{"127.0.0.1", 0}, limits);
    thread_ = std::thread([this] { server_->run(); });
  }
  ~Limits() override {
    if (!server_) return;
    server_->stop();
    thread_.join();
  }
  Socket connect() const { return Socket::connect_to(server_->address().port); }

  ModelStore store_;
  std::optional<Server> server_;
  std::thread thread_;
};

TEST_F(Limits, ASilentClientIsDropped) {
  serve({.idle_timeout = milliseconds(50)});
  EXPECT_EQ(connect().receive(), "");
}

TEST_F(Limits, AClientThatNeverEndsItsRequestIsDropped) {
  serve({.request_timeout = milliseconds(50)});
  const Socket socket = connect();
  socket.send(seal_request(ListRequest{}).substr(0, 20));
  EXPECT_EQ(socket.receive(), "");
}

TEST_F(Limits, AClientThatTakesNothingIsDropped) {
  serve({.idle_timeout = milliseconds(200)});
  const Socket socket = connect();
  // Requests until the server no longer reads them because nobody takes the answers; then it gives
  // up, and sending fails.
  std::string requests;
  for (int i = 0; i < 1000; ++i) requests += seal_request(GetRequest{"piece", 0, {}});
  EXPECT_TRUE(wait_until([&] { return !socket.send(requests); }));
}

TEST_F(Limits, OneConnectionTooManyIsToldSo) {
  serve({.max_connections = 1});
  const Socket first = connect();
  first.send(seal_request(ListRequest{}));
  ASSERT_NE(first.receive(), "");
  const std::string answer = connect().receive_all();
  const auto frame = read_frame(answer, 0, 0);
  ASSERT_TRUE(frame);
  EXPECT_EQ(open_error(*frame).code, ErrorCode::Busy);
  // The first one is served on.
  first.send(seal_request(ListRequest{}));
  EXPECT_NE(first.receive(), "");
}

TEST_F(Limits, AClientGivesUpOnASilentServer) {
  Listener silent;
  Connection connection(Address{"127.0.0.1", silent.port()}, {.idle_timeout = milliseconds(50)});
  char byte;
  EXPECT_THROW(connection.read_some({&byte, 1}), NetworkError);
}

TEST_F(Limits, AClientGivesUpOnAServerThatTakesNothing) {
  Listener silent;
  Connection connection(Address{"127.0.0.1", silent.port()}, {.idle_timeout = milliseconds(50)});
  const std::string much(std::size_t{64} << 20, 'x');
  EXPECT_THROW(connection.write(much), NetworkError);
}

TEST_F(Limits, ACatalogThatDoesNotComeIsGivenUp) {
  FakeServer server([&](Socket socket) { socket.receive(); });
  const SourceName source = parse_source(server.url());
  EXPECT_THROW(fetch_catalog(std::get<RemoteModel>(source).server, milliseconds(50)), NetworkError);
}

TEST_F(Limits, AHostThatDoesNotExistIsANetworkError) {
  EXPECT_THROW(Connection(Address{"no-such-host.invalid", 1}), NetworkError);
}

TEST_F(Limits, AStreamGoesOnAfterALongPause) {
  const std::string& spo = spo_of("mechanical-piece");
  const SpoFile file(spo, "piece");
  const std::uint64_t level_0 = file.level_bytes()[0].total_bytes;
  // The first connection ends in the middle of level 1, the second one gets what is missing.
  int connection = 0;
  FakeServer server(
      [&](Socket socket) {
        FrameReader frames;
        while (!frames.next()) frames.feed(socket.receive());
        socket.send(connection++ == 0 ? file.frames().substr(0, level_0 + 40)
                                      : file.frames().substr(level_0));
      },
      2);
  StreamOptions options;
  options.source = server.url();
  options.patience = milliseconds(-1);  // any pause is a long one
  LevelStream stream(options);
  std::uint32_t levels = 0;
  while (stream.next_level()) ++levels;
  EXPECT_EQ(levels, file.level_count());
  EXPECT_EQ(stream.decoder().resume_point(), file.resume_point());
}

}  // namespace
}  // namespace spoctree::test
