// SPDX-License-Identifier: MIT
#include "limpet/helm/warning_book.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

WarningId Declared(const char* id) {
  return DeclareWarning(id, {.severity = Severity::kWarning,
                             .raised_by = {"BHV_Test"},
                             .meaning = "It is so.",
                             .action = "Look.",
                             .clears = "When it is over."});
}
const WarningId kAny = Declared("ANY_ID");
const WarningId kAnother = Declared("ANOTHER_ID");

std::vector<std::string> ClearedBy(const WarningBook::Change& change) {
  std::vector<std::string> names;
  for (const WarningId& id : change.cleared) {
    names.push_back(id.name());
  }
  return names;
}

TEST(WarningBook, KeepsAWarningUntilItsOwnerFallsSilent) {
  WarningBook book;
  const std::vector<OwnedWarning> lost{{"altitude", {kAny, "no bottom lock"}}};
  for (int tick = 0; tick < 2; ++tick) {
    const WarningBook::Change change = book.Update(lost);
    ASSERT_EQ(change.standing.size(), 1U);
    EXPECT_EQ(change.standing[0].text, "altitude: no bottom lock");
    EXPECT_TRUE(change.cleared.empty());
  }
  EXPECT_EQ(ClearedBy(book.Update({})), std::vector<std::string>{"ANY_ID"});
  EXPECT_TRUE(book.Update({}).cleared.empty());
}

TEST(WarningBook, ClearsOneWhileAnotherStands) {
  WarningBook book;
  const OwnedWarning one{"a", {kAny, "one"}};
  const OwnedWarning two{"b", {kAnother, "two"}};
  static_cast<void>(book.Update({one, two}));
  const WarningBook::Change change = book.Update({two});
  EXPECT_EQ(ClearedBy(change), std::vector<std::string>{"ANY_ID"});
  ASSERT_EQ(change.standing.size(), 1U);
  EXPECT_EQ(change.standing[0].id.name(), "ANOTHER_ID");
}

TEST(WarningBook, KeepsAWarningThatAnotherBehaviorRaisesToo) {
  WarningBook book;
  const OwnedWarning low{"low", {kAny, "no lock"}};
  const OwnedWarning high{"high", {kAny, "no lock"}};
  EXPECT_EQ(book.Update({low, high}).standing.at(0).text, "low, high: no lock");
  const WarningBook::Change change = book.Update({high});
  EXPECT_TRUE(change.cleared.empty());
  ASSERT_EQ(change.standing.size(), 1U);  // told anew under the one that is left
  EXPECT_EQ(change.standing[0].text, "high: no lock");
}

TEST(WarningBook, LetsTheTextFollow) {
  WarningBook book;
  static_cast<void>(book.Update({{"low", {kAny, "1 m"}}}));
  EXPECT_EQ(book.Update({{"low", {kAny, "2 m"}}}).standing.at(0).text, "low: 2 m");
}

}  // namespace
}  // namespace limpet
