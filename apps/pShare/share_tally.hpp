// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/sharing/share_gate.hpp"
#include "limpet/topics/sharing.hpp"

namespace limpet {

/// What was sent, taken and refused, and what of that an operator should hear of now.
class ShareTally {
 public:
  ShareCounts counts;

  /// Counts a refusal. True if it is one to warn of: not merely what the mission asked for.
  bool Note(ShareRefusal refusal, Seconds now, double how_many = 1.0);
  /// Reasons to warn of that have not come up for a while; each is told once.
  [[nodiscard]] std::vector<ShareRefusal> TakeSettled(Seconds now);

 private:
  std::map<ShareRefusal, Seconds> last_;
};

}  // namespace limpet
