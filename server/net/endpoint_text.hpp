// Asio's endpoints as addresses. For the sources of server/net only.
#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "common/wire/address.hpp"

namespace spoctree {

inline Address address_of(const boost::asio::ip::tcp::endpoint& endpoint) {
  return {endpoint.address().to_string(), endpoint.port()};
}

}  // namespace spoctree
