// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/app/app_cast.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// When and how one app reports.
struct CastSettings {
  std::string process{};
  std::string node{};
  Seconds interval{0.5};  ///< least real time between two reports
  std::size_t max_events = 8;
  std::size_t max_run_warnings = 10;
  double warp = 1.0;  ///< MOOS time per real time
  /// At the start and after a new configuration warning: a viewer learns of the app.
  bool casts_unasked = true;
};

/// Reads TERM_REPORT_INTERVAL, MAX_APPCAST_EVENTS and MAX_APPCAST_RUN_WARNINGS of an app's block.
/// Throws ConfigError naming the line of a bad one.
[[nodiscard]] CastSettings ReadCastSettings(const ConfigBlock& block);

/// Keeps what an app reports beside its body, and knows when somebody wants to see it.
class AppCaster {
 public:
  void Configure(CastSettings settings) { settings_ = std::move(settings); }

  /// Remembers what happened `elapsed` after the app's start.
  void AddEvent(Seconds elapsed, std::string_view text);
  void AddConfigWarning(std::string text);
  /// Raised `elapsed` after the app's start; one that stands keeps that, and takes the text.
  void RaiseWarning(const WarningId& id, const std::string& text, Seconds elapsed);
  void ClearWarning(const WarningId& id);

  /// Mail of APPCAST_REQ; what is not for this app, or no request, is ignored.
  void OnRequest(std::string_view text, Seconds now);
  /// True if a report is to be sent now.
  [[nodiscard]] bool IsDue(Seconds now);
  /// The report with its body; counts as sent.
  [[nodiscard]] AppCast Cast(std::vector<std::string> body, std::int64_t iteration, Seconds now);

 private:
  struct Request {
    Seconds until;
    bool wants_warnings_only = false;
    bool has_been_told = false;  ///< of the warnings that stand now
  };
  struct Raised {
    Severity severity = Severity::kWarning;
    std::string text;
    Seconds since;  ///< after the app's start
    int count = 0;
    bool is_up = false;
  };
  [[nodiscard]] bool IsWanted(Seconds now);
  /// The gravest first.
  void AddStandingWarnings(AppCast& cast) const;

  CastSettings settings_;
  std::deque<std::string> events_;
  std::vector<std::string> config_warnings_;
  std::map<std::string, Raised> run_warnings_;
  std::map<std::string, Request, std::less<>> requests_;  ///< by key
  bool has_news_ = true;  ///< a configuration warning, or nothing was ever sent
  std::optional<Seconds> last_cast_;
};

}  // namespace limpet
