// SPDX-License-Identifier: MIT
// One parameter of a behavior that runs, changed by `updates` mail: what is sent, how the helm says
// what became of it, and the event that tells who changed what.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Parts of `updates` mail that a behavior applied, and all that it was sent, as the helm counts.
struct UpdateCount {
  int good = 0, all = 0;
  bool operator==(const UpdateCount&) const = default;
};
/// Count of one behavior, from a whole IVPHELM_SUMMARY; nothing if that does not tell.
[[nodiscard]] std::optional<UpdateCount> UpdateCountIn(std::string_view summary,
                                                       std::string_view behavior);

/// `name=cover#frontier_weight=0.3`: for that behavior alone, also where several share a variable.
[[nodiscard]] std::string UpdateText(const std::string& behavior, const std::string& key,
                                     const std::string& value);
/// The value that such mail gives a behavior's key; nothing if it is for another behavior or key.
[[nodiscard]] std::optional<std::string> UpdatedValue(std::string_view mail,
                                                      std::string_view behavior,
                                                      std::string_view key);

/// One change.
struct LiveChange {
  std::string behavior, key;
  std::string old_value, new_value;
};

/// TUNE_EVENT: who changed what last, and what can be undone, newest last.
struct LiveEvent {
  std::string user, host;
  bool is_undo = false;
  bool is_applied = false;
  LiveChange change{};
  std::vector<LiveChange> undoable{};

  /// What a key was set to last, of what this tells; nothing if it tells of no such change.
  [[nodiscard]] std::optional<std::string> InForce(std::string_view behavior,
                                                   std::string_view key) const;
  /// True if this is what was sent last, and the helm did not apply it.
  [[nodiscard]] bool WasRefused(std::string_view behavior, std::string_view key,
                                std::string_view value) const;

  /// Takes what was to be undone off the list though it was not: it would be refused again, and
  /// keep those below it from being taken back. They lead from what is in force now.
  /// REQUIRES: something can be undone.
  void DropRefusedUndo();

  [[nodiscard]] std::string Text() const;
  [[nodiscard]] static Expected<LiveEvent> FromText(const std::string& text);

  static constexpr std::size_t kMostUndoable = 50;
};

/// The user of this process, as an event names it.
[[nodiscard]] std::string UserName();

}  // namespace limpet
