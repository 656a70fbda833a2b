// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Collects what a behavior does in one iteration, in order.
class ActList {
 public:
  /// A variable whose name may be empty or `silent`: then nothing is posted.
  void Post(const std::string& variable, Value value, std::string key = "");
  /// Goes out also if its value is what it was.
  void Repeat(const std::string& variable, Value value);
  /// Texts of shapes: what has a variable, a text and a key.
  template <class Texts>
  void Draw(const Texts& drawn) {
    for (const auto& [variable, text, key] : drawn) {
      Post(variable, text, key);
    }
  }
  /// Flags of the behavior's own, e.g. `wptflag`; its macros have the values that they have now.
  /// As in MOOS-IvP a value that is the same as the last time is not posted again.
  void Raise(std::span<const Flag> flags, const Behavior& behavior, const VehicleState& state);
  /// Flags that are posted each time, whatever they said the last time, e.g. `cycleflag`.
  void RaiseAgain(std::span<const Flag> flags, const Behavior& behavior, const VehicleState& state);
  void Complete(std::string reason = "") { acts_.emplace_back(Completion{std::move(reason)}); }
  /// The vehicle is to stop.
  void Halt(std::string reason) { acts_.emplace_back(Emergency{std::move(reason)}); }
  [[nodiscard]] std::vector<BehaviorAct> Take() { return std::move(acts_); }

 private:
  std::vector<BehaviorAct> acts_;
};

/// Adds the flag of one line of a block, `clearall` empties the list; false if it is none.
[[nodiscard]] bool AddFlag(std::string_view text, std::vector<Flag>& flags);
/// Declares flags of the behavior's own, one per line of its block.
void DescribeFlags(ParamCollector& visit, const char* name, std::vector<Flag>& flags,
                   const char* help);

}  // namespace limpet
