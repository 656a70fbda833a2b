// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_address.hpp"

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kChannelPrefix = "multicast_";
constexpr std::size_t kLongestHost = 253;  ///< of a DNS name

}  // namespace

std::string ShareAddress::Text() const {
  return channel ? fmt::format("{}:{}:{}{}", host, port, kChannelPrefix, *channel)
                 : fmt::format("{}:{}", host, port);
}

Expected<ShareAddress> ParseShareAddress(std::string_view text, const MulticastPlan& plan) {
  text = Trim(text);
  if (text.starts_with(kChannelPrefix)) {
    const auto channel = ParseInteger(text.substr(kChannelPrefix.size()));
    if (!channel || *channel < 0 || *channel >= kMulticastChannels) {
      return Error{fmt::format("`{}` is no channel; allowed: multicast_0 to multicast_{}", text,
                               kMulticastChannels - 1)};
    }
    return ShareAddress{.host = plan.group,
                        .port = static_cast<std::uint16_t>(plan.base_port + *channel),
                        .channel = static_cast<int>(*channel)};
  }
  const std::size_t colon = text.rfind(':');
  const std::string_view host = Trim(text.substr(0, colon));
  const auto port =
      colon == std::string_view::npos ? std::nullopt : ParseInteger(text.substr(colon + 1));
  if (host.empty() || host.size() > kLongestHost ||
      host.find_first_of(" \t:") != std::string_view::npos || !port || *port < 0 ||
      *port > UINT16_MAX) {
    return Error{fmt::format("`{}` is no route; allowed: host:port or multicast_N", text)};
  }
  return ShareAddress{.host = std::string(host),
                      .port = static_cast<std::uint16_t>(*port),
                      .channel = std::nullopt};
}

}  // namespace limpet
