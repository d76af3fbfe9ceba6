#include "tests/end_to_end/sockets.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace spoctree::test {

namespace {

constexpr int kPatienceSeconds = 60;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

void set_patience(int descriptor) {
  const timeval patience{kPatienceSeconds, 0};
  ::setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
}

}  // namespace

Socket::Socket(int descriptor) : descriptor_(descriptor) {
  if (descriptor_ < 0) throw std::runtime_error("no socket");
  set_patience(descriptor_);
}

Socket::~Socket() { close(); }
Socket::Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

Socket Socket::connect_to(std::uint16_t port) {
  Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const sockaddr_in address = loopback(port);
  if (::connect(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address))
    throw std::runtime_error("cannot connect");
  return socket;
}

bool Socket::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string Socket::receive() const {
  std::array<char, 65536> buffer;
  const ssize_t count = ::recv(descriptor_, buffer.data(), buffer.size(), 0);
  return std::string(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
}

std::string Socket::receive_all(std::size_t most) const {
  std::string all;
  for (std::string part = receive(); !part.empty() && all.size() < most; part = receive())
    all += part;
  return all;
}

std::string Socket::receive_exactly(std::size_t count) const {
  std::string bytes(count, '\0');
  const ssize_t received = ::recv(descriptor_, bytes.data(), count, MSG_WAITALL);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(received, 0)));
  return bytes;
}

void Socket::end_sending() const { ::shutdown(descriptor_, SHUT_WR); }

void Socket::reset() {
  const linger at_once{1, 0};
  ::setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  close();
}

void Socket::close() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

Listener::Listener() : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (descriptor_ < 0 || ::bind(descriptor_, generic, size) || ::listen(descriptor_, 64) ||
      ::getsockname(descriptor_, generic, &size))
    throw std::runtime_error("cannot listen");
  set_patience(descriptor_);
  port_ = ntohs(address.sin_port);
}

Listener::~Listener() { ::close(descriptor_); }

Socket Listener::accept() const {
  return Socket(::accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC));
}

FakeServer::FakeServer(std::function<void(Socket)> talk, int connections)
    : thread_([this, talk = std::move(talk), connections] {
        try {
          for (int i = 0; i < connections; ++i) talk(listener_.accept());
        } catch (const std::runtime_error&) {
          // Nobody came: the test sees that on its side.
        }
      }) {}

std::string FakeServer::url(const std::string& name) const {
  return "spo://127.0.0.1:" + std::to_string(listener_.port()) + "/" + name;
}

CountingProxy::CountingProxy(std::uint16_t target)
    : thread_([this, target] {
        try {
          const Socket client = listener_.accept();
          const Socket server = Socket::connect_to(target);
          pollfd ends[2] = {{client.descriptor(), POLLIN, 0}, {server.descriptor(), POLLIN, 0}};
          while (::poll(ends, 2, kPatienceSeconds * 1000) > 0) {
            const bool is_from_server = ends[1].revents != 0;
            const std::string bytes = (is_from_server ? server : client).receive();
            if (bytes.empty() || !(is_from_server ? client : server).send(bytes)) return;
            if (is_from_server) bytes_ += bytes.size();
          }
        } catch (const std::runtime_error&) {
        }
      }) {}

std::uint64_t CountingProxy::bytes_from_server() {
  join();
  return bytes_;
}

}  // namespace spoctree::test
