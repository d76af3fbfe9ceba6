// The listener: connections -> sessions, until a signal ends them all.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>

#include "common/wire/address.hpp"
#include "common/wire/limits.hpp"
#include "server/net/model_store.hpp"

namespace spoctree {

/// Tests shorten these.
struct ServerLimits {
  std::size_t max_connections = kMaxConnections;
  std::chrono::milliseconds idle_timeout = kIdleTimeout;
  std::chrono::milliseconds request_timeout = kRequestTimeout;
};

/// One thread serves any number of clients: nothing but the kernel waits for a slow one, and what
/// it gets is a slice of the model's file.
class Server {
 public:
  /// Listens; clients can connect from now on. Port 0 means any free port. `store` must outlive
  /// this. Throws NetworkError naming the address when it cannot be listened on.
  Server(const ModelStore& store, const Address& address, const ServerLimits& limits = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Where it listens, as numbers.
  Address address() const;

  /// Serves until SIGTERM, SIGINT or `stop`; then all connections are closed.
  void run();
  /// Ends `run`. From any thread.
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spoctree
