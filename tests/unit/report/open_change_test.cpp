// SPDX-License-Identifier: MIT
#include "limpet/report/open_change.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

std::string TextWith(const StatusPosterior& posterior, Status decided = Status::kUncertain) {
  ChangeScore change;
  change.decided = decided;
  change.posterior = posterior;
  return OpenText(change);
}

TEST(OpenChange, NamesTheTwoLikeliestStatusesLikeliestFirst) {
  EXPECT_EQ(TextWith({.confirmed = 0.1, .removed = 0.2, .appeared = 0.3, .nothing = 0.4}),
            "open: nothing or new");
}

TEST(OpenChange, NamesEquallyLikelyOnesInAnOrderThatNeverChanges) {
  EXPECT_EQ(TextWith({0.25, 0.25, 0.25, 0.25}), "open: confirmed or removed");
  EXPECT_EQ(TextWith({.removed = 0.5, .nothing = 0.5}), "open: removed or nothing");
}

TEST(OpenChange, IsOpenAloneWhereNoLookSaysAnything) {
  EXPECT_EQ(TextWith({.confirmed = 0.5, .removed = 0.5}, Status::kNotInspected), "open");
  EXPECT_EQ(OpenText(ChangeScore{}), "open");
}

}  // namespace
}  // namespace limpet
