// SPDX-License-Identifier: MIT
// What a behavior does beside bidding, as values: the helm carries it out.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/mission/flag.hpp"

namespace limpet {

/// A variable to be written. The helm leaves it out while owner, variable and key had this value
/// last, unless it is to be repeated.
struct BehaviorPost {
  std::string variable;
  Value value;
  std::string key{};  ///< tells posts of one variable apart, e.g. two points that are drawn
  bool is_repeated = false;
};

/// It has done what it was to do: its `endflag`s go out, and unless it is perpetual it is gone
/// after this iteration.
struct Completion {
  std::string reason{};
};

/// A post, a flag of its own whose macros the helm expands, or its completion.
using BehaviorAct = std::variant<BehaviorPost, Flag, Completion>;

/// What a running behavior did in an iteration beside bidding.
struct BehaviorTurn {
  std::string name;
  std::vector<BehaviorAct> acts;
};

}  // namespace limpet
