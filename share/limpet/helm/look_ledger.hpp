// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "limpet/helm/situation.hpp"

namespace limpet {

/// Which looks were planned and flown without telling anything. A chosen path promises a look at
/// every open object that it would show; when the vehicle has come that far and what is believed of
/// the object is what was believed before, the look was fruitless, whatever the reason: an object
/// that is not where it is thought to be, water that shows nothing, a place that is never reached.
class LookLedger {
 public:
  /// An object of which something new is believed starts anew.
  void SetBeliefs(const std::vector<OpiBelief>& beliefs);
  /// A path was chosen at `travelled` metres of way; `open` are the objects that are worth a look.
  void Promise(const DubinsPath& path, std::span<const WatchedObject> open, double travelled);
  /// The vehicle has come to `travelled`: what was due is judged. True if a look was fruitless.
  bool Judge(double travelled);

  [[nodiscard]] int fruitless(int id) const;

 private:
  struct Entry {
    int looks = 0;
    double entropy = 0.0;  ///< [nats]
    int fruitless = 0;
    std::optional<double> due{};  ///< way at which the look is promised [m]
  };
  std::map<int, Entry> entries_;  ///< by id
};

}  // namespace limpet
