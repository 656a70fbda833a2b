// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "limpet/helm/behavior_act.hpp"

namespace limpet {

/// Keeps what behaviors posted last, so that a value goes out when it is another one.
class PostFilter {
 public:
  /// True if the post is to go out: it is to be repeated, or its value is new for this owner,
  /// variable and key.
  [[nodiscard]] bool Passes(const std::string& owner, const BehaviorPost& post);
  /// Everything goes out once more.
  void Clear() { last_.clear(); }

 private:
  std::map<std::string, Value> last_;
};

}  // namespace limpet
