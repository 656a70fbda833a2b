// SPDX-License-Identifier: MIT
#include "limpet/planning/mission_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

/// A survey of `area` that has just begun.
struct BegunSurvey {
  explicit BegunSurvey(const SurveyArea& of = scene::kArea) : area(of) {}

  [[nodiscard]] MissionPlan::Task At(const Pose2& pose, double travelled = 0.0) const {
    return {.pose = pose,
            .ground = &ground,
            .region = &region,
            .turn_radius = scene::kRadius,
            // Where most is to be seen soon, slivers may be left to a later decision.
            .goal = {.most_weight = 0.0, .home_W = {pose.north, pose.east}},
            .travelled = travelled};
  }
  /// Share of the top that is seen once `path` has been flown, too.
  [[nodiscard]] double TopAfter(const DubinsPath& path) const {
    SurveyGrid flown(area);
    scene::Fly(flown, path);
    return flown.coverage().band_top;
  }

  SurveyArea area;
  SurveyGrid grid{area};
  Ground ground{grid, scene::TableFootprint()};
  Region region{area};
};

MissionPlan PlanOf(int first_edits) {
  MissionPlanParams params;
  params.first_edits = first_edits;
  params.edits = first_edits / 4;
  return {params, Random(7)};
}

std::vector<Option> OffersAt(MissionPlan& plan, const MissionPlan::Task& now) {
  std::vector<Option> options;
  plan.Offer(now, "plan", options);
  return options;
}

TEST(MissionPlan, LeadsToTheEndOfTheSurveyInsideTheRegion) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(400);
  const std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  ASSERT_FALSE(options.empty());
  EXPECT_TRUE(options[0].is_whole());
  EXPECT_EQ(options[0].lacking_m, 0.0);
  EXPECT_TRUE(survey.region.Contains(options[0].path));
  EXPECT_TRUE(survey.region.IsRecoverable(options[0].path.end(), scene::kRadius));
  EXPECT_GT(survey.TopAfter(options[0].path), 0.97);
}

/// What behaviors choose from: plans that lead elsewhere at first, each to the end. They begin with
/// another pass; what is sought behind a short one may come a little nearer again.
TEST(MissionPlan, OffersOthersThatBeginOtherwise) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(400);
  const std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  ASSERT_GE(options.size(), 3U);
  for (std::size_t i = 1; i < options.size(); ++i) {
    EXPECT_TRUE(survey.region.Contains(options[i].path));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(Distance(options[i].path.At(options[i].own_length()),
                         options[j].path.At(options[j].own_length())),
                4.0);
    }
  }
}

/// The region's allowance grows with the doubt of the place.
TEST(MissionPlan, LanesAreCutShorterWhereTheRegionHasBecomeNarrower) {
  BegunSurvey survey;
  MissionPlan lanes = PlanOf(0);
  const std::vector<Option> before = OffersAt(lanes, survey.At(scene::kStart));
  ASSERT_FALSE(before.empty());
  lanes.OnChoice(before[0]);
  survey.region = Region(survey.area, Meters(1.25));
  ASSERT_FALSE(survey.region.Contains(before[0].path));
  const Pose2 start = before[0].path.At(5.0);
  ASSERT_TRUE(survey.region.Contains(start));
  const std::vector<Option> after = OffersAt(lanes, survey.At(start, 5.0));
  ASSERT_FALSE(after.empty());
  EXPECT_TRUE(survey.region.Contains(after[0].path));
  EXPECT_GT(survey.TopAfter(after[0].path), 0.9);
}

/// Seeking anew takes ten times as long as going on, and finds no way to ground that a zone keeps
/// out of sight: it waits until a tenth of the plan has been flown.
TEST(MissionPlan, IsNotSoughtAnewAtOnceForGroundThatNoTourSees) {
  SurveyArea fenced = scene::kArea;
  fenced.keep_out = "{-6,-8:6,-8:6,8:-6,8}";
  BegunSurvey survey;
  survey.region = Region(fenced);  // the ground in it is to be seen all the same
  MissionPlan plan({.first_edits = 400, .edits = 0}, Random(7));
  const Option before = OffersAt(plan, survey.At(scene::kStart)).at(0);
  ASSERT_GT(before.lacking_m, 5.0);
  plan.OnChoice(before);
  const auto longer_after = [&](double share) {
    const double way = share * before.path.length();
    BegunSurvey later;
    later.region = survey.region;
    scene::Fly(later.grid, before.path.Prefix(way));
    later.ground = Ground(later.grid, scene::TableFootprint());
    MissionPlan same = plan;
    MissionPlan::Task now = later.At(before.path.At(way), way);
    now.goal.home_W = {scene::kStart.north, scene::kStart.east};
    return OffersAt(same, now).at(0).path.length() - (before.path.length() - way);
  };
  EXPECT_NEAR(longer_after(0.05), 0.0, 1e-6);
  EXPECT_GT(std::abs(longer_after(0.15)), 0.01) << "another one was found";
}

/// Once the sessions' maps are joined, former objects lie elsewhere: no longer where the plan was
/// to look at them.
TEST(MissionPlan, LooksAtATargetThatHasMovedOffItsWay) {
  const BegunSurvey survey;
  const Target target{.north = 0.0, .east = -12.0, .window = {0.7, 0.7}, .value = 250.0};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    MissionPlan plan({.first_edits = 800, .edits = 60}, Random(seed));
    MissionPlan::Task now = survey.At(scene::kStart);
    now.goal.others.targets = {target};
    const Option chosen = OffersAt(plan, now)[0];
    ASSERT_TRUE(FirstLook(chosen.path.Prefix(40.0), target));
    plan.OnChoice(chosen);
    MissionPlan::Task later = survey.At(chosen.path.At(8.0), 8.0);
    for (const double aside : {-5.0, 5.0}) {
      Target moved = target;
      moved.east += aside;
      later.goal.others.targets = {moved};
      MissionPlan anew = plan;
      EXPECT_TRUE(FirstLook(OffersAt(anew, later)[0].path.Prefix(60.0), moved))
          << "seed " << seed << ", " << aside << " m aside";
    }
  }
}

TEST(MissionPlan, SaysWhatItsRestLacksIfLessWasSeenThanMeant) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(200);
  const Option chosen = OffersAt(plan, survey.At(scene::kStart))[0];
  plan.OnChoice(chosen);
  // 60 m on, and nothing of it has been seen.
  const std::vector<Option> options = OffersAt(plan, survey.At(chosen.path.At(60.0), 60.0));
  const auto rest = std::ranges::find(options, "previous", &Option::source);
  ASSERT_NE(rest, options.end());
  EXPECT_GT(rest->lacking_m, options[0].lacking_m + 100.0);
}

TEST(MissionPlan, OfEditsIsShorterThanTheBestLanes) {
  const BegunSurvey survey;
  MissionPlan lanes = PlanOf(0), edited = PlanOf(2000);
  const auto begun = survey.At(scene::kStart);
  EXPECT_LT(OffersAt(edited, begun)[0].path.length(), OffersAt(lanes, begun)[0].path.length());
}

TEST(MissionPlan, IsTheSameForTheSameSeed) {
  const BegunSurvey survey;
  MissionPlan a = PlanOf(200), b = PlanOf(200);
  scene::ExpectSame(OffersAt(a, survey.At(scene::kStart)), OffersAt(b, survey.At(scene::kStart)));
}

TEST(MissionPlan, OffersTheRestOfWhatIsFlown) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(200);
  const Option chosen = OffersAt(plan, survey.At(scene::kStart))[0];
  plan.OnChoice(chosen);
  const std::vector<Option> options = OffersAt(plan, survey.At(chosen.path.At(8.0), 8.0));
  const auto rest = std::ranges::find(options, "previous", &Option::source);
  ASSERT_NE(rest, options.end());
  EXPECT_NEAR(rest->path.length(), chosen.path.length() - 8.0, 1e-6);
  EXPECT_NEAR(Distance(rest->path.end(), chosen.path.end()), 0.0, 1e-6);
}

TEST(MissionPlan, CompletesWhatOthersOffer) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(400);
  std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  const DubinsPath own(scene::kStart, {{0.0, 10.0}, {-1.0 / 3.0, 4.0}});
  options.push_back({.source = "other", .path = own});
  plan.Complete(options);
  const Option& other = options.back();
  ASSERT_TRUE(other.is_whole());
  EXPECT_NEAR(other.own_length(), own.length(), 1e-9);
  EXPECT_NEAR(Distance(other.path.At(own.length()), own.end()), 0.0, 1e-9);
  EXPECT_TRUE(survey.region.Contains(other.path));
  EXPECT_GT(survey.TopAfter(other.path), 0.97);
}

TEST(MissionPlan, GoesOnBehindAnotherOptionThatWasChosen) {
  const BegunSurvey survey;
  MissionPlan plan = PlanOf(200);
  std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  options.push_back({.source = "other", .path = DubinsPath(scene::kStart, {{0.0, 10.0}})});
  plan.Complete(options);
  const Option chosen = options.back();
  plan.OnChoice(chosen);
  const auto next = OffersAt(plan, survey.At(chosen.path.At(8.0), 8.0));
  EXPECT_NE(std::ranges::find(next, "previous", &Option::source), next.end());
}

/// Of every option, what its path lacks by itself.
void ExpectHonest(const std::vector<Option>& options, const BegunSurvey& survey,
                  const MissionPlan::Task& now) {
  TourJudge judge(survey.ground, survey.region, scene::kRadius);
  for (const Option& option : options) {
    judge.Reset(option.path, now.goal);
    EXPECT_NEAR(judge.Cost({}).lacking, option.lacking_m, 1e-6) << option.source;
  }
}

/// The region grows narrower and there is a zone: passes that cannot be reached any more show
/// nothing, and others are reached by ways around.
TEST(MissionPlan, AnOptionLacksWhatItsPathLacks) {
  SurveyArea area = scene::kArea;
  area.keep_out = "{-4,-4:4,-4:4,4:-4,4}";
  for (const std::uint64_t seed : {1U, 2U}) {
    BegunSurvey survey(area);
    MissionPlan plan({.first_edits = 200, .edits = 50}, Random(seed));
    MissionPlan::Task now = survey.At(scene::kStart);
    for (int decision = 0; decision < 5; ++decision) {
      std::vector<Option> options = OffersAt(plan, now);
      ASSERT_FALSE(options.empty());
      options.push_back({.source = "other", .path = DubinsPath(now.pose, {{0.1, 6.0}})});
      plan.Complete(options);
      if (!options.back().is_whole()) options.pop_back();
      ExpectHonest(options, survey, now);
      const Option& chosen = options[decision % 2 == 0 ? 0 : options.size() - 1];
      plan.OnChoice(chosen);
      survey.region = Region(area, Meters(0.25 * decision));
      scene::Fly(survey.grid, chosen.path.Prefix(4.0));
      survey.ground.Update(survey.grid);
      now = survey.At(chosen.path.At(4.0), now.travelled + 4.0);
    }
  }
}

/// Where another option was chosen, what it was to show by itself stays part of the plan.
TEST(MissionPlan, GoesOnAlongAnotherOptionThatWasChosen) {
  BegunSurvey survey;
  MissionPlan plan({.first_edits = 400, .edits = 0, .rest_edits = 0}, Random(7));
  std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  const double radius = scene::kRadius.value();
  const DubinsPath own(scene::kStart, {{0.0, 6.0},
                                       {-1.0 / radius, 0.5 * std::numbers::pi * radius},
                                       {0.0, 12.0},
                                       {1.0 / radius, radius}});
  options.push_back({.source = "other", .path = own});
  plan.Complete(options);
  plan.OnChoice(options.back());
  scene::Fly(survey.grid, own.Prefix(4.0));
  survey.ground.Update(survey.grid);
  const std::vector<Option> next = OffersAt(plan, survey.At(own.At(4.0), 4.0));
  ASSERT_FALSE(next.empty());
  for (const double further : {8.0, 15.0, own.length() - 4.0}) {
    EXPECT_NEAR(Distance(next[0].path.At(further), own.At(4.0 + further)), 0.0, 1e-6) << further;
  }
}

TEST(MissionPlan, OffersNothingOnceAllIsSeen) {
  BegunSurvey survey;
  MissionPlan plan = PlanOf(0);
  const std::vector<Option> options = OffersAt(plan, survey.At(scene::kStart));
  scene::Fly(survey.grid, options[0].path);
  survey.ground.Update(survey.grid);
  MissionPlan::Task now = survey.At(options[0].path.end());
  now.goal.finish_share = 0.9;
  EXPECT_TRUE(OffersAt(plan, now).empty());
}

TEST(MissionPlan, ForgetsItselfWhenTheAreaIsAnotherOne) {
  const BegunSurvey here;
  SurveyArea far = scene::kArea;
  far.north_min += 100.0, far.north_max += 100.0;
  const BegunSurvey there(far);
  MissionPlan plan = PlanOf(200);
  plan.OnChoice(OffersAt(plan, here.At(scene::kStart))[0]);
  const auto options = OffersAt(plan, there.At({100.0, 0.0, 0.0}));
  ASSERT_FALSE(options.empty());
  EXPECT_TRUE(there.region.Contains(options[0].path));
}

TEST(MissionPlan, GoesRoundAZone) {
  SurveyArea area = scene::kArea;
  area.keep_out = "{-4,-4:4,-4:4,4:-4,4}";
  const BegunSurvey survey(area);
  for (const double most_weight : {0.0, TourGoal{}.most_weight}) {
    MissionPlan plan = PlanOf(400);
    MissionPlan::Task now = survey.At(scene::kStart);
    now.goal.most_weight = most_weight;
    const auto options = OffersAt(plan, now);
    ASSERT_FALSE(options.empty());
    EXPECT_TRUE(survey.region.Contains(options[0].path));
    // Where most is to be seen soon, slivers beside the zone may be left to a later decision.
    EXPECT_GT(survey.TopAfter(options[0].path), most_weight == 0.0 ? 0.97 : 0.95);
  }
}

}  // namespace
}  // namespace limpet
