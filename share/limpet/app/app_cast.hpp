// SPDX-License-Identifier: MIT
// APPCAST and APPCAST_REQ as uMAC, pMarineViewer and alogview write and read them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/units.hpp"

namespace limpet {

/// A warning with how often it was raised.
struct CountedWarning {
  std::string text;
  int count = 1;
  bool operator==(const CountedWarning&) const = default;
};

/// One report of one app for operators.
struct AppCast {
  std::string process;
  std::string node{};  ///< community; "" if it has no name
  std::int64_t iteration = 0;
  std::vector<std::string> messages{};  ///< the body, line by line
  std::vector<std::string> config_warnings{};
  std::vector<std::string> events{};  ///< oldest first, `[seconds]: text`
  int run_warning_total = 0;
  std::vector<CountedWarning> run_warnings{};
  bool operator==(const AppCast&) const = default;
};

/// The text of an APPCAST. Line feeds and separators (`!@`) within a text are blunted, so that
/// every reader sees the same fields.
[[nodiscard]] std::string EncodeAppCast(const AppCast& cast);

/// Nothing if no process is named. Fields that are missing keep their defaults.
[[nodiscard]] std::optional<AppCast> DecodeAppCast(std::string_view text);

/// Somebody wants reports for a while.
struct AppCastRequest {
  std::string node;  ///< community or `all`
  std::string app;   ///< MOOS name or `all`
  Seconds duration;  ///< real time, at most 30 s
  std::string key;   ///< who asks
  bool wants_warnings_only = false;

  [[nodiscard]] bool IsFor(std::string_view app_name, std::string_view community) const;
};

/// `node=alpha,app=pHelm,duration=3.0,key=uMAC_1,thresh=any`, keys in any order and case. Nothing
/// without a key, or with one of more than 200 characters.
[[nodiscard]] std::optional<AppCastRequest> ParseAppCastRequest(std::string_view text);

}  // namespace limpet
