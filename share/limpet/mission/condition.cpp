// SPDX-License-Identifier: MIT
#include "limpet/mission/condition.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/mission/condition_parser.hpp"

namespace limpet {
namespace {

using internal::ConditionNode;

constexpr std::string_view kDelta = "_DELTA";

/// Values as a condition compares them: a number, a string, or unknown.
using Operand = std::variant<std::monostate, double, std::string>;

std::string_view Unquoted(std::string_view text) {
  text = Trim(text);
  const bool is_quoted = text.size() >= 2 && text.starts_with('"') && text.ends_with('"');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

Operand OperandOf(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return *number;
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    return std::string(Unquoted(*text));
  }
  return {};  // binaries are nothing to compare
}

template <class T>
bool Compare(std::string_view op, const T& left, const T& right) {
  if (op == "=") return left == right;
  if (op == "!=") return left != right;
  if (op == "<") return left < right;
  if (op == "<=") return left <= right;
  if (op == ">") return left > right;
  return op == ">=" && left >= right;
}

bool CompareOperands(std::string_view op, const Operand& left, const Operand& right) {
  const auto* left_text = std::get_if<std::string>(&left);
  const auto* right_text = std::get_if<std::string>(&right);
  if (left_text != nullptr && right_text != nullptr) {
    return op == "==" ? MatchesFields(*left_text, *right_text)
                      : Compare<std::string>(op, *left_text, *right_text);
  }
  const auto number = [](const Operand& operand) -> std::optional<double> {
    if (const auto* text = std::get_if<std::string>(&operand)) {
      return ParseNumber(*text);
    }
    const auto* value = std::get_if<double>(&operand);
    return value != nullptr ? std::optional<double>(*value) : std::nullopt;
  };
  const std::optional<double> a = number(left);
  const std::optional<double> b = number(right);
  return a && b && Compare<double>(op == "==" ? "=" : op, *a, *b);
}

/// Reads variables for one evaluation, holding on to the first type of each.
class Evaluation {
 public:
  Evaluation(const ValueLookup& lookup, Seconds utc_now,
             std::map<std::string, Value, std::less<>>& seen)
      : lookup_(lookup), utc_now_(utc_now), seen_(seen) {}

  bool Holds(const ConditionNode& node) {
    switch (node.kind) {
      case ConditionNode::Kind::kNot:
        return !Holds(*node.left);
      case ConditionNode::Kind::kAnd: {
        const bool is_left = Holds(*node.left);  // both sides read their variables every time
        return Holds(*node.right) && is_left;
      }
      case ConditionNode::Kind::kOr: {
        const bool is_left = Holds(*node.left);
        return Holds(*node.right) || is_left;
      }
      default:
        break;
    }
    const Operand left = Read(node.comparison.left);
    return CompareOperands(node.comparison.op, left, Right(node));
  }

 private:
  Operand Right(const ConditionNode& node) {
    if (!node.right_variable.empty()) {
      return Read(node.right_variable);
    }
    if (const std::optional<double> number = ParseNumber(node.comparison.right)) {
      return *number;
    }
    return std::string(Unquoted(node.comparison.right));
  }

  Operand Read(const std::string& variable) {
    if (const Value* value = lookup_(variable)) {
      const auto [position, is_new] = seen_.try_emplace(variable, *value);
      if (!is_new && position->second.index() == value->index()) {
        position->second = *value;
      }
      return OperandOf(position->second);
    }
    if (std::string_view(variable).ends_with(kDelta)) {
      const std::string_view base(variable.data(), variable.size() - kDelta.size());
      const Value* stamp = base.empty() ? nullptr : lookup_(base);
      const auto* utc = stamp != nullptr ? std::get_if<double>(stamp) : nullptr;
      if (utc != nullptr) {
        return utc_now_.value() - *utc;
      }
    }
    return {};
  }

  const ValueLookup& lookup_;
  Seconds utc_now_;
  std::map<std::string, Value, std::less<>>& seen_;
};

void CollectVariables(const ConditionNode& node, std::set<std::string>& names) {
  for (const auto& child : {node.left.get(), node.right.get()}) {
    if (child != nullptr) {
      CollectVariables(*child, names);
    }
  }
  for (const std::string& name : {node.comparison.left, node.right_variable}) {
    if (!name.empty()) {
      names.insert(name);
    }
  }
}

}  // namespace

struct Condition::Node : internal::ConditionNode {
  explicit Node(internal::ConditionNode&& node) : internal::ConditionNode(std::move(node)) {}
};

Condition::Condition(std::string text, std::unique_ptr<Node> root)
    : text_(std::move(text)), root_(std::move(root)) {}
Condition::Condition(Condition&&) noexcept = default;
Condition& Condition::operator=(Condition&&) noexcept = default;
Condition::~Condition() = default;
Condition::Condition(const Condition& other)
    : text_(other.text_),
      root_(std::make_unique<Node>(internal::CopyOf(*other.root_))),
      seen_(other.seen_) {}
Condition& Condition::operator=(const Condition& other) {
  Condition copy(other);
  return *this = std::move(copy);
}

Expected<Condition> Condition::Parse(std::string_view text) {
  Expected<internal::ConditionNode> root = internal::ParseConditionNode(text);
  if (!root) {
    return root.error();
  }
  return Condition(std::string(Trim(text)), std::make_unique<Node>(*std::move(root)));
}

Expected<Condition> Condition::ParseWithCommas(std::string_view text) {
  Expected<Condition> as_written = Parse(text);
  if (as_written || text.find(',') == std::string_view::npos) return as_written;
  std::string with_equals(text);
  std::ranges::replace(with_equals, ',', '=');
  return Parse(with_equals);
}

bool Condition::Holds(const ValueLookup& lookup, Seconds utc_now) {
  return Evaluation(lookup, utc_now, seen_).Holds(*root_);
}

std::vector<std::string> Condition::Variables() const {
  std::set<std::string> names;
  CollectVariables(*root_, names);
  return {names.begin(), names.end()};
}

const Condition::Comparison* Condition::comparison() const {
  return root_->kind == ConditionNode::Kind::kComparison ? &root_->comparison : nullptr;
}

bool MatchesFields(std::string_view a, std::string_view b) {
  const auto fields = [](std::string_view text) {
    std::vector<std::string> parts = Split(text, ':');
    for (std::string& part : parts) {
      part = std::string(Trim(part));
    }
    return parts;
  };
  std::vector<std::string> shorter = fields(a);
  std::vector<std::string> longer = fields(b);
  if (shorter.size() > longer.size()) {
    shorter.swap(longer);
  }
  return std::search(longer.begin(), longer.end(), shorter.begin(), shorter.end()) != longer.end();
}

}  // namespace limpet
