// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace limpet {

/// A port that was free a moment ago.
inline std::uint16_t FreePort() {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(place);
  auto* address = reinterpret_cast<sockaddr*>(&place);
  EXPECT_EQ(::bind(probe, address, size), 0);
  EXPECT_EQ(::getsockname(probe, address, &size), 0);
  ::close(probe);
  return ntohs(place.sin_port);
}

}  // namespace limpet
