// SPDX-License-Identifier: MIT
#include "limpet/pubsub/local_socket.hpp"

#include <string>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

namespace limpet {

using Local = asio::local::stream_protocol;

namespace {

/// The system's own (208 KiB) is two or three large messages: writer and reader would take turns.
constexpr int kLocalSendBuffer = 1 << 20;

/// The name is anybody's to take. A listener of this user, or of root, may be believed; any other
/// would have to hold the TCP port as well.
bool IsTrustworthy(int descriptor) {
  ucred owner{};
  socklen_t size = sizeof owner;
  return ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &owner, &size) == 0 &&
         (owner.uid == ::geteuid() || owner.uid == 0);
}

}  // namespace

std::optional<Local::endpoint> LocalPlaceOf(const asio::ip::address& address, std::uint16_t port) {
  const bool is_any = address.is_unspecified();
  if (!address.is_v4() || !(is_any || address.is_loopback())) {
    return std::nullopt;
  }
  const std::string where = is_any ? "127.0.0.1" : address.to_string();
  return Local::endpoint(fmt::format("{}limpet/{}:{}", '\0', where, port));
}

std::optional<StreamSocket> ConnectLocally(const StreamSocket::executor_type& executor,
                                           const asio::ip::address& address, std::uint16_t port) {
  if (address.is_unspecified()) {
    return std::nullopt;
  }
  const std::optional<Local::endpoint> place = LocalPlaceOf(address, port);
  if (!place) {
    return std::nullopt;
  }
  Local::socket socket(executor);
  std::error_code error;
  socket.open(Local(), error);
  socket.non_blocking(true, error);
  // Not Asio's connect: it takes "try again" (the broker's queue is full) for a connection under
  // way. Here that is not worth a wait: there is TCP.
  if (error ||
      ::connect(socket.native_handle(), place->data(), static_cast<socklen_t>(place->size())) !=
          0 ||
      !IsTrustworthy(socket.native_handle())) {
    return std::nullopt;
  }
  StreamSocket stream(std::move(socket));
  WidenLocal(stream);
  return stream;
}

void WidenLocal(StreamSocket& socket) {
  std::error_code ignored;
  socket.set_option(asio::socket_base::send_buffer_size(kLocalSendBuffer), ignored);
}

}  // namespace limpet
