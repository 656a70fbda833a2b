// SPDX-License-Identifier: MIT
#include "limpet/helm/look_ledger.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

class LookLedgerTest : public ::testing::Test {
 protected:
  LookLedgerTest() {
    belief_.id = 7;
    belief_.object.p_W = {10.0, 0.0, 6.0};
    belief_.posterior = {.confirmed = 0.7, .removed = 0.3};
    ledger_.SetBeliefs({belief_});
  }
  static DubinsPath North(double length) { return DubinsPath({}, {{0.0, length}}); }
  void Promise(const DubinsPath& path, double travelled) {
    const WatchedObject object{.belief = belief_, .window = LookWindow{1.0, 1.0}};
    ledger_.Promise(path, std::span(&object, 1), travelled);
  }
  OpiBelief belief_;
  LookLedger ledger_;
};

TEST_F(LookLedgerTest, CountsALookThatWasFlownAndToldNothing) {
  Promise(North(20.0), 0.0);
  EXPECT_FALSE(ledger_.Judge(10.0));  // just flown: the map has not answered yet
  EXPECT_TRUE(ledger_.Judge(13.0));
  EXPECT_EQ(ledger_.fruitless(7), 1);
  EXPECT_FALSE(ledger_.Judge(30.0));  // one promise, one look
}

TEST_F(LookLedgerTest, CountsNoLookThatToldSomething) {
  Promise(North(20.0), 0.0);
  belief_.looks = 1;
  ledger_.SetBeliefs({belief_});
  EXPECT_FALSE(ledger_.Judge(13.0));
  EXPECT_EQ(ledger_.fruitless(7), 0);
}

TEST_F(LookLedgerTest, StartsAnewWhenTheBeliefChanges) {
  Promise(North(20.0), 0.0);
  EXPECT_TRUE(ledger_.Judge(13.0));
  belief_.posterior = {.confirmed = 0.9, .removed = 0.1};
  ledger_.SetBeliefs({belief_});
  EXPECT_EQ(ledger_.fruitless(7), 0);
}

TEST_F(LookLedgerTest, DropsAPromiseThatTheHelmTookBack) {
  Promise(North(20.0), 0.0);
  Promise(DubinsPath({5.0, 0.0, 3.0}, {{0.0, 20.0}}), 5.0);
  EXPECT_FALSE(ledger_.Judge(20.0));
}

TEST_F(LookLedgerTest, CountsALookThatEachNewPathPutsOff) {
  for (double travelled = 0.0; travelled < 24.0; travelled += 8.0) {
    Promise(North(20.0), travelled);  // always 9 m ahead, never reached
    static_cast<void>(ledger_.Judge(travelled + 7.9));
  }
  EXPECT_EQ(ledger_.fruitless(7), 1);
}

TEST_F(LookLedgerTest, ForgetsObjectsThatAreGone) {
  Promise(North(20.0), 0.0);
  ledger_.SetBeliefs({});
  EXPECT_FALSE(ledger_.Judge(13.0));
  EXPECT_EQ(ledger_.fruitless(7), 0);
}

}  // namespace
}  // namespace limpet
