// SPDX-License-Identifier: MIT
// A generator offers paths that could be flown next; behaviors value them, the helm decides.
#pragma once

#include <vector>

#include "limpet/helm/situation.hpp"
#include "limpet/planning/option.hpp"

namespace limpet {

/// One way of finding options. It judges nothing: its estimate of an option only orders its own
/// offers. Deterministic for the random stream that it was built with; works in bounded time,
/// counted in work and never in seconds.
class OptionGenerator {
 public:
  virtual ~OptionGenerator() = default;

  /// Appends paths from `now.pose` that serve `goals`, best first. `options` holds what the
  /// generators named before this one have offered, in their order.
  virtual void Offer(const Situation& now, const SearchGoals& goals,
                     std::vector<Option>& options) = 0;
  /// Lengthens options of whomever, so that all of them end where the survey does and can be
  /// compared as wholes; own_m of those says what is theirs. Called after all offers.
  virtual void Complete(std::vector<Option>& options) { static_cast<void>(options); }
  /// The helm flies `option`, of this generator or of another.
  virtual void OnChoice(const Option& option) { static_cast<void>(option); }
};

}  // namespace limpet
