// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "limpet/app/run_app.hpp"
#include "limpet/console/community.hpp"
#include "limpet/console/community_status.hpp"
#include "limpet/console/exit_code.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/console/tools.hpp"
#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

Command StatusForm(const std::string& caller) {
  return {.name = caller,
          .words = "[mission.moos]",
          .about = R"(Says who is in a community: one row for each process that the mission's ANTLER
block starts, or that pLaunch watches over, and for each guest. AWOL: should be there and is not.

  READS, WRITES  how many variables it subscribes to and has written
  DELAY ms       of its mail on the way to the database, lately
  RESTARTS       by pLaunch, and how it last ended
  NOTE           warnings of the process itself)",
          .options = WithAddressOptions({}),
          .more = fmt::format(R"(With --wait it waits that long for the missing, too. Exit code 0 if
all are there, 1 if one is missing, 2 if no community answers.

  {} missions/table1)",
                              caller)};
}

/// Asks who is there now; what was said before of other things holds.
void Ask(const CommunityAddress& address, Community& community, CommunityStatus& status) {
  status.ForgetProcesses();
  community.client().Request("PROC_SUMMARY");
  const auto mail = community.Settle();
  if (!mail) {
    throw NoCommunity(fmt::format("{} does not answer", address.Text()));
  }
  for (const Mail& piece : *mail) {
    status.Hear(piece.message);
  }
}

/// Asks until nobody is missing, or the address's wait is over.
CommunityStatus AskPatiently(const CommunityAddress& address, Community& community) {
  constexpr auto kPause = std::chrono::milliseconds(200);
  CommunityStatus status;
  if (address.mission) {
    status.Expect(*address.mission);
  }
  status.Ignore(community.name());
  for (const char* pattern : {"DB_QOS", "DB_UPTIME", "DB_DROPPED", "DB_REFUSED", "PLAUNCH_STATUS",
                              "*_STATUS", "*_WARNINGS"}) {
    community.Watch(pattern);
  }
  const Seconds deadline = SteadyTime() + address.wait;
  Ask(address, community, status);
  while (!MissingOf(status.Rows()).empty() && SteadyTime() < deadline && !EndIsRequested()) {
    std::this_thread::sleep_for(kPause);
    Ask(address, community, status);
  }
  return status;
}

int PrintStatus(const Arguments& given) {
  const ToolWords words = Sorted(given.positionals());
  if (!words.others.empty()) {
    throw UsageError(fmt::format("`{}` is no mission file", OneLine(words.others.front(), 60)));
  }
  const CommunityAddress address = AddressOf(
      given, words.missions.empty() ? std::nullopt : std::optional(words.missions.front()));
  Community community(address, OwnName("uStatus"));
  const CommunityStatus status = AskPatiently(address, community);
  const std::vector<ProcessRow> rows = status.Rows();
  const std::vector<std::string> missing = MissingOf(rows);
  std::string title =
      fmt::format("{} at {}", OneLine(community.client().community(), 40), address.Text());
  title += fmt::format(", warp {:g}", community.client().warp());
  title += status.uptime() ? fmt::format(", up {} s", ShownAge(*status.uptime())) : "";
  PrintFrame({FrameLine().Add(title, Ink::kTitle)});
  if (!rows.empty()) {
    PrintFrame(StatusTable(rows));
  }
  for (const std::string& line : status.Losses()) {
    PrintFrame({FrameLine().Add(OneLine(line), Ink::kLate)});
  }
  const bool is_known = std::ranges::any_of(rows, &ProcessRow::is_expected);
  std::string verdict = rows.empty() ? "no process but the database"
                        : is_known   ? "all present"
                                     : "guests only; a mission file says who should be there";
  if (!missing.empty()) {
    verdict = fmt::format("{} missing: {}", missing.size(), fmt::join(missing, ", "));
  }
  PrintFrame({FrameLine().Add(OneLine(verdict), missing.empty() ? Ink::kGood : Ink::kBad)});
  return missing.empty() ? kOk : kFailed;
}

}  // namespace

int RunStatus(const std::string& caller, std::span<const std::string> args) {
  return RunTool(StatusForm(caller), args, PrintStatus);
}

}  // namespace limpet
