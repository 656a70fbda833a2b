// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limpet/mission/scenario.hpp"
#include "limpet/scoring/nav_score.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// A true object and where the vehicle says it is. NED [m].
struct OpiScore {
  std::string truth;
  std::string color;  ///< the true one
  double radius_m = 0.5;
  Eigen::Vector3d truth_W = Eigen::Vector3d::Zero();
  OpiBelief belief;  ///< as SmoothedBelief gives it
  double error_m = 0.0;
  double aligned_error_m = 0.0;  ///< after the session's common offset and heading
};

/// What became of a true object between the sessions, and what the vehicle decided.
struct ChangeScore {
  std::optional<std::string> truth;     ///< nothing: a decision about nothing
  std::optional<Status> expected;       ///< confirmed, removed, new, moved
  Status decided = Status::kUncertain;  ///< one of these, uncertain or not_inspected
  std::optional<double> probability;    ///< of what was decided; nothing: no look says any
  std::optional<Eigen::Vector3d> p_W;   ///< where the vehicle says; nothing: it knows of no object
  std::optional<StatusPosterior> posterior = std::nullopt;  ///< of that object
  /// As OpiBelief; the posterior does not know of it.
  std::optional<double> moved_probability = std::nullopt;
  [[nodiscard]] bool is_right() const { return expected && *expected == decided; }
  [[nodiscard]] bool is_open() const { return IsOpen(decided); }
};

/// Every belief in it is as SmoothedBelief gives it.
struct OpiScores {
  /// Without truth only; then the three lists below are empty. Reported is what was decided to be
  /// there, and what is there now with a probability of 0.9 or more, though it was left open
  /// whether it was there before.
  std::vector<OpiBelief> reported;
  std::vector<OpiScore> found;
  std::vector<std::string> missed;
  std::vector<OpiBelief> invented;   ///< reported, and not there
  std::vector<ChangeScore> changes;  ///< empty unless the session has a former one
};

/// The belief with the smoother's last word on where the object is, else what the map has.
[[nodiscard]] OpiBelief SmoothedBelief(OpiBelief opi, const std::vector<Landmark>& landmarks);

/// Matches reported and true objects one to one, nearest first, within 2.5 m; and decisions with
/// what became of the objects since the session `former`, if there is one.
[[nodiscard]] OpiScores ScoreOpis(const SessionRecord& record, const std::string& former,
                                  const Scenario& scenario, const CommonOffset& offset);

/// What the vehicle reports, and decided if it had a former session; nothing of it is judged.
[[nodiscard]] OpiScores ReportedOpis(const SessionRecord& record, bool has_former);

}  // namespace limpet
