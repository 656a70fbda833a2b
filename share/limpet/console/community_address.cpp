// SPDX-License-Identifier: MIT
#include <filesystem>

#include <fmt/format.h>

#include "limpet/console/community.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

double NumberOf(const std::string& what, const std::string& text, double least, double most) {
  const std::optional<double> number = ParseNumber(text);
  if (!number || *number < least || *number > most) {
    throw UsageError(fmt::format("{} takes {:g} to {:g}, not `{}`", what, least, most, text));
  }
  return *number;
}

std::uint16_t PortOf(const std::string& what, const std::string& text) {
  const std::optional<std::int64_t> port = ParseInteger(text);
  if (!port || *port < 1 || *port > 65535) {
    throw UsageError(fmt::format("{} takes a port from 1 to 65535, not `{}`", what, text));
  }
  return static_cast<std::uint16_t>(*port);
}

/// The last one given of an option that MOOS tools know by another name too.
std::optional<std::string> FindEither(const Arguments& given, const std::string& name) {
  const std::optional<std::string> own = given.Find(name);
  return own ? own : given.Find("moos_" + name);
}

void ReadGlobals(CommunityAddress& address) {
  if (const std::string host = address.mission->Global("ServerHost"); !host.empty()) {
    address.host = host;
  }
  if (const std::string port = address.mission->Global("ServerPort"); !port.empty()) {
    address.port = PortOf(address.mission->file + ": ServerPort", port);
  }
}

}  // namespace

std::string CommunityAddress::Text() const { return fmt::format("{}:{}", host, port); }

std::vector<std::string> WithAddressOptions(std::vector<std::string> with) {
  for (const char* name : {"host", "port", "moos_host", "moos_port", "wait", "timeout", "name"}) {
    with.emplace_back(name);
  }
  return with;
}

const char* AddressHelp() {
  return R"(  --host NAME, --port N  where the community is; otherwise the mission's ServerHost and
                         ServerPort, otherwise localhost:9000
  --wait S               try for S seconds to join (default: give up at once)
  --timeout S            how long to wait for an answer (default 5)
  --name NAME            name to join under (default: the tool's, with a number)
)";
}

bool IsMissionName(const std::string& word) {
  return word.ends_with(".moos") || word.ends_with(".moos++") ||
         fs::exists(fs::path(word) / "mission.moos");
}

CommunityAddress AddressOf(const Arguments& given, const std::optional<std::string>& mission) {
  CommunityAddress address;
  if (mission) {
    const fs::path file =
        fs::is_directory(*mission) ? fs::path(*mission) / "mission.moos" : fs::path(*mission);
    address.mission = LoadMission(file);
    ReadGlobals(address);
  }
  address.host = FindEither(given, "host").value_or(address.host);
  if (const auto port = FindEither(given, "port")) {
    address.port = PortOf("--port", *port);
  }
  if (const auto wait = given.Find("wait")) {
    address.wait = Seconds(NumberOf("--wait", *wait, 0.0, 1e6));
  }
  if (const auto patience = given.Find("timeout")) {
    address.patience = Seconds(NumberOf("--timeout", *patience, 0.01, 1e6));
  }
  address.name = given.Find("name").value_or("");
  if (address.host.empty()) {
    throw UsageError("--host takes a name or an address");
  }
  return address;
}

}  // namespace limpet
