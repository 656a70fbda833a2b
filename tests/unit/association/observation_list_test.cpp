// SPDX-License-Identifier: MIT
#include "estimation/association/observation_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Observation VoteFor(const std::string& color, double confidence) {
  Observation one;
  one.color = color;
  one.confidence = confidence;
  return one;
}

std::vector<Observation> DrawVotes(Random& random) {
  const std::array<std::string, 3> classes{"red", "blue", "green"};
  std::vector<Observation> boxes;
  for (std::uint64_t i = 1 + random.Index(12); i > 0; --i)
    boxes.push_back(VoteFor(classes[random.Index(3)], 0.25 * (1.0 + random.Uniform(0.0, 3.0))));
  return boxes;
}

ObservationList ListOf(const std::vector<Observation>& boxes) {
  ObservationList list;
  for (const Observation& one : boxes)
    list.Add(one);
  return list;
}

TEST(ObservationListClass, IsTheOneWithTheMostConfidenceInWhateverOrderBoxesCome) {
  Random random(41);
  for (int i = 0; i < 300; ++i) {
    std::vector<Observation> boxes = DrawVotes(random);
    const std::string color = ListOf(boxes).color();
    const ObservationList list = ListOf(boxes);
    for (const auto& [name, votes] : list.votes())
      EXPECT_LE(votes, list.votes().at(color) + 1e-12);
    std::ranges::shuffle(boxes, random.engine());
    EXPECT_EQ(ListOf(boxes).color(), color);
  }
}

TEST(ObservationListClass, IsThatOfTheBoxesThatStay) {
  Random random(42);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Observation> boxes = DrawVotes(random);
    ObservationList list = ListOf(boxes);
    list.RemoveFirst();
    const ObservationList counted_anew = ListOf({boxes.begin() + 1, boxes.end()});
    EXPECT_EQ(list.color(), counted_anew.color());
    EXPECT_EQ(list.votes(), counted_anew.votes());
  }
}

TEST(ObservationListClass, OfEqualVotesIsTheFirstInTheAlphabetHoweverItIsCounted) {
  for (const auto& [first, second] :
       {std::pair("red", "blue"), std::pair("blue", "red"), std::pair("green", "blue")}) {
    ObservationList list =
        ListOf({VoteFor("green", 0.5), VoteFor(first, 0.75), VoteFor(second, 0.75)});
    EXPECT_EQ(list.color(), first == std::string("green") ? "green" : "blue");
    list.RemoveFirst();
    EXPECT_EQ(list.color(), "blue") << first << ", then " << second;
  }
}

TEST(ObservationListClass, ChangesWithTheBoxesThatAreTakenOut) {
  ObservationList list = ListOf({VoteFor("red", 0.9), VoteFor("blue", 0.8), VoteFor("red", 0.7)});
  EXPECT_EQ(list.color(), "red");
  const auto taken = list.TakeIf([](const Observation& one) { return one.color == "red"; });
  EXPECT_EQ(list.color(), "blue");
  EXPECT_EQ(list.size(), 1U);
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].confidence, 0.9) << "in their order";
  EXPECT_EQ(taken[1].confidence, 0.7);
  EXPECT_EQ(list.TakeAll().size(), 1U);
  EXPECT_EQ(list.color(), "");
  EXPECT_TRUE(list.votes().empty());
  EXPECT_TRUE(list.empty());
}

TEST(ObservationList, IsSortedByFrameAndOfOneFrameAsItCame) {
  ObservationList list = ListOf({VoteFor("red", 0.1), VoteFor("red", 0.2), VoteFor("red", 0.3)});
  list[0].frame = 7;
  list[1].frame = list[2].frame = 5;
  list.Sort();
  std::vector<double> order;
  for (const Observation& one : list)
    order.push_back(one.confidence);
  EXPECT_EQ(order, (std::vector{0.2, 0.3, 0.1}));
}

TEST(ObservationListLogOdds, AddsWhatEachBoxSaysAndTakesNoneForProof) {
  EXPECT_EQ(ListOf({}).LogOdds(), 0.0);
  EXPECT_NEAR(ListOf({VoteFor("red", 0.8), VoteFor("red", 0.5)}).LogOdds(), std::log(4.0), 1e-12);
  EXPECT_NEAR(ListOf({VoteFor("red", 1.0)}).LogOdds(), std::log(19.0), 1e-12);
  EXPECT_NEAR(ListOf({VoteFor("red", 0.0)}).LogOdds(), -std::log(19.0), 1e-12);
}

TEST(ObservationListLogOdds, ASurerBoxNeverSpeaksAgainstTheObject) {
  Random random(43);
  for (int i = 0; i < 300; ++i) {
    std::vector<Observation> boxes = DrawVotes(random);
    const double before = ListOf(boxes).LogOdds();
    boxes[random.Index(boxes.size())].confidence += random.Uniform(0.0, 0.5);
    EXPECT_GE(ListOf(boxes).LogOdds(), before);
  }
}

}  // namespace
}  // namespace limpet
