// SPDX-License-Identifier: MIT
// What may fail on demand: `faults:` of scenario.yaml, read and listed by this table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// FaultKind::made_by of what no app makes, but who hosts them: pLaunch, or an embedded session.
inline constexpr std::string_view kMadeByHost = "host";

/// One kind of fault.
struct FaultKind {
  std::string_view what;
  std::string_view meaning;
  std::string_view made_by;  ///< app, or kMadeByHost
  /// What `size` says and its unit; empty: the fault has none.
  std::string_view size_meaning{};
  double size = 0.0, least = 0.0, most = 0.0;  ///< default and bounds of it
  bool is_about_app = false;                   ///< of one app, which it names
};

[[nodiscard]] std::span<const FaultKind> FaultKinds();
/// Null if there is none of that name.
[[nodiscard]] const FaultKind* FindFaultKind(std::string_view what);

/// One line of `faults:`.
struct ScenarioFault {
  std::string what;
  std::string when;              ///< condition that it waits for; empty: the start of the session
  Seconds at;                    ///< from then
  std::optional<Seconds> lasts;  ///< absent: to the end
  double size = 0.0;
  std::string app;  ///< of a kind that is about one: which
};

}  // namespace limpet
