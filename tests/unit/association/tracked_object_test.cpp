// SPDX-License-Identifier: MIT
#include "estimation/association/tracked_object.hpp"

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

TrackedObject ObjectWith(const std::vector<Observation>& boxes) {
  TrackedObject object;
  for (const Observation& one : boxes)
    object.Add(one);
  return object;
}

TEST(TrackedObjectClass, IsTheOneWithTheMostConfidenceInWhateverOrderBoxesCome) {
  Random random(41);
  for (int i = 0; i < 300; ++i) {
    std::vector<Observation> boxes = DrawVotes(random);
    const std::string color = ObjectWith(boxes).Color();
    const TrackedObject object = ObjectWith(boxes);
    for (const auto& [name, votes] : object.votes())
      EXPECT_LE(votes, object.votes().at(color) + 1e-12);
    std::ranges::shuffle(boxes, random.engine());
    EXPECT_EQ(ObjectWith(boxes).Color(), color);
  }
}

TEST(TrackedObjectClass, CountedBoxByBoxIsTheOneCountedAnew) {
  Random random(42);
  for (int i = 0; i < 300; ++i) {
    TrackedObject object = ObjectWith(DrawVotes(random));
    const std::string before = object.Color();
    const auto votes = object.votes();
    object.RecountColor();
    EXPECT_EQ(object.Color(), before);
    EXPECT_EQ(object.votes(), votes);
  }
}

TEST(TrackedObjectClass, OfEqualVotesIsTheFirstInTheAlphabetHoweverItIsCounted) {
  for (const auto& [first, second] :
       {std::pair("red", "blue"), std::pair("blue", "red"), std::pair("green", "blue")}) {
    TrackedObject object = ObjectWith({VoteFor(first, 0.75), VoteFor(second, 0.75)});
    EXPECT_EQ(object.Color(), "blue") << first << ", then " << second;
    object.RecountColor();
    EXPECT_EQ(object.Color(), "blue") << first << ", then " << second;
  }
}

TEST(TrackedObjectClass, ChangesWithTheBoxesThatAreTakenOut) {
  TrackedObject object =
      ObjectWith({VoteFor("red", 0.9), VoteFor("red", 0.9), VoteFor("blue", 0.9)});
  EXPECT_EQ(object.Color(), "red");
  object.observations.erase(object.observations.begin(), object.observations.begin() + 2);
  object.RecountColor();
  EXPECT_EQ(object.Color(), "blue");
  object.observations.clear();
  object.RecountColor();
  EXPECT_EQ(object.Color(), "");
  EXPECT_TRUE(object.votes().empty());
}

TEST(TrackedObjectLogOdds, AddsWhatEachBoxSaysAndTakesNoneForProof) {
  EXPECT_EQ(ObjectWith({}).LogOdds(), 0.0);
  EXPECT_NEAR(ObjectWith({VoteFor("red", 0.8), VoteFor("red", 0.5)}).LogOdds(), std::log(4.0),
              1e-12);
  EXPECT_NEAR(ObjectWith({VoteFor("red", 1.0)}).LogOdds(), std::log(19.0), 1e-12);
  EXPECT_NEAR(ObjectWith({VoteFor("red", 0.0)}).LogOdds(), -std::log(19.0), 1e-12);
}

TEST(TrackedObjectLogOdds, ASurerBoxNeverSpeaksAgainstTheObject) {
  Random random(43);
  for (int i = 0; i < 300; ++i) {
    std::vector<Observation> boxes = DrawVotes(random);
    const double before = ObjectWith(boxes).LogOdds();
    boxes[random.Index(boxes.size())].confidence += random.Uniform(0.0, 0.5);
    EXPECT_GE(ObjectWith(boxes).LogOdds(), before);
  }
}

/// What each state makes of a track, as others ask.
struct Standing {
  TrackState state;
  bool is_mapped, is_untied, is_landmark, is_open;
};

TEST(TrackedObjectState, EachStateIsWhatItSays) {
  const std::vector<Standing> all{
      {Tentative{}, false, false, false, false},
      {InDoubt{}, true, true, false, true},
      {Confirmed{.is_on_probation = true}, true, true, true, true},
      {Confirmed{}, true, true, true, false},
      {Tied{.to = 3, .since = 1.0}, true, false, false, true},
      {Gone{}, false, false, false, false},
  };
  for (const Standing& expected : all) {
    TrackedObject object;
    object.state = expected.state;
    EXPECT_EQ(object.is_mapped(), expected.is_mapped) << expected.state.index();
    EXPECT_EQ(object.is_untied(), expected.is_untied) << expected.state.index();
    EXPECT_EQ(object.is_landmark(), expected.is_landmark) << expected.state.index();
    EXPECT_EQ(object.is_open(), expected.is_open) << expected.state.index();
    EXPECT_EQ(object.tied_to().has_value(), object.Is<Tied>()) << expected.state.index();
  }
}

TEST(TrackedObjectState, ATieNamesOneTrackOnly) {
  TrackedObject object;
  object.Map(5, 2, Tied{.to = 3, .since = 1.0});
  EXPECT_TRUE(object.IsTiedTo(3));
  EXPECT_FALSE(object.IsTiedTo(5));
  EXPECT_EQ(object.tied_to(), 3);
  object.state = InDoubt{};
  EXPECT_FALSE(object.IsTiedTo(3));
  EXPECT_EQ(object.id(), 5);
  EXPECT_EQ(object.slot(), 2);
}

TEST(TrackedObjectState, KeepsItsIdWhenItIsGone) {
  TrackedObject object;
  object.Map(5, 2, Confirmed{});
  object.state = Gone{};
  EXPECT_EQ(object.id(), 5);
  EXPECT_FALSE(object.is_mapped());
}

}  // namespace
}  // namespace limpet
