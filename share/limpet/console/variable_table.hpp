// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "limpet/console/rate_estimate.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

/// One write, as history remembers it.
struct HeardWrite {
  Seconds time;  ///< MOOS time
  KeptValue value;
  std::string source;
};

/// What is known of one variable.
struct VariableRow {
  std::string name{};
  KeptValue value{};
  std::string source{};
  std::string source_aux{};
  std::string community{};
  Seconds stamp{};            ///< the last message's own time, of whatever clock
  Seconds written{};          ///< last write, on the community's clock
  Seconds changed{};          ///< last change of the value, likewise
  std::uint64_t writes = 0;   ///< heard here; what the broker still had does not count
  std::uint64_t changes = 0;  ///< of them, other values than before
  RateEstimate rate{};
  double told_rate = 0.0;            ///< of the broker, since its start [Hz]; 0: not told
  std::deque<HeardWrite> history{};  ///< oldest first

  [[nodiscard]] Seconds Age(Seconds now) const { return now - written; }
  /// Own measurement, else what the broker said [Hz].
  [[nodiscard]] double RateAt(Seconds now) const;
  /// True if it used to come regularly and is now five periods late.
  [[nodiscard]] bool IsOverdue(Seconds now) const;
};

/// Everything a scope has heard, by name. Times are MOOS times and handed in.
class VariableTable {
 public:
  static constexpr std::size_t kMostHistory = 500;
  static constexpr std::size_t kHistoryBytes = 256;  ///< kept of each text in the history

  /// `heard`: when it came.
  void Hear(const Message& message, Seconds heard);
  /// What the broker says of a variable's write rate since its start.
  void HearRate(const std::string& name, double hz);
  [[nodiscard]] const std::map<std::string, VariableRow>& rows() const { return rows_; }
  [[nodiscard]] const VariableRow* Find(const std::string& name) const;

 private:
  std::map<std::string, VariableRow> rows_;
};

enum class ScopeSort { kName, kAge, kRate, kSource };
[[nodiscard]] const char* NameOf(ScopeSort sort);

/// Which variables are shown. Empty lists let all through.
struct ScopeFilter {
  std::vector<std::string> names{};    ///< patterns with * and ?
  std::vector<std::string> sources{};  ///< patterns of the last writer's name
  /// Words; each with * or ? must match the name, each other must occur in it, in any case of
  /// letters; one of them suffices.
  std::string typed{};
  bool changed_only = false;  ///< whose value has changed since it was first heard

  [[nodiscard]] bool Accepts(const VariableRow& row) const;
};

/// Rows that pass the filter: by name, youngest first, fastest first, or by source and name.
[[nodiscard]] std::vector<const VariableRow*> Arranged(const VariableTable& table,
                                                       const ScopeFilter& filter, ScopeSort sort,
                                                       bool is_reversed, Seconds now);

}  // namespace limpet
