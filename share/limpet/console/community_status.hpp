// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/console/frame.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// What pLaunch says of one of its processes in PLAUNCH_STATUS.
struct LaunchWord {
  std::string state;  ///< running, waiting, ended, given_up
  std::string restarts;
  std::string last;  ///< how it last ended; empty: it has not
  bool is_database = false;
};
/// Words of pLaunch by process name. Text that is none of pLaunch's gives nothing.
[[nodiscard]] std::map<std::string, LaunchWord> ParseLaunchStatus(std::string_view text);

/// One process of a community.
struct ProcessRow {
  std::string name{};
  bool is_present = false;
  bool is_expected = false;
  std::size_t reads = 0;             ///< variables it subscribes to
  std::size_t writes = 0;            ///< variables it has written
  std::optional<double> delay_ms{};  ///< of its mail to the broker, lately
  std::optional<LaunchWord> launch{};
  std::string warnings{};  ///< of its <APP>_WARNINGS, or an error its <APP>_STATUS admits
};

/// Who is in a community, from what the broker, the apps and pLaunch say.
class CommunityStatus {
 public:
  /// Processes that should be there; a database needs no mention.
  void Expect(const MissionFile& mission);
  void Hear(const Message& message);
  /// Forgets who is there, to be called before asking anew.
  void ForgetProcesses() { present_.clear(); }
  /// A client that does not count: the one who asks.
  void Ignore(const std::string& name) { ignored_ = name; }

  /// The expected in their order, then the others by name.
  [[nodiscard]] std::vector<ProcessRow> Rows() const;
  /// What the database lost and refused, if it did, as DB_DROPPED and DB_REFUSED tell; a line each.
  [[nodiscard]] std::vector<std::string> Losses() const;
  /// MOOS seconds since the database's start; nothing if it has not said.
  [[nodiscard]] std::optional<Seconds> uptime() const { return uptime_; }

 private:
  [[nodiscard]] ProcessRow RowOf(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> Expected() const;
  void HearProcess(std::string_view summary);
  void HearQuality(std::string_view text);

  struct Traffic {
    std::size_t reads = 0, writes = 0;
  };
  std::vector<std::string> expected_;
  std::string ignored_;
  std::map<std::string, Traffic> present_;
  std::map<std::string, double> delays_;
  std::map<std::string, LaunchWord> launched_;
  std::map<std::string, std::string> health_;  ///< by variable
  std::string dropped_, refused_;
  std::optional<Seconds> uptime_;
};

/// The table that `limpet status` prints.
[[nodiscard]] Frame StatusTable(const std::vector<ProcessRow>& rows);
/// Names of the expected that are not there.
[[nodiscard]] std::vector<std::string> MissingOf(const std::vector<ProcessRow>& rows);

}  // namespace limpet
