// SPDX-License-Identifier: MIT
#include "limpet/helm/warning_book.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(WarningBook, RaisesOnceAndClearsWhenItsOwnerFallsSilent) {
  WarningBook book;
  const std::vector<OwnedWarning> lost{{"altitude", {"ALTITUDE_LOST", "no bottom lock"}}};
  const WarningBook::Change first = book.Update(lost);
  ASSERT_EQ(first.raised.size(), 1U);
  EXPECT_EQ(first.raised[0].text, "altitude: no bottom lock");
  EXPECT_TRUE(book.Update(lost).raised.empty());
  EXPECT_EQ(book.Update({}).cleared, std::vector<std::string>{"ALTITUDE_LOST"});
  EXPECT_TRUE(book.Update({}).cleared.empty());
}

TEST(WarningBook, ClearsOneWhileAnotherStands) {
  WarningBook book;
  const OwnedWarning one{"a", {"ANY_ID", "one"}};
  const OwnedWarning two{"b", {"ANOTHER_ID", "two"}};
  static_cast<void>(book.Update({one, two}));
  const WarningBook::Change change = book.Update({two});
  EXPECT_EQ(change.cleared, std::vector<std::string>{"ANY_ID"});
  EXPECT_TRUE(change.raised.empty());
}

TEST(WarningBook, KeepsAWarningThatAnotherBehaviorRaisesToo) {
  WarningBook book;
  const OwnedWarning low{"low", {"ALTITUDE_LOST", "no lock"}};
  const OwnedWarning high{"high", {"ALTITUDE_LOST", "no lock"}};
  static_cast<void>(book.Update({low, high}));
  const WarningBook::Change change = book.Update({high});
  ASSERT_EQ(change.raised.size(), 1U);  // told anew under the one that is left
  EXPECT_EQ(change.raised[0].text, "high: no lock");
}

}  // namespace
}  // namespace limpet
