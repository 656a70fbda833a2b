// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace limpet {

/// What the value of an option may be. A complaint reads `--jobs takes <allowed>, not <value>`.
struct ValueRule {
  std::string allowed{};
  std::function<bool(const std::string&)> accepts{};  ///< none: every value
};

/// A whole number from `least` to `most`, which is two thousand million unless it is said.
[[nodiscard]] ValueRule WholeNumber(int least, int most = 2'000'000'000);
/// Both ends included; `unit` is said behind the range, e.g. `pictures a second`.
[[nodiscard]] ValueRule NumberBetween(double least, double most, const std::string& unit = "");
/// Every finite number; `what` it is, e.g. `seconds since the start of the log`.
[[nodiscard]] ValueRule AnyNumber(const std::string& what);
[[nodiscard]] ValueRule OneOf(std::vector<std::string> words);
/// Every word but the empty one; `what` it is, e.g. `a folder`.
[[nodiscard]] ValueRule NotEmpty(const std::string& what);

}  // namespace limpet
