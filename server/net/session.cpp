#include "server/net/session.hpp"

#include <linux/sockios.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <variant>

#include "common/base/errors.hpp"
#include "common/wire/answer_get.hpp"
#include "server/net/endpoint_text.hpp"
#include "server/net/log.hpp"

namespace spoctree {

namespace asio = boost::asio;
using boost::system::error_code;

namespace {

// Larger writes would not be faster; smaller ones would let the watch see less.
constexpr std::size_t kWriteBytes = 256 * 1024;

auto into(error_code& error) { return asio::redirect_error(asio::use_awaitable, error); }

}  // namespace

Session::Session(asio::ip::tcp::socket socket, const Service& service)
    : socket_(std::move(socket)), watch_timer_(socket_.get_executor()), service_(service) {
  error_code error;
  const auto peer = socket_.remote_endpoint(error);
  client_ = error ? "a client" : to_text(address_of(peer));
  // Answers are written in one piece: nothing is gained by waiting for more to send.
  socket_.set_option(asio::ip::tcp::no_delay(true), error);
}

void Session::start(bool refuse, std::function<void()> on_end) {
  expect_progress_within(service_.limits.idle_timeout);
  const auto self = shared_from_this();
  asio::co_spawn(socket_.get_executor(), watch(self), [self](const std::exception_ptr&) {});
  asio::co_spawn(socket_.get_executor(), serve(self, refuse),
                 [self, end = std::move(on_end)](const std::exception_ptr&) {
                   self->is_over_ = true;
                   self->watch_timer_.cancel();
                   self->stop();
                   end();
                 });
}

void Session::stop() {
  error_code ignored;
  socket_.close(ignored);
}

asio::awaitable<void> Session::serve(std::shared_ptr<Session> self, bool refuse) {
  try {
    if (refuse) {
      log_warning(self->client_ + ": refused, there are too many connections");
      const ErrorMessage busy{ErrorCode::Busy, "too many connections; try again later"};
      co_await self->say_farewell(busy);
    } else {
      co_await self->answer_requests();
    }
  } catch (const std::exception& error) {
    log_warning(self->client_ + ": " + error.what());
  }
}

asio::awaitable<void> Session::watch(std::shared_ptr<Session> self) {
  while (!self->is_over_) {
    self->watch_timer_.expires_at(self->deadline_);
    error_code interrupted;
    co_await self->watch_timer_.async_wait(into(interrupted));
    if (self->is_over_ || Clock::now() < self->deadline_) continue;
    const std::size_t unsent = self->unsent_bytes();
    if (self->is_patient_ && unsent != self->last_unsent_bytes_) {
      self->last_unsent_bytes_ = unsent;
      self->deadline_ = Clock::now() + self->service_.limits.idle_timeout;
      continue;
    }
    log_info(self->client_ + ": closed, it was silent for too long");
    self->stop();
    co_return;
  }
}

void Session::expect_progress_within(std::chrono::milliseconds time) {
  deadline_ = Clock::now() + time;
  if (deadline_ < watch_timer_.expiry()) watch_timer_.cancel();
}

// What the kernel still has to deliver. A slow client takes bytes from there long after they were
// written: that is progress which the socket's operations do not show.
std::size_t Session::unsent_bytes() {
  int bytes = 0;
  if (::ioctl(socket_.native_handle(), SIOCOUTQ, &bytes) != 0) return 0;
  return static_cast<std::size_t>(std::max(bytes, 0));
}

asio::awaitable<void> Session::answer_requests() {
  ErrorMessage complaint{ErrorCode::BadRequest, {}};
  try {
    while (const auto frame = co_await read_request()) {
      if (!co_await answer(*frame)) co_return;
    }
    co_return;
  } catch (const BadInput& error) {
    complaint.text = error.what();
  }
  co_await say_farewell(complaint);
}

asio::awaitable<std::optional<FrameView>> Session::read_request() {
  is_patient_ = true;
  expect_progress_within(service_.limits.idle_timeout);
  std::array<char, kFrameHeaderBytes + kMaxRequestPayloadBytes> buffer;
  bool has_begun = false;
  while (true) {
    const auto frame = requests_.next();
    if (frame) co_return frame;
    if (!has_begun && requests_.pending_bytes() > 0) {
      has_begun = true;
      is_patient_ = false;
      expect_progress_within(service_.limits.request_timeout);
    }
    error_code error;
    const std::size_t count = co_await socket_.async_read_some(asio::buffer(buffer), into(error));
    if (error) co_return std::nullopt;
    requests_.feed({buffer.data(), count});
  }
}

asio::awaitable<bool> Session::answer(FrameView frame) {
  const Request request = open_request(frame);
  if (const auto* const get = std::get_if<GetRequest>(&request))
    co_return co_await send_model(*get);
  log_info(client_ + ": list");
  co_return co_await write(service_.catalog);
}

asio::awaitable<bool> Session::send_model(const GetRequest& request) {
  log_info(client_ + ": get '" + request.name + "', levels " + std::to_string(request.levels) +
           ", from byte " + std::to_string(request.held.byte));
  const SpoFile* const file = service_.store.find(request.name);
  // These errors leave the conversation intact: the next request may do better.
  if (file == nullptr) {
    ErrorMessage error{ErrorCode::UnknownModel, "a model must be named"};
    if (!request.name.empty()) error.text = "no model is called '" + request.name + "'";
    error.text += "; there are " + service_.store.names_as_text();
    co_return co_await send_error(error);
  }
  const GetAnswer answer = answer_get(*file, request);
  if (const auto* const error = std::get_if<ErrorMessage>(&answer)) {
    co_return co_await send_error(*error);
  }
  co_return co_await write(std::get<std::string_view>(answer));
}

asio::awaitable<bool> Session::send_error(const ErrorMessage& error) {
  log_info(client_ + ": error sent: " + error.text);
  const std::string frame = seal_error(error);
  co_return co_await write(frame);
}

asio::awaitable<bool> Session::write(std::string_view bytes) {
  is_patient_ = true;
  while (!bytes.empty()) {
    expect_progress_within(service_.limits.idle_timeout);
    const std::size_t wanted = std::min(bytes.size(), kWriteBytes);
    error_code error;
    const std::size_t count =
        co_await socket_.async_write_some(asio::buffer(bytes.data(), wanted), into(error));
    if (error) {
      log_info(client_ + ": gone, with " + std::to_string(bytes.size()) + " bytes to come");
      co_return false;
    }
    bytes.remove_prefix(count);
  }
  co_return true;
}

asio::awaitable<void> Session::say_farewell(const ErrorMessage& farewell) {
  if (!co_await send_error(farewell)) co_return;
  // Closing a connection on which bytes are unread resets it, and the client would never see why:
  // say that this is the end, then listen for a while.
  error_code error;
  socket_.shutdown(asio::ip::tcp::socket::shutdown_send, error);
  is_patient_ = false;
  expect_progress_within(
      std::min<std::chrono::milliseconds>(kFarewellTimeout, service_.limits.idle_timeout));
  std::array<char, 4096> ignored;
  for (std::size_t total = 0; !error && total < kMaxFarewellBytes;)
    total += co_await socket_.async_read_some(asio::buffer(ignored), into(error));
}

}  // namespace spoctree
