// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What has been heard of a variable: an iteration may find several mails of one, all of which
/// count (OBM_RESOLVED names one obstacle each).
class HeardVariable {
 public:
  HeardVariable() = default;
  HeardVariable(Seconds time, Value value) { Hear({time, std::move(value)}); }

  void Hear(Stamped<Value> mail);
  /// What came before is past.
  void Settle() { recent_.clear(); }

  /// REQUIRES: something was heard.
  [[nodiscard]] const Stamped<Value>& last() const { return last_; }
  /// Values since the last iteration, oldest first; of very many the newest.
  [[nodiscard]] std::span<const Stamped<Value>> recent() const { return recent_; }

 private:
  Stamped<Value> last_;
  std::vector<Stamped<Value>> recent_;
};

/// Variables by name.
using HeardValues = std::map<std::string, HeardVariable, std::less<>>;

}  // namespace limpet
