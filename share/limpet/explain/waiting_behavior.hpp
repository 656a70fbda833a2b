// SPDX-License-Identifier: MIT
// Which behaviors do not run, and for want of what: a condition, input, or because they are done.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

struct WaitingBehavior {
  std::string name;
  std::string what;    ///< `DEPLOY = true`; of one that is done why it completed
  double since = 0.0;  ///< as LoggedDecision::time [s]
  bool is_done = false;
};

/// Gathered from BHV_STATUS in the order of its writing. Logs of older versions hold none.
class WaitingBehaviors {
 public:
  /// Whatever else it is given it leaves alone.
  void Take(std::string_view variable, std::string_view value, double time);

  /// Who waits at a time, in the order in which the helm named them first.
  [[nodiscard]] std::vector<WaitingBehavior> At(double time) const;

 private:
  struct Word {
    double time = 0.0;
    std::string name;  ///< empty: all behaviors are made anew
    bool waits = false;
    WaitingBehavior waiting;
  };
  std::vector<Word> words_;
};

}  // namespace limpet
