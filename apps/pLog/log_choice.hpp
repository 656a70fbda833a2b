// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/logbook/log_record.hpp"

namespace limpet {

/// One `Log = VARIABLE [@ seconds] [,NOSYNC] [,MONITOR]`.
struct LogRequest {
  std::string name;
  Seconds interval;  ///< shortest time between entries; 0: every write
  bool is_synced = true;
  bool is_monitored = false;
};
[[nodiscard]] Expected<LogRequest> ParseLogRequest(std::string_view line);

/// Decides into which file a message goes, if any: what a request names at most at its rate,
/// the rest by patterns.
class LogChoice {
 public:
  struct Patterns {
    bool is_used = true;
    std::vector<std::string> wanted{"*"};  ///< each may hold several, separated by commas
    std::vector<std::string> omitted;
    bool has_exclusion_log = false;  ///< what is not wanted goes to the .xlog
  };
  explicit LogChoice(Patterns patterns) : patterns_(std::move(patterns)) {}

  /// False if that variable has a request already.
  bool Add(const LogRequest& request);
  [[nodiscard]] std::vector<std::string> Requested() const;
  [[nodiscard]] std::optional<LogLine::File> FileFor(const Message& message);

 private:
  using Verdict = std::optional<LogLine::File>;
  [[nodiscard]] Verdict VerdictOn(std::string_view name) const;
  struct Rate {
    Seconds interval;
    std::optional<Seconds> last;
  };
  Patterns patterns_;
  std::map<std::string, Rate, std::less<>> rates_;
  std::map<std::string, Verdict, std::less<>> verdicts_;  ///< of the patterns, per variable
};

}  // namespace limpet
