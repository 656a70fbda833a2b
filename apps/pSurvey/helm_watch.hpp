// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/core/units.hpp"

namespace limpet {

/// Whether somebody steers the vehicle: what the helm says of itself, and when it last said it.
class HelmWatch {
 public:
  /// IVPHELM_STATE: DRIVE, PARK, ...
  void HearState(const std::string& state, Seconds now);
  /// IVPHELM_ALLSTOP: clear, or why all is stopped.
  void HearAllStop(const std::string& all_stop, Seconds now);

  /// Why nobody steers, if that has been so for a while; `since` is when the mission got under way.
  [[nodiscard]] std::optional<std::string> Complaint(Seconds since, Seconds now) const;

 private:
  std::string state_;
  std::string all_stop_;
  std::optional<Seconds> heard_;       ///< last
  std::optional<Seconds> idle_since_;  ///< absent while it drives
};

}  // namespace limpet
