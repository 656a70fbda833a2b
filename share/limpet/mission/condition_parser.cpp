// SPDX-License-Identifier: MIT
#include "limpet/mission/condition_parser.hpp"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::internal {
namespace {

constexpr int kMaxNesting = 100;  // both far beyond any condition a person writes
constexpr std::size_t kMaxConditionBytes = 4096;

/// True if the first parenthesis closes at the very end.
bool IsParenthesised(std::string_view text) {
  text = Trim(text);
  if (!text.starts_with('(')) {
    return false;
  }
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : 0;
    depth -= text[i] == ')' ? 1 : 0;
    if (depth == 0) {
      return i + 1 == text.size();
    }
  }
  return false;
}

bool IsNegation(std::string_view text) {
  text = Trim(text);
  return text.starts_with('!') && IsParenthesised(text.substr(1));
}

/// The complaint about a text's parentheses, if there is one. Judged at once, before any are taken
/// off: each level is looked through again, which would take the square of a long text.
std::optional<Error> ParenthesesProblem(std::string_view text) {
  int depth = 0;
  for (const char letter : text) {
    depth += letter == '(' ? 1 : 0;
    depth -= letter == ')' ? 1 : 0;
    if (depth > kMaxNesting) {
      return Error{"nested too deeply"};
    }
    if (depth < 0) {
      break;
    }
  }
  return depth == 0 ? std::nullopt : std::optional(Error{"parentheses do not match"});
}

std::string_view WithoutOuterParentheses(std::string_view text) {
  text = Trim(text);
  while (IsParenthesised(text)) {
    text = Trim(text.substr(1, text.size() - 2));
  }
  return text;
}

/// The first connective or comparison outside of parentheses.
struct Operator {
  std::size_t begin = 0;
  std::string_view text;
};

bool IsBreak(char letter) { return letter == ' ' || letter == '\t'; }

std::optional<Operator> OperatorAt(std::string_view text, std::size_t at) {
  const bool is_after_break = at > 0 && (IsBreak(text[at - 1]) || text[at - 1] == ')');
  for (const std::string_view word : {"and", "or"}) {
    const std::size_t end = at + word.size();
    if (is_after_break && end < text.size() && (IsBreak(text[end]) || text[end] == '(') &&
        EqualsIgnoringCase(text.substr(at, word.size()), word)) {
      return Operator{at, word};
    }
  }
  for (const std::string_view symbol : {"==", "=", "!=", ">=", "<=", ">", "<"}) {
    if (text.substr(at).starts_with(symbol)) {
      return Operator{at, symbol};
    }
  }
  return std::nullopt;
}

std::optional<Operator> FirstOperator(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : 0;
    depth -= text[i] == ')' ? 1 : 0;
    if (depth == 0) {
      if (const auto found = OperatorAt(text, i)) {
        return found;
      }
    }
  }
  return std::nullopt;
}

constexpr std::string_view kReserved = "\"><=!()";

bool IsWord(std::string_view text, std::string_view word) { return EqualsIgnoringCase(text, word); }

bool IsVariable(std::string_view text) {
  return !text.empty() && text.find_first_of(kReserved) == std::string_view::npos &&
         !IsWord(text, "and") && !IsWord(text, "or");
}

bool IsLiteral(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.starts_with('"') && text.ends_with('"');
  const std::string_view inner = is_quoted ? text.substr(1, text.size() - 2) : text;
  const bool is_connective = !is_quoted && (IsWord(text, "and") || IsWord(text, "or"));
  return !text.empty() && !is_connective &&
         inner.find_first_of(kReserved) == std::string_view::npos;
}

Expected<ConditionNode> ParseNode(std::string_view text, int depth);

Expected<ConditionNode> ParseComparison(std::string_view text, const Operator& op) {
  ConditionNode node;
  node.comparison = {.left = std::string(Trim(text.substr(0, op.begin))),
                     .op = std::string(op.text),
                     .right = std::string(Trim(text.substr(op.begin + op.text.size())))};
  const std::string_view right = node.comparison.right;
  if (!IsVariable(node.comparison.left)) {
    return Error{fmt::format("`{}` is no name of a variable", node.comparison.left)};
  }
  if (right.starts_with("$(") && right.ends_with(')') &&
      IsVariable(Trim(right.substr(2, right.size() - 3)))) {
    node.right_variable = std::string(Trim(right.substr(2, right.size() - 3)));
  } else if (!IsLiteral(right)) {
    return Error{fmt::format("`{}` is no number, literal or $(VARIABLE)", right)};
  }
  return node;
}

Expected<ConditionNode> ParseConnective(std::string_view text, const Operator& op, int depth) {
  const std::string_view sides[] = {text.substr(0, op.begin),
                                    text.substr(op.begin + op.text.size())};
  std::array<std::unique_ptr<ConditionNode>, 2> children;
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (!IsParenthesised(sides[i]) && !IsNegation(sides[i])) {
      return Error{fmt::format("each side of `{}` must be in parentheses; `{}` is not", op.text,
                               Trim(sides[i]))};
    }
    Expected<ConditionNode> child = ParseNode(sides[i], depth + 1);
    if (!child) {
      return child;
    }
    children[i] = std::make_unique<ConditionNode>(*std::move(child));
  }
  ConditionNode node;
  node.kind = op.text == "and" ? ConditionNode::Kind::kAnd : ConditionNode::Kind::kOr;
  node.left = std::move(children[0]);
  node.right = std::move(children[1]);
  return node;
}

Expected<ConditionNode> ParseNode(std::string_view text, int depth) {
  if (depth > kMaxNesting) {
    return Error{"nested too deeply"};
  }
  text = WithoutOuterParentheses(text);
  if (IsNegation(text)) {
    Expected<ConditionNode> inner = ParseNode(text.substr(1), depth + 1);
    if (!inner) {
      return inner;
    }
    ConditionNode node;
    node.kind = ConditionNode::Kind::kNot;
    node.left = std::make_unique<ConditionNode>(*std::move(inner));
    return node;
  }
  const std::optional<Operator> op = FirstOperator(text);
  if (!op) {
    return Error{fmt::format("`{}` has no comparison (= == != < <= > >=)", text)};
  }
  const bool is_connective = op->text == "and" || op->text == "or";
  return is_connective ? ParseConnective(text, *op, depth) : ParseComparison(text, *op);
}

}  // namespace

ConditionNode CopyOf(const ConditionNode& node) {
  ConditionNode copy;
  copy.kind = node.kind;
  copy.comparison = node.comparison;
  copy.right_variable = node.right_variable;
  copy.left = node.left ? std::make_unique<ConditionNode>(CopyOf(*node.left)) : nullptr;
  copy.right = node.right ? std::make_unique<ConditionNode>(CopyOf(*node.right)) : nullptr;
  return copy;
}

Expected<ConditionNode> ParseConditionNode(std::string_view text) {
  if (Trim(text).empty()) {
    return Error{"is empty"};
  }
  if (text.size() > kMaxConditionBytes) {
    return Error{fmt::format("is longer than {} bytes", kMaxConditionBytes)};
  }
  if (auto problem = ParenthesesProblem(text)) {
    return *std::move(problem);
  }
  return ParseNode(text, 0);
}

}  // namespace limpet::internal
