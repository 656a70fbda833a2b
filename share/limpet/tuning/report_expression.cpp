// SPDX-License-Identifier: MIT
#include "limpet/tuning/report_expression.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/tuning/expression_words.hpp"

namespace limpet {

enum class Operation {
  kNumber,
  kKey,
  kNegate,
  kNot,
  kPower,
  kTimes,
  kOver,
  kPlus,
  kMinus,
  kLess,
  kAtMost,
  kMore,
  kAtLeast,
  kEqual,
  kUnequal,
  kAnd,
  kOr,
  kMin,
  kMax,
  kAbs,
  kSqrt
};

struct ReportExpression::Node {
  Operation operation = Operation::kNumber;
  double number = 0.0;
  std::string key{};
  std::vector<std::shared_ptr<const Node>> inner{};
};

namespace {

using Node = ReportExpression::Node;
using NodePtr = std::shared_ptr<const Node>;

/// Where reading stopped, and why; thrown inside of Parse only.
struct Complaint {
  std::size_t at = 0;
  std::string text;
};

struct Infix {
  std::string_view sign;
  Operation operation;
};
using Level = std::vector<Infix>;

/// Loosest first. Of signs that begin alike the longer comes first.
const std::vector<Level>& InfixLevels() {
  static const std::vector<Level> levels{{{"or", Operation::kOr}},
                                         {{"and", Operation::kAnd}},
                                         {{"<=", Operation::kAtMost},
                                          {">=", Operation::kAtLeast},
                                          {"==", Operation::kEqual},
                                          {"!=", Operation::kUnequal},
                                          {"<", Operation::kLess},
                                          {">", Operation::kMore}},
                                         {{"+", Operation::kPlus}, {"-", Operation::kMinus}},
                                         {{"*", Operation::kTimes}, {"/", Operation::kOver}}};
  return levels;
}

constexpr std::size_t kComparisonLevel = 2;

struct Function {
  std::string_view name;
  Operation operation;
  std::size_t least = 1, most = 1;
};
constexpr std::array<Function, 4> kFunctions{{{"min", Operation::kMin, 1, 64},
                                              {"max", Operation::kMax, 1, 64},
                                              {"abs", Operation::kAbs},
                                              {"sqrt", Operation::kSqrt}}};

class ExpressionReader {
 public:
  explicit ExpressionReader(std::string_view text) : words_(text) {}

  NodePtr ReadAll() {
    NodePtr root = ReadLevel(0);
    if (!words_.IsAtEnd()) Complain("an operator or the end is expected");
    return root;
  }
  [[nodiscard]] const std::set<std::string>& keys() const { return keys_; }

 private:
  [[noreturn]] void Complain(const std::string& text) const {
    throw Complaint{words_.position(), text};
  }

  static NodePtr Make(Operation operation, std::vector<NodePtr> inner) {
    return std::make_shared<const Node>(Node{.operation = operation, .inner = std::move(inner)});
  }

  NodePtr ReadLevel(std::size_t level) {
    if (level == InfixLevels().size()) return ReadSigned();
    if (level == kComparisonLevel && words_.Take("not")) {
      const Depth deeper(*this);
      return Make(Operation::kNot, {ReadLevel(level)});
    }
    NodePtr left = ReadLevel(level + 1);
    while (const Infix* infix = TakeInfix(level)) {
      left = Make(infix->operation, {left, ReadLevel(level + 1)});
      if (level == kComparisonLevel && TakeInfix(level) != nullptr) {
        Complain("comparisons do not chain: write `a < b and b < c`");
      }
    }
    return left;
  }

  const Infix* TakeInfix(std::size_t level) {
    for (const Infix& infix : InfixLevels()[level]) {
      if (words_.Take(infix.sign)) return &infix;
    }
    return nullptr;
  }

  NodePtr ReadSigned() {
    const Depth deeper(*this);
    if (words_.Take("-")) return Make(Operation::kNegate, {ReadSigned()});
    if (words_.Take("+")) return ReadSigned();
    NodePtr base = ReadOperand();
    if (words_.Take("^")) return Make(Operation::kPower, {base, ReadSigned()});
    return base;
  }

  NodePtr ReadOperand() {
    if (words_.Take("(")) {
      NodePtr inner = ReadLevel(0);
      if (!words_.Take(")")) Complain("`)` is expected");
      return inner;
    }
    if (const auto number = words_.TakeNumber()) {
      return std::make_shared<const Node>(Node{.number = *number});
    }
    const std::size_t begin = words_.position();
    const std::string name = words_.TakeName();
    if (name.empty()) Complain("a number, a key of report.json or `(` is expected");
    if (words_.Take("(")) return ReadCall(name, begin);
    keys_.insert(name);
    return std::make_shared<const Node>(Node{.operation = Operation::kKey, .key = name});
  }

  NodePtr ReadCall(const std::string& name, std::size_t begin) {
    const auto* const function = std::ranges::find(kFunctions, name, &Function::name);
    if (function == kFunctions.end()) {
      throw Complaint{begin,
                      fmt::format("no function `{}`; there are min, max, abs and sqrt", name)};
    }
    std::vector<NodePtr> arguments;
    do {
      arguments.push_back(ReadLevel(0));
    } while (words_.Take(","));
    if (!words_.Take(")")) Complain("`,` or `)` is expected");
    if (arguments.size() < function->least || arguments.size() > function->most) {
      throw Complaint{begin,
                      fmt::format("{} takes {}", name,
                                  function->most == 1 ? "one argument" : "up to 64 arguments")};
    }
    return Make(function->operation, std::move(arguments));
  }

  /// Counts one step deeper while it lives.
  class Depth {
   public:
    explicit Depth(ExpressionReader& reader) : reader_(reader) {
      if (++reader_.depth_ > ReportExpression::kMaxDepth) {
        reader_.Complain(fmt::format("nested deeper than {}", ReportExpression::kMaxDepth));
      }
    }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    ~Depth() { --reader_.depth_; }

   private:
    ExpressionReader& reader_;
  };

  ExpressionWords words_;
  std::set<std::string> keys_;
  int depth_ = 0;
};

double Truth(bool is_true) { return is_true ? 1.0 : 0.0; }

double OfTwo(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::kPower:
      return std::pow(a, b);
    case Operation::kTimes:
      return a * b;
    case Operation::kOver:
      return a / b;
    case Operation::kPlus:
      return a + b;
    case Operation::kMinus:
      return a - b;
    case Operation::kLess:
      return Truth(a < b);
    case Operation::kAtMost:
      return Truth(a <= b);
    case Operation::kMore:
      return Truth(a > b);
    case Operation::kAtLeast:
      return Truth(a >= b);
    case Operation::kEqual:
      return Truth(a == b);
    case Operation::kUnequal:
      return Truth(a != b);
    case Operation::kAnd:
      return Truth(a != 0.0 && b != 0.0);
    case Operation::kOr:
      return Truth(a != 0.0 || b != 0.0);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

std::optional<double> ValueOf(const Node& node, const ReportValues& report) {
  if (node.operation == Operation::kNumber) return node.number;
  if (node.operation == Operation::kKey) return report.Find(node.key);
  std::vector<double> inner;
  for (const NodePtr& each : node.inner) {
    const std::optional<double> value = ValueOf(*each, report);
    if (!value) return std::nullopt;
    inner.push_back(*value);
  }
  const double result = [&] {
    switch (node.operation) {
      case Operation::kNegate:
        return -inner[0];
      case Operation::kNot:
        return Truth(inner[0] == 0.0);
      case Operation::kAbs:
        return std::abs(inner[0]);
      case Operation::kSqrt:
        return std::sqrt(inner[0]);
      case Operation::kMin:
        return *std::ranges::min_element(inner);
      case Operation::kMax:
        return *std::ranges::max_element(inner);
      default:
        return OfTwo(node.operation, inner[0], inner[1]);
    }
  }();
  return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace

Expected<ReportExpression> ReportExpression::Parse(std::string_view text) {
  if (text.size() > kMaxBytes) {
    return Error{fmt::format("an expression of {} bytes; at most {}", text.size(), kMaxBytes)};
  }
  try {
    ExpressionReader reader(text);
    ReportExpression expression;
    expression.root_ = reader.ReadAll();
    expression.keys_ = reader.keys();
    expression.text_ = text;
    return expression;
  } catch (const Complaint& complaint) {
    return Error{fmt::format("`{}`, at {}: {}", text, complaint.at + 1, complaint.text)};
  }
}

std::optional<double> ReportExpression::Evaluate(const ReportValues& report) const {
  return ValueOf(*root_, report);
}

std::optional<std::string> ReportExpression::UnknownKey(const ReportValues& report) const {
  for (const std::string& key : keys_) {
    if (report.Has(key)) continue;
    const std::string nearest = NearestWord(key, report.Keys());
    return fmt::format("`{}`, at {}: report.json has no `{}`{}", text_, text_.find(key) + 1, key,
                       nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
  }
  return std::nullopt;
}

bool ReportExpression::is_condition() const {
  const Operation outer = root_->operation;
  return outer == Operation::kNot || (outer >= Operation::kLess && outer <= Operation::kOr);
}

}  // namespace limpet
