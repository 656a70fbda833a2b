// SPDX-License-Identifier: MIT
#include "estimation/association/tracked_object.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

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
