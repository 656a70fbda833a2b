// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/LimpetDB/wall_clock_watch.hpp"
#include "limpet/app/app_caster.hpp"
#include "limpet/app/app_status.hpp"
#include "limpet/app/warning_board.hpp"
#include "limpet/pubsub/tcp_broker.hpp"

namespace limpet {

/// What the database says of itself as apps do: APPCAST for those who look, LIMPETDB_STATUS every
/// 2 s, LIMPETDB_WARNINGS; and WALL_CLOCK. It is no client of its own.
class DatabaseReport {
 public:
  /// `where`: address and port, as people read it.
  DatabaseReport(const std::string& community, double warp, std::string where, Seconds now);

  /// Mail of APPCAST_REQ.
  void OnRequest(std::string_view text, Seconds now) { caster_.OnRequest(text, now); }
  /// Variables to be written now. `wall`: the wall clock [s since 1970].
  [[nodiscard]] TcpBrokerOptions::Words Take(const Broker& broker, Seconds now, Seconds wall);

 private:
  void Watch(const Broker& broker, Seconds now);
  /// Raises the warning while `count` grows, and for a while after.
  void WatchCount(const WarningId& id, std::uint64_t count, const std::string& text, Seconds now);
  void ClearSettledCounts(Seconds now);
  void WatchClock(TcpBrokerOptions::Words& words, Seconds now, Seconds wall);
  void Raise(const WarningId& id, const std::string& text, Seconds now);
  void Clear(const WarningId& id);
  [[nodiscard]] std::vector<std::string> Body(const Broker& broker, Seconds now);

  AppCaster caster_;
  AppStatus status_;
  WallClockWatch clock_;
  WarningBoard warnings_;
  Seconds started_;
  std::string where_;
  double warp_;
  Seconds last_status_;
  std::int64_t looks_ = 0;
  /// A count that a warning tells of, and when it grew; nothing: not lately.
  struct Growth {
    WarningId id;
    std::uint64_t count = 0;
    std::optional<Seconds> last{};
  };
  std::map<std::string, Growth> growths_;  ///< by id
  std::uint64_t messages_ = 0;             ///< at the last report
  Seconds messages_at_;
};

}  // namespace limpet
