#include "client/net/connection.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <optional>

#include "common/base/errors.hpp"
#include "common/base/interruption.hpp"

namespace spoctree {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {
// How long a noted signal may go unnoticed here.
constexpr std::chrono::milliseconds kSignalLatency{50};
}  // namespace

struct Connection::Impl {
  Impl(const Address& address, const ConnectionOptions& wanted)
      : options(wanted), name(to_text(address)), socket(io) {}

  [[noreturn]] void fail(const char* what, const error_code& error) const {
    if (Interruption::is_requested()) throw NetworkError(name + ": interrupted");
    throw NetworkError(name + ": " + what + ": " + error.message());
  }

  /// Lets the operation that was just started run until it sets `result`, `deadline` comes or a
  /// signal is noted. False when it had to be broken off.
  template <typename Cancel>
  bool wait(const std::optional<error_code>& result, std::chrono::steady_clock::time_point deadline,
            Cancel&& cancel) {
    io.restart();
    while (!result && !Interruption::is_requested()) {
      const auto now = std::chrono::steady_clock::now();
      if (now >= deadline) break;
      io.run_one_until(std::min(deadline, now + kSignalLatency));
    }
    if (result) return true;
    cancel();
    io.run();  // the handler refers to the caller's variables: let it come home
    return false;
  }

  bool wait(const std::optional<error_code>& result) {
    return wait(result, std::chrono::steady_clock::now() + options.idle_timeout, [this] {
      error_code ignored;
      socket.close(ignored);
    });
  }

  void connect(const Address& address) {
    const auto deadline = std::chrono::steady_clock::now() + options.connect_timeout;
    tcp::resolver resolver(io);
    std::optional<error_code> result;
    tcp::resolver::results_type found;
    resolver.async_resolve(address.host, std::to_string(address.port),
                           [&](const error_code& error, tcp::resolver::results_type endpoints) {
                             result = error;
                             found = std::move(endpoints);
                           });
    if (!wait(result, deadline, [&] { resolver.cancel(); }) || *result)
      fail("cannot find the host", result && *result ? *result : asio::error::timed_out);

    error_code last = asio::error::host_not_found;
    for (const auto& entry : found) {
      last = try_endpoint(entry.endpoint(), deadline);
      if (!last) return;
    }
    fail("cannot connect", last);
  }

  error_code try_endpoint(const tcp::endpoint& endpoint,
                          std::chrono::steady_clock::time_point deadline) {
    error_code error;
    socket.close(error);
    socket.open(endpoint.protocol(), error);
    if (error) return error;
    if (options.receive_buffer_bytes > 0) {
      // Before the connection is made: it decides on the window that the server is told.
      const auto size = static_cast<int>(options.receive_buffer_bytes);
      socket.set_option(asio::socket_base::receive_buffer_size(size), error);
    }
    std::optional<error_code> result;
    socket.async_connect(endpoint, [&](const error_code& done) { result = done; });
    const bool is_done = wait(result, deadline, [this] {
      error_code ignored;
      socket.close(ignored);
    });
    return is_done ? *result : asio::error::timed_out;
  }

  ConnectionOptions options;
  std::string name;
  asio::io_context io{1};
  tcp::socket socket;
};

Connection::Connection(const Address& address, const ConnectionOptions& options)
    : impl_(std::make_unique<Impl>(address, options)) {
  impl_->connect(address);
}

Connection::~Connection() = default;

void Connection::write(std::string_view bytes) {
  while (!bytes.empty()) {
    std::optional<error_code> result;
    std::size_t count = 0;
    impl_->socket.async_write_some(asio::buffer(bytes.data(), bytes.size()),
                                   [&](const error_code& error, std::size_t written) {
                                     result = error;
                                     count = written;
                                   });
    if (!impl_->wait(result)) impl_->fail("the server takes nothing", asio::error::timed_out);
    if (*result) impl_->fail("cannot send", *result);
    bytes.remove_prefix(count);
  }
}

std::size_t Connection::read_some(std::span<char> buffer) {
  std::optional<error_code> result;
  std::size_t count = 0;
  impl_->socket.async_read_some(asio::buffer(buffer.data(), buffer.size()),
                                [&](const error_code& error, std::size_t read) {
                                  result = error;
                                  count = read;
                                });
  if (!impl_->wait(result)) impl_->fail("the server is silent", asio::error::timed_out);
  if (*result == asio::error::eof) return 0;
  if (*result) impl_->fail("the connection is broken", *result);
  return count;
}

}  // namespace spoctree
