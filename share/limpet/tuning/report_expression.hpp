// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/tuning/report_values.hpp"

namespace limpet {

/// An expression over the numbers of a report.json: `sessions.discovery.path_m +
/// 20 * max(0, 0.97 - sessions.discovery.covered)`. Numbers, keys (report_values.hpp), + - * / ^,
/// parentheses, min, max, abs, sqrt, count of any number of arguments where that makes sense, and
/// comparisons (< <= > >= == !=), `and`, `or`, `not` that give 1 or 0. Binding as in arithmetic:
/// ^ first and from the right, then the sign, * /, + -, comparisons, not, and, or.
class ReportExpression {
 public:
  /// The complaint names the position, from 1, and shows it.
  [[nodiscard]] static Expected<ReportExpression> Parse(std::string_view text);

  /// Value of the expression; nothing if a key that it needs has no number in this report (null: a
  /// level that was never reached) or the result is not finite.
  [[nodiscard]] std::optional<double> Evaluate(const ReportValues& report) const;
  /// Every key that it names.
  [[nodiscard]] const std::set<std::string>& keys() const { return keys_; }
  /// Complaint about a key that `report` does not know at all, with the nearest that it does.
  [[nodiscard]] std::optional<std::string> UnknownKey(const ReportValues& report) const;
  /// True if its outermost operation compares or decides.
  [[nodiscard]] bool is_condition() const;
  [[nodiscard]] const std::string& text() const { return text_; }

  static constexpr std::size_t kMaxBytes = 4096;
  static constexpr int kMaxDepth = 64;  ///< of parentheses and signs

  struct Node;

 private:
  ReportExpression() = default;
  std::string text_;
  std::set<std::string> keys_;
  std::shared_ptr<const Node> root_;
};

}  // namespace limpet
