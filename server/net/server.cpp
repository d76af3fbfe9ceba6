#include "server/net/server.hpp"

#include <utility>  // missing in asio/awaitable.hpp of Boost 1.74

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <set>

#include "common/base/errors.hpp"
#include "server/net/endpoint_text.hpp"
#include "server/net/log.hpp"
#include "server/net/session.hpp"

namespace spoctree {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

// After a failed accept, as when there are no file descriptors left.
constexpr std::chrono::milliseconds kAcceptPause{100};

tcp::acceptor listen_on(asio::io_context& io, const Address& address) {
  const auto fail = [&](const error_code& error) {
    throw NetworkError("cannot listen on " + to_text(address) + ": " + error.message());
  };
  error_code error;
  tcp::resolver resolver(io);
  const auto found =
      resolver.resolve(address.host, std::to_string(address.port), tcp::resolver::passive, error);
  if (error) fail(error);
  for (const auto& entry : found) {
    tcp::acceptor acceptor(io);
    acceptor.open(entry.endpoint().protocol(), error);
    // A server that was just ended leaves its connections behind for a while: no reason to wait.
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(entry.endpoint(), error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (!error) return acceptor;
  }
  fail(error ? error : asio::error::host_not_found);
  throw;  // not reached
}

}  // namespace

struct Server::Impl {
  Impl(const ModelStore& store, const Address& address, const ServerLimits& limits)
      : service{store, limits, seal_catalog(store.catalog())},
        acceptor(listen_on(io, address)),
        pause(io),
        signals(io, SIGINT, SIGTERM) {}

  void welcome(tcp::socket socket) {
    const std::size_t most = service.limits.max_connections;
    if (sessions.size() >= most + kMaxRefusals) return;  // closes the socket
    const bool refuse = sessions.size() >= most;
    const auto session = std::make_shared<Session>(std::move(socket), service);
    sessions.insert(session);
    session->start(refuse, [this, gone = session.get()] { forget(gone); });
  }

  void forget(const Session* session) {
    std::erase_if(sessions, [=](const auto& other) { return other.get() == session; });
  }

  void close() {
    error_code ignored;
    acceptor.close(ignored);
    pause.cancel();
    signals.cancel(ignored);
    signals.clear(ignored);  // a second signal ends the program the usual way
    for (const auto& session : sessions) session->stop();
  }

  static asio::awaitable<void> accept_clients(Impl& self) {
    while (self.acceptor.is_open()) {
      error_code error;
      tcp::socket socket =
          co_await self.acceptor.async_accept(asio::redirect_error(asio::use_awaitable, error));
      if (!self.acceptor.is_open()) break;
      if (!error) {
        self.welcome(std::move(socket));
        continue;
      }
      log_warning("cannot accept a connection: " + error.message());
      self.pause.expires_after(kAcceptPause);
      co_await self.pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
    }
  }

  asio::io_context io{1};
  Service service;
  tcp::acceptor acceptor;
  asio::steady_timer pause;
  asio::signal_set signals;
  std::set<std::shared_ptr<Session>> sessions;
};

Server::Server(const ModelStore& store, const Address& address, const ServerLimits& limits)
    : impl_(std::make_unique<Impl>(store, address, limits)) {
  impl_->signals.async_wait([this](const error_code& error, int) {
    if (!error) impl_->close();
  });
  asio::co_spawn(impl_->io, Impl::accept_clients(*impl_), asio::detached);
}

Server::~Server() = default;

Address Server::address() const { return address_of(impl_->acceptor.local_endpoint()); }

void Server::run() { impl_->io.run(); }

void Server::stop() {
  asio::post(impl_->io, [this] { impl_->close(); });
}

}  // namespace spoctree
