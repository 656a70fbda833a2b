// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// Whether the helm lives, and whether it decides.
class HelmSigns {
 public:
  /// IVPHELM_STATE.
  void HearState(std::string_view state, Seconds now);
  /// IVPHELM_ALLSTOP.
  void HearAllStop(std::string_view why, Seconds now);

  /// When it was last heard; absent before.
  [[nodiscard]] std::optional<Seconds> heard() const { return heard_; }
  /// Since when it has decided nothing of its own; absent while it steers, or an operator does.
  [[nodiscard]] std::optional<Seconds> idle_since() const { return idle_since_; }
  /// True once the helm has steered.
  [[nodiscard]] bool has_steered() const { return has_steered_; }

 private:
  bool drives_ = false, has_steered_ = false;
  std::optional<Seconds> heard_, idle_since_;
};

}  // namespace limpet
