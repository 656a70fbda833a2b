// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/pubsub/broker.hpp"
#include "limpet/pubsub/kept_file.hpp"

namespace limpet {

/// Keeps the latest values of a broker's variables for the broker that takes its place: what was
/// poked, and what is published once, outlives a crash. A variable that is written now and then,
/// four times in a row at most, is kept at once; one that is written all the time, once a second,
/// and a large one more rarely: its writer will say more soon. The broker's own variables are not
/// kept.
class ValueKeeper {
 public:
  static constexpr std::size_t kLargestValue = std::size_t{1} << 20;  ///< larger ones are not kept

  /// Gives `broker` what the former one had. REQUIRES: nobody has written to it yet.
  ValueKeeper(int descriptor, std::size_t limit, Broker& broker);

  /// Keeps what has been written since the last call, or puts it off. `now`: steady time.
  void Keep(Seconds now);
  /// Keeps what was put off and is due now.
  void KeepWaiting(Seconds now);
  [[nodiscard]] bool has_waiting() const { return !waiting_.empty(); }

 private:
  [[nodiscard]] bool KeepOne(Router::Variable variable, Seconds now);
  void RewriteAll();

  Broker& broker_;
  KeptFile file_;
  std::vector<Router::Variable> waiting_;
  std::vector<Seconds> next_;  ///< by variable: not to be kept again before (steady time)
  std::uint64_t clears_ = 0;
};

}  // namespace limpet
