// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/helm/behavior.hpp"
#include "limpet/helm/duration_clock.hpp"

namespace limpet {

/// Whose flags are posted, and when.
struct FlagOwner {
  const std::string& name;
  const std::string& type;
  double weight = 0.0;
  const DurationClock& clock;
  const Behavior& behavior;
};

/// The macros of one behavior's flags: OWNSHIP BHVNAME BHVTYPE PWT UTC NOW OSX OSY OSH OSV
/// DUR_RUN_TIME DUR_IDLE_TIME HASH HASH2 to HASH9 CTR CTR1 to CTR5, and the behavior's own.
class FlagMacros {
 public:
  /// The text of a macro, or nothing if there is none such. CTR and its kin count this use; NOW is
  /// seconds since its first use.
  [[nodiscard]] std::optional<std::string> Expand(std::string_view name, const FlagOwner& owner,
                                                  const VehicleState& state);

 private:
  std::array<int, 6> counters_{};  ///< CTR, CTR1 to CTR5
  std::optional<Seconds> first_now_;
  std::uint64_t hashes_ = 0;  ///< made so far
};

/// Decimals of numbers in flags, as MOOS-IvP writes them.
[[nodiscard]] std::string MacroNumber(double value);

}  // namespace limpet
