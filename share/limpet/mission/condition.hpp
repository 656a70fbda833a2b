// SPDX-License-Identifier: MIT
// Condition logic of behavior files: `(DEPLOY = true) and (NAV_DEPTH < $(LIMIT))`.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

/// The value of a variable now, or nullptr if nobody has written it.
using ValueLookup = std::function<const Value*(std::string_view)>;

/// One parsed condition. Operators: = == != < <= > >=, and, or, !( ); each side of and/or stands in
/// parentheses. The right side is a number, a literal (quotes and blanks allowed) or `$(VARIABLE)`.
///  - `=` compares strings exactly; `==` matches whole fields of `a:b:c`, either side the shorter.
///  - A string against a number counts if it reads as one; otherwise the comparison is false.
///  - An unknown variable makes a comparison false, `!=` included.
///  - The first type of a variable stays: later values of the other type are ignored here, so a
///    condition has a memory and is not shared.
///  - `X_DELTA` that nobody has written means the seconds since the UTC time in X.
class Condition {
 public:
  /// Parses; the error says what is wrong in words.
  [[nodiscard]] static Expected<Condition> Parse(std::string_view text);
  /// Of behavior files, where a comma may stand for `=`, as in `DEPLOY, true`, where nothing else
  /// compares.
  [[nodiscard]] static Expected<Condition> ParseWithCommas(std::string_view text);

  Condition(Condition&&) noexcept;
  Condition& operator=(Condition&&) noexcept;
  Condition(const Condition& other);
  Condition& operator=(const Condition& other);
  ~Condition();

  [[nodiscard]] bool Holds(const ValueLookup& lookup, Seconds utc_now);
  /// Names of the variables it reads, sorted.
  [[nodiscard]] std::vector<std::string> Variables() const;
  [[nodiscard]] const std::string& text() const { return text_; }
  /// The condition if it is one plain comparison: `left op right`.
  struct Comparison {
    std::string left;
    std::string op;
    std::string right;
  };
  [[nodiscard]] const Comparison* comparison() const;

  struct Node;

 private:
  Condition(std::string text, std::unique_ptr<Node> root);
  std::string text_;
  std::unique_ptr<Node> root_;
  std::map<std::string, Value, std::less<>> seen_;  ///< last accepted value of each variable
};

/// `a:b` matches `x:a:b:y`: contiguous whole fields, either side the shorter.
[[nodiscard]] bool MatchesFields(std::string_view a, std::string_view b);

}  // namespace limpet
