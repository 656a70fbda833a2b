// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "limpet/console/community.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

ValueRule PortRule() {
  constexpr int kGreatest = 65535;
  ValueRule rule = WholeNumber(1, kGreatest);
  rule.allowed = "a port from 1 to 65535";
  return rule;
}

std::uint16_t PortOf(const std::string& text) {
  return static_cast<std::uint16_t>(ParseInteger(text).value_or(0));
}

void ReadGlobals(CommunityAddress& address) {
  if (const std::string host = address.mission->Global("ServerHost"); !host.empty()) {
    address.host = host;
  }
  if (const std::string port = address.mission->Global("ServerPort"); !port.empty()) {
    if (!PortRule().accepts(port)) {
      throw UsageError(fmt::format("{}: ServerPort takes {}, not `{}`", address.mission->file,
                                   PortRule().allowed, port));
    }
    address.port = PortOf(port);
  }
}

}  // namespace

std::string CommunityAddress::Text() const { return fmt::format("{}:{}", host, port); }

std::vector<CommandOption> WithAddressOptions(std::vector<CommandOption> with) {
  std::vector<CommandOption> own{
      {.names = "--host,--moos_host",
       .value = "NAME",
       .meaning = "where the community is (default: the mission's ServerHost, else localhost)",
       .rule = NotEmpty("a name or an address")},
      {.names = "--port,--moos_port",
       .value = "N",
       .meaning = "its port (default: the mission's ServerPort, else 9000)",
       .rule = PortRule()},
      {.names = "--wait",
       .value = "S",
       .meaning = "try for S seconds to join (default: give up at once)",
       .rule = NumberBetween(0.0, 1e6, "seconds")},
      {.names = "--timeout",
       .value = "S",
       .meaning = "how long to wait for an answer",
       .fallback = "5",
       .rule = NumberBetween(0.01, 1e6, "seconds")},
      {.names = "--name",
       .value = "NAME",
       .meaning = "name to join under (default: the tool's, with a number)"}};
  std::ranges::move(own, std::back_inserter(with));
  return with;
}

bool IsMissionName(const std::string& word) {
  return word.ends_with(".moos") || word.ends_with(".moos++") ||
         fs::exists(fs::path(word) / "mission.moos");
}

CommunityAddress AddressOf(const Arguments& given, const std::optional<std::string>& mission) {
  CommunityAddress address;
  if (mission) {
    address.mission = LoadMission(MissionFileAt(*mission));
    ReadGlobals(address);
  }
  address.host = given.Find("host").value_or(address.host);
  if (const auto port = given.Find("port")) address.port = PortOf(*port);
  address.wait = Seconds(given.Number("wait").value_or(0.0));
  address.patience = Seconds(*given.Number("timeout"));
  address.name = given.Find("name").value_or("");
  return address;
}

}  // namespace limpet
