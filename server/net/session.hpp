// One client's connection: requests in, frames out, and a watch that nothing waits for ever.
// For the sources of server/net only: this header brings Asio.
#pragma once

#include <utility>  // missing in asio/awaitable.hpp of Boost 1.74

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/wire/frame.hpp"
#include "common/wire/messages.hpp"
#include "server/net/model_store.hpp"
#include "server/net/server.hpp"

namespace spoctree {

/// What all sessions of a server share.
struct Service {
  const ModelStore& store;
  ServerLimits limits;
  std::string catalog;  ///< the answer to `list`
};

/// g++ 12 destroys class objects that are temporaries of a co_await expression twice: what is
/// awaited gets references to named objects here, or trivial values.
///
/// Answers requests one after the other until the client closes the connection, breaks the
/// protocol, or neither sends nor takes a byte for too long.
class Session : public std::enable_shared_from_this<Session> {
 public:
  /// `service` must outlive this.
  Session(boost::asio::ip::tcp::socket socket, const Service& service);

  /// Serves the client, or with `refuse` only tells it to come back later. `on_end` is called once,
  /// when the connection is closed.
  void start(bool refuse, std::function<void()> on_end);
  /// Closes the connection.
  void stop();

 private:
  using Clock = std::chrono::steady_clock;

  static boost::asio::awaitable<void> serve(std::shared_ptr<Session> self, bool refuse);
  static boost::asio::awaitable<void> watch(std::shared_ptr<Session> self);

  boost::asio::awaitable<void> answer_requests();
  /// The next request's frame; nothing when the connection is closed.
  boost::asio::awaitable<std::optional<FrameView>> read_request();
  /// False when the connection is to be closed.
  boost::asio::awaitable<bool> answer(FrameView frame);
  boost::asio::awaitable<bool> send_model(const GetRequest& request);
  boost::asio::awaitable<bool> send_error(const ErrorMessage& error);
  boost::asio::awaitable<bool> write(std::string_view bytes);
  /// Ends the conversation so that the client can read why although it may still be talking.
  boost::asio::awaitable<void> say_farewell(const ErrorMessage& farewell);

  void expect_progress_within(std::chrono::milliseconds time);
  std::size_t unsent_bytes();

  boost::asio::ip::tcp::socket socket_;
  boost::asio::steady_timer watch_timer_;
  Clock::time_point deadline_ = Clock::time_point::max();
  std::size_t last_unsent_bytes_ = 0;
  bool is_patient_ = true;  ///< while bytes leave the send buffer, the deadline is put off
  bool is_over_ = false;

  const Service& service_;
  FrameReader requests_{kMaxRequestPayloadBytes};
  std::string client_;  ///< its address, for the log
};

}  // namespace spoctree
