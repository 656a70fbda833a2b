// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/units.hpp"

namespace limpet {

/// `ok_skew`: mail whose stamp is further from now than that is left out. What was written before
/// the variable was asked for is old without being late: it counts for as long.
class MailSkew {
 public:
  /// Absent: any skew is right.
  explicit MailSkew(std::optional<Seconds> limit) : limit_(limit) {}

  /// A variable is asked for.
  void Begin(const std::string& variable, Seconds now) { begun_.emplace(variable, now); }
  /// What is wrong with a message; nothing if it may be heard.
  [[nodiscard]] std::optional<std::string> Refuse(const std::string& variable, Seconds stamp,
                                                  Seconds now);
  /// True while the last mail of a variable was left out.
  [[nodiscard]] bool is_refusing() const { return !refused_.empty(); }

 private:
  std::optional<Seconds> limit_;
  std::map<std::string, Seconds, std::less<>> begun_;
  std::map<std::string, Seconds, std::less<>> refused_;  ///< with their skew
};

}  // namespace limpet
