// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/comparison/session_comparison.hpp"

namespace limpet {

/// What one session of several says of an object.
struct HistoryEntry {
  Status decided = Status::kNotInspected;
  bool is_back = false;                                     ///< was there, was gone, is there again
  std::optional<StatusPosterior> posterior = std::nullopt;  ///< nothing in the first session
  std::optional<int> id = std::nullopt;                     ///< in that session; nothing: not there
  /// Index of the former session whose looks and objects it is judged by; nothing: the first.
  std::optional<std::size_t> judged_by = std::nullopt;
};

/// An object over all sessions.
struct ObjectHistory {
  std::string color;
  Eigen::Vector3d p_W =
      Eigen::Vector3d::Zero();        ///< where it was last seen, in that session's frame
  std::size_t placed_in = 0;          ///< index of that session
  std::size_t since = 0;              ///< the session that saw it first
  std::vector<HistoryEntry> entries;  ///< one per session from `since` on
};

/// What became of every object over sessions in order of time.
struct SessionSeries {
  std::vector<SessionFacts> sessions;
  std::vector<SessionComparison> steps;  ///< each session against the one before
  std::vector<ObjectHistory> objects;
};

/// Each session is compared with the one before; of an object that is gone, with the last session
/// that had it, so that what comes back is known again; one that is seen first, with the last that
/// says of its place what was there before, so that one that looked elsewhere hides nothing. Each
/// comparison as CompareSessions makes
/// it. REQUIRES: two sessions or more. Throws ConfigError.
[[nodiscard]] SessionSeries CompareSeries(const std::vector<SavedSession>& sessions,
                                          const std::optional<std::string>& mission = {});

/// An object's history in words: "seen in 1, removed in 2, back in 3".
[[nodiscard]] std::string StoryOf(const ObjectHistory& object);

/// The last step as Json(SessionComparison) has it, by these two sessions alone, then all steps and
/// histories, which say for each entry by which session it is judged.
[[nodiscard]] std::string Json(const SessionSeries& series);

}  // namespace limpet
