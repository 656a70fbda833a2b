// SPDX-License-Identifier: MIT
// Random conditions, written out as a mission file has them, against what they mean.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/number_text.hpp"
#include "limpet/core/random.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet {
namespace {

using Facts = std::map<std::string, double>;

/// A condition as text, and the same as a function of the facts.
struct Meant {
  std::string text;
  std::function<bool(const Facts&)> holds;
};

Meant RandomComparison(Random& random) {
  const std::array<const char*, 4> names{"A", "B", "C", "UNKNOWN"};
  const std::array<const char*, 6> operators{"=", "!=", "<", "<=", ">", ">="};
  const std::string name = names[random.Index(names.size())];
  const std::string op = operators[random.Index(operators.size())];
  const double limit = static_cast<double>(random.Index(5)) - 2.0;
  return {name + " " + op + " " + TextOf(limit), [=](const Facts& facts) {
            const auto found = facts.find(name);
            if (found == facts.end()) return false;  // `!=` included
            const double value = found->second;
            if (op == "=") return value == limit;
            if (op == "!=") return value != limit;
            if (op == "<") return value < limit;
            if (op == "<=") return value <= limit;
            return op == ">" ? value > limit : value >= limit;
          }};
}

Meant RandomCondition(Random& random, int depth) {
  if (depth == 0 || random.Chance(0.3)) return RandomComparison(random);
  const Meant left = RandomCondition(random, depth - 1);
  if (random.Chance(0.25)) {
    return {"!(" + left.text + ")", [=](const Facts& facts) { return !left.holds(facts); }};
  }
  const Meant right = RandomCondition(random, depth - 1);
  const bool is_and = random.Chance(0.5);
  return {"(" + left.text + ") " + (is_and ? "and" : "or") + " (" + right.text + ")",
          [=](const Facts& facts) {
            return is_and ? left.holds(facts) && right.holds(facts)
                          : left.holds(facts) || right.holds(facts);
          }};
}

TEST(ConditionProperties, HoldWhenTheirTextHolds) {
  Random random(1, "conditions");
  int held = 0;
  for (int run = 0; run < 1500; ++run) {
    const Meant meant = RandomCondition(random, 4);
    Expected<Condition> condition = Condition::Parse(meant.text);
    ASSERT_TRUE(condition) << meant.text;
    for (int trial = 0; trial < 5; ++trial) {
      Facts facts;
      std::map<std::string, Value, std::less<>> values;
      for (const char* name : {"A", "B", "C"}) {
        if (random.Chance(0.15)) continue;
        facts[name] = static_cast<double>(random.Index(5)) - 2.0;
        values[name] = facts[name];
      }
      Condition fresh = *condition;
      const bool holds = fresh.Holds(
          [&values](std::string_view name) {
            const auto found = values.find(name);
            return found == values.end() ? nullptr : &found->second;
          },
          Seconds(0.0));
      held += holds ? 1 : 0;
      EXPECT_EQ(holds, meant.holds(facts)) << meant.text;
    }
  }
  EXPECT_GT(held, 1000);
  EXPECT_LT(held, 6500);
}

TEST(ConditionProperties, KnowEveryVariableThatTheyReadOnce) {
  Random random(2, "variables");
  for (int run = 0; run < 300; ++run) {
    const Meant meant = RandomCondition(random, 4);
    std::set<std::string> expected;
    for (const char* name : {"A", "B", "C", "UNKNOWN"}) {
      if (meant.text.find(std::string(name) + " ") != std::string::npos) expected.insert(name);
    }
    const auto variables = Condition::Parse(meant.text)->Variables();
    EXPECT_EQ(std::set<std::string>(variables.begin(), variables.end()), expected) << meant.text;
    EXPECT_EQ(variables.size(), expected.size());
  }
}

TEST(ConditionProperties, BlanksDoNotMatter) {
  Random random(3, "blanks");
  const auto holds = [](const std::string& text) {
    Expected<Condition> condition = Condition::Parse(text);
    EXPECT_TRUE(condition) << text;
    const Value one = 1.0;
    return condition && condition->Holds([&one](std::string_view) { return &one; }, Seconds(0.0));
  };
  for (int run = 0; run < 300; ++run) {
    const Meant meant = RandomCondition(random, 3);
    std::string spread;
    for (const char letter : meant.text) {
      spread += letter;
      if (letter == '(' || letter == ')') spread += "  ";
    }
    EXPECT_EQ(holds("  " + spread + " "), holds(meant.text)) << spread;
  }
}

TEST(ConditionProperties, LostOrDoubledCharactersNeverCrashAndSayWhy) {
  Random random(4, "spoilt");
  int refused = 0;
  for (int run = 0; run < 3000; ++run) {
    std::string text = RandomCondition(random, 3).text;
    const std::size_t at = random.Index(text.size());
    if (random.Chance(0.5)) {
      text.erase(at, 1);
    } else {
      text.insert(at, 1, "()=<>!\"$ "[random.Index(9)]);
    }
    const Expected<Condition> condition = Condition::Parse(text);
    if (!condition) {
      ++refused;
      EXPECT_FALSE(condition.error().text.empty()) << text;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(FieldMatches, AreContiguousWholeFieldsEitherWay) {
  Random random(5, "fields");
  const auto fields = [&random] {
    std::vector<std::string> made;
    for (std::uint64_t i = 1 + random.Index(4); i > 0; --i) {
      made.emplace_back(1, static_cast<char>('a' + random.Index(2)));
    }
    return made;
  };
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts)
      text += (text.empty() ? "" : ":") + part;
    return text;
  };
  const auto holds_in = [](const std::vector<std::string>& all,
                           const std::vector<std::string>& part) {
    return std::search(all.begin(), all.end(), part.begin(), part.end()) != all.end();
  };
  for (int run = 0; run < 2000; ++run) {
    const auto a = fields(), b = fields();
    EXPECT_EQ(MatchesFields(joined(a), joined(b)), holds_in(a, b) || holds_in(b, a))
        << joined(a) << " " << joined(b);
  }
}

}  // namespace
}  // namespace limpet
