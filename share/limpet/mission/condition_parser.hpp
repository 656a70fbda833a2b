// SPDX-License-Identifier: MIT
// The syntax tree of a condition, for this library only.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet::internal {

struct ConditionNode {
  enum class Kind { kComparison, kNot, kAnd, kOr };
  Kind kind = Kind::kComparison;
  std::unique_ptr<ConditionNode> left;
  std::unique_ptr<ConditionNode> right;
  Condition::Comparison comparison;
  std::string right_variable;  ///< of `$(NAME)`
};

[[nodiscard]] ConditionNode CopyOf(const ConditionNode& node);
[[nodiscard]] Expected<ConditionNode> ParseConditionNode(std::string_view text);

}  // namespace limpet::internal
