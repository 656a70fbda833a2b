// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A variable that rides along in the node report: `var=DB_UPTIME, policy=always, rfld=upt,
/// prec=3`.
class NodeRider {
 public:
  /// policy: always (default), updated (when there is news), updated+N (and each N s), N (each N
  /// s); rfld: name of the field (default: the variable's); prec: decimals, 0 to 10 (default 4).
  [[nodiscard]] static Expected<NodeRider> Parse(std::string_view text);

  [[nodiscard]] const std::string& variable() const { return variable_; }
  void Hear(const Value& value);
  /// `field=value` if it is due in a report at `now`.
  [[nodiscard]] std::optional<std::string> Take(Seconds now);

 private:
  /// What is wrong with one `key=value`, if anything.
  std::optional<Error> Set(std::string_view key, std::string_view value);

  std::string variable_, field_, value_;
  bool is_always_ = true, rides_when_updated_ = false, has_news_ = false;
  std::optional<Seconds> period_, last_;
  int decimals_ = 4;
};

/// A report `KEY=value,KEY=value` as one JSON object of strings.
[[nodiscard]] std::string JsonOfReport(std::string_view report);

}  // namespace limpet
