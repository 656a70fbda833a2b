// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// The macros of a plug expansion: `$(M)` value, `%(M)` value in upper case, `$(M=x)` x if M is
/// undefined, `$(M:=x)` x if M is undefined or empty.
class PlugMacros {
 public:
  struct Expansion {
    std::string text;                    ///< with every defined macro replaced
    std::vector<std::string> undefined;  ///< names left in place
    bool is_too_long = false;            ///< grew beyond the limit of a line (1 MiB)
  };

  /// Last definition wins; true if it changed an earlier one.
  bool Define(std::string_view name, std::string_view value);
  [[nodiscard]] std::optional<std::string_view> Find(std::string_view name) const;
  [[nodiscard]] bool Has(std::string_view name) const { return Find(name).has_value(); }
  /// Up to 100 rounds, so that values may hold macros.
  [[nodiscard]] Expansion Expand(std::string_view line) const;
  [[nodiscard]] std::vector<std::string> Names() const;

 private:
  bool ExpandOnce(Expansion& expansion) const;
  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace limpet
