// A TCP connection to a server: blocking calls, each of which ends in time.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "common/wire/address.hpp"
#include "common/wire/limits.hpp"

namespace spoctree {

struct ConnectionOptions {
  /// For the name to be looked up and the connection to be made.
  std::chrono::milliseconds connect_timeout = kConnectTimeout;
  /// For the peer to send, or to take, the next byte.
  std::chrono::milliseconds idle_timeout = kIdleTimeout;
  /// Bytes that the system may receive ahead of `read_some`; 0: the system's choice. What is sent
  /// beyond them waits at the server.
  std::size_t receive_buffer_bytes = 0;
};

/// Every function throws NetworkError, naming the address and the reason, when the connection
/// cannot be made, is broken, or stands still for too long.
class Connection {
 public:
  explicit Connection(const Address& address, const ConnectionOptions& options = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void write(std::string_view bytes);
  /// Waits for at least one byte; the number of bytes read, 0 when the peer has ended the stream.
  std::size_t read_some(std::span<char> buffer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spoctree
