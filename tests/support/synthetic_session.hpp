// SPDX-License-Identifier: MIT
// A made-up survey as the messages that a real one would log: a lawnmower over Table 1's area.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/report_settings.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

struct SyntheticSession {
  std::string name = "discovery";
  /// Session that the vehicle compares with; empty: none. A change session's is discovery.
  std::optional<std::string> former;
  double lane_spacing_m = 3.0;
  double nav_offset_m = 0.3;  ///< constant north error of the estimate
  double nav_sd_m = 0.3;
  double dead_reckoning_drift = 0.01;  ///< metres north per metre of way
  double seconds_of_survey = 1e9;      ///< cut short after this
  std::vector<OpiBelief> opis;         ///< as the map reports them at the end
};

/// 2026-01-01T00:00:00Z, where virtual time starts.
inline constexpr double kEpoch = 1767225600.0;

[[nodiscard]] Scenario Table1Scenario();
[[nodiscard]] ReportSettings Table1Settings();
/// Beliefs that are right about every object of the scenario, `error_m` off to the east.
[[nodiscard]] std::vector<OpiBelief> RightBeliefs(const Scenario& scenario,
                                                  const std::string& session, double error_m);
[[nodiscard]] std::vector<Message> MessagesOf(const SyntheticSession& session);
[[nodiscard]] SessionRecord RecordOf(const SyntheticSession& session);

}  // namespace limpet
