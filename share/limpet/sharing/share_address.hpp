// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Where `multicast_N` lies: one group for all channels, a port for each.
struct MulticastPlan {
  std::string group = "224.1.1.11";
  int base_port = 24460;
};
inline constexpr int kMulticastChannels = 256;

/// One end of a route: `host:port`, or a multicast channel.
struct ShareAddress {
  std::string host;
  std::uint16_t port = 0;
  std::optional<int> channel{};  ///< of multicast

  /// `host:port`, or `224.1.1.11:24468:multicast_8`, as MOOS's summaries say it.
  [[nodiscard]] std::string Text() const;
  auto operator<=>(const ShareAddress&) const = default;
};

/// `host:port` or `multicast_N`. Port 0, the system's choice, is an input's alone: the caller says.
[[nodiscard]] Expected<ShareAddress> ParseShareAddress(std::string_view text,
                                                       const MulticastPlan& plan);

}  // namespace limpet
