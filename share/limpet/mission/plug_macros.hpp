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
  static constexpr std::size_t kMaxLineBytes = std::size_t{32} << 10U;  ///< that a line may grow by
  /// Most bytes of all lines and rounds of one template: values that double do so in no time.
  static constexpr std::size_t kMaxWorkBytes = std::size_t{4} << 20U;

  struct Macro {
    std::string value;
    bool is_set_empty = false;  ///< `NAME=` on the command line: defined, but with an empty value
  };
  struct Expansion {
    std::string text;          ///< with every defined macro replaced
    std::string left;          ///< the first `$(` or `%(` that stays, to its `)`; "": none does
    std::string unknown;       ///< the undefined macro's name in `left`, if it is one
    bool is_endless = false;   ///< after 100 rounds there was still something to replace
    bool is_too_long = false;  ///< grew beyond a limit
  };

  /// Last definition wins; true if it changed an earlier one.
  bool Define(std::string_view name, Macro macro);
  [[nodiscard]] const Macro* Find(std::string_view name) const;
  /// Up to 100 rounds, so that values may hold macros.
  [[nodiscard]] Expansion Expand(std::string_view line);
  [[nodiscard]] std::vector<std::string> Names() const;

 private:
  bool ExpandOnce(Expansion& expansion, std::size_t most);
  std::map<std::string, Macro, std::less<>> values_;
  std::size_t work_bytes_ = 0;
};

}  // namespace limpet
