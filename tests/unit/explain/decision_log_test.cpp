// SPDX-License-Identifier: MIT
#include "limpet/explain/decision_log.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

std::string Mail(int path_id) {
  HelmBids bids;
  bids.path_id = path_id;
  return std::get<std::string>(TopicCodec<HelmBids>::Encode(bids));
}

TEST(DecisionLog, KnowsWhichDecisionIsInForce) {
  DecisionLog log;
  log.Take("HELM_BIDS", Mail(1), 10.0);
  log.Take("HELM_PATH", "{}", 10.0);
  log.Take("HELM_BIDS", Mail(2), 26.0);
  EXPECT_EQ(log.InForceAt(9.9), nullptr);
  EXPECT_EQ(log.InForceAt(10.0)->bids.path_id, 1);
  EXPECT_EQ(log.InForceAt(25.9)->bids.path_id, 1);
  EXPECT_EQ(log.InForceAt(1e9)->bids.path_id, 2);
}

TEST(DecisionLog, CountsWhatIsNoDecision) {
  DecisionLog log;
  log.Take("HELM_BIDS", "{\"path_id\":", 1.0);
  log.Take("HELM_BIDS",
           R"({"path_id":1,"cause":"","considered":0,"options":[],"ranked_by":"colour"})", 2.0);
  EXPECT_EQ(log.unreadable(), 2U);
  EXPECT_TRUE(log.decisions().empty());
}

TEST(DecisionLog, ReadsLogsThatDoNotSayByWhatOptionsWereRanked) {
  DecisionLog log;
  log.Take("HELM_BIDS", R"({"path_id":7,"cause":"arrived","considered":0,"options":[]})", 1.0);
  ASSERT_EQ(log.decisions().size(), 1U);
  EXPECT_EQ(log.decisions()[0].bids.order, OptionOrder::kPerMetre);
}

}  // namespace
}  // namespace limpet
