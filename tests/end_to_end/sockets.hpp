// Plain blocking sockets on the loopback: peers that behave as a test wants them to. Nothing here
// waits for more than a minute.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace spoctree::test {

/// A connected socket.
class Socket {
 public:
  explicit Socket(int descriptor);
  ~Socket();
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;

  static Socket connect_to(std::uint16_t port);

  /// False when the peer is gone.
  bool send(std::string_view bytes) const;
  /// Up to 64 KiB; empty at the end, and when the peer is gone.
  std::string receive() const;
  /// Until the end, but no more than `most` bytes.
  std::string receive_all(std::size_t most = SIZE_MAX) const;
  /// Exactly so many bytes, or what came before the end.
  std::string receive_exactly(std::size_t count) const;
  void end_sending() const;
  /// Closes so that the peer gets a reset.
  void reset();
  void close();
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Accepts on a free port of the loopback.
class Listener {
 public:
  Listener();
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  std::uint16_t port() const { return port_; }
  Socket accept() const;

 private:
  int descriptor_;
  std::uint16_t port_ = 0;
};

/// A server that does with each of `connections` connections what `talk` says. Joined at the end.
class FakeServer {
 public:
  explicit FakeServer(std::function<void(Socket)> talk, int connections = 1);
  ~FakeServer() { thread_.join(); }
  std::string url(const std::string& name = "model") const;

 private:
  Listener listener_;
  std::thread thread_;
};

/// Passes one connection on to a port and counts what comes back.
class CountingProxy {
 public:
  explicit CountingProxy(std::uint16_t target);
  ~CountingProxy() { join(); }
  std::uint16_t port() const { return listener_.port(); }
  /// Bytes that the server sent. Waits for the end of the connection.
  std::uint64_t bytes_from_server();

 private:
  void join() {
    if (thread_.joinable()) thread_.join();
  }
  Listener listener_;
  std::atomic<std::uint64_t> bytes_ = 0;
  std::thread thread_;
};

}  // namespace spoctree::test
