// SPDX-License-Identifier: MIT
#include "apps/pSurvey/area_request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pSurvey/survey_app.hpp"
#include "limpet/topics/area_request.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

const std::string kEllRequest = "area={0,0:20,0:20,10:10,10:10,20:0,20},keep_out={2,2:4,2:4,4}";

/// pSurvey in a mission of its own, and an operator.
class AreaRequest : public ::testing::Test {
 protected:
  static SurveyApp::Params Mission() {
    SurveyApp::Params params;
    params.area = "pts={-5,-5:5,-5:5,5:-5,5}";
    return params;
  }
  AppContext Context() {
    AppContext context;
    context.name = "pSurvey";
    context.link = &link_;
    context.runs_live = true;
    context.run_folder = folder_.path();
    return context;
  }
  SurveyAreaAnswer AnswerTo(SurveyApp& app, const std::string& request) {
    link_.Send(app, topics::kSurveyAreaRequest, request);
    return link_.Last(topics::kSurveyAreaAnswer).value_or(SurveyAreaAnswer());
  }
  void DiveUnder(SurveyApp& app) {
    NavState nav{.altitude = 7.5};
    link_.Send(app, topics::kNavState, nav);
    link_.Send(app, topics::kDeploy, true);
    link_.time += SurveyApp::Params{}.align;
    link_.Send(app, topics::kNavState, nav);
    app.Tick(link_.time);
    ASSERT_EQ(link_.Last(topics::kSurveyPhase), "DIVE");
  }

  TemporaryFolder folder_;
  TestLink link_;
};

TEST_F(AreaRequest, IsTakenBeforeTheDiveAndToldToAll) {
  SurveyApp app(Context(), Mission());
  const std::string sealed = "hash=" + HashOfRequest(kEllRequest) + "," + kEllRequest;
  const SurveyAreaAnswer answer = AnswerTo(app, sealed);
  EXPECT_TRUE(answer.is_accepted) << answer.why;
  EXPECT_EQ(answer.hash, HashOfRequest(kEllRequest));
  const auto area = link_.Last(topics::kSurveyArea);
  ASSERT_TRUE(area);
  EXPECT_DOUBLE_EQ(area->north_max, 20.0);
  EXPECT_EQ(area->keep_out, "{2,2:4,2:4,4}");
  EXPECT_DOUBLE_EQ(area->margin, 2.0) << "as the mission has it";
}

TEST_F(AreaRequest, IsRefusedWithTheReasonAndChangesNothing) {
  SurveyApp app(Context(), Mission());
  EXPECT_THAT(AnswerTo(app, "hash=0123456789abcdef," + kEllRequest).why, HasSubstr("damaged"));
  EXPECT_THAT(AnswerTo(app, "go north").why, HasSubstr("cannot be read"));
  EXPECT_THAT(AnswerTo(app, "area={0,0:9,9:9,0:0,9}").why, HasSubstr("crosses or touches itself"));
  EXPECT_THAT(AnswerTo(app, kEllRequest + ",operating_region={1,2}").why,
              HasSubstr("`operating_region` has 1 corners"));
  EXPECT_FALSE(link_.Last(topics::kSurveyArea));
}

TEST_F(AreaRequest, WithAKeyThatNothingKnowsIsRefusedWithTheNearest) {
  SurveyApp app(Context(), Mission());
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",keep_outt={2,2:4,2:4,4}").why,
              HasSubstr("nothing knows `keep_outt`; nearest known: `keep_out`"));
  EXPECT_THAT(AnswerTo(app, area + ",zzz=1").why, HasSubstr("allowed: area, keep_out"));
  EXPECT_THAT(AnswerTo(app, area + ",margin=1,margin=2").why, HasSubstr("`margin` is said twice"));
  EXPECT_FALSE(link_.Last(topics::kSurveyArea));
}

TEST_F(AreaRequest, BeyondWhatAMissionMaySayIsRefused) {
  SurveyApp app(Context(), Mission());
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",margin=101").why,
              HasSubstr("margin_m: `101` is not allowed; allowed: 0 to 100"));
  EXPECT_THAT(AnswerTo(app, area + ",object_height_max=11").why, HasSubstr("allowed: 0 to 10"));
  EXPECT_THAT(
      AnswerTo(app, area + ",object_height_max=4").why,
      HasSubstr("object_height_max: objects may reach 4 m above the seabed, and the vehicle "
                "flies at pSurvey altitude_m = 4; allowed: below 4 m"));
  EXPECT_TRUE(AnswerTo(app, area + ",margin=100,object_height_max=3.5").is_accepted);
}

TEST_F(AreaRequest, ForObjectsThatReachUpToTheVehicleIsRefusedAsCheckRefusesIt) {
  AppContext context = Context();
  context.globals = {{.key = "object_radius_m", .value = "0.5", .where = {}}};
  SurveyApp app(context, Mission());
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",object_height_max=3.7").why,
              HasSubstr("objects may reach 4.2 m above the seabed"));
  EXPECT_TRUE(AnswerTo(app, area + ",object_height_max=3.4").is_accepted);
}

TEST_F(AreaRequest, WithAZoneThatWouldBeDroppedIsRefused) {
  SurveyApp app(Context(), Mission());
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",keep_out={2,2:4,2:4,4},{9,9:12,9:12,12}").why,
              HasSubstr("several zones are keep_out={..}{..}"));
  EXPECT_FALSE(AnswerTo(app, area + ",keep_out={2,2:4,2:4,4} and more").is_accepted);
  EXPECT_FALSE(AnswerTo(app, "area=pts={0,0:20,0:20,20:0,20}pts={1,1:2,1:2,2}").is_accepted);
  EXPECT_FALSE(link_.Last(topics::kSurveyArea));
  EXPECT_TRUE(AnswerTo(app, area + ",keep_out={2,2:4,2:4,4}{9,9:12,9:12,12}").is_accepted);
}

TEST_F(AreaRequest, WithAZoneThatTheVehicleLiesInIsRefused) {
  SurveyApp app(Context(), Mission());
  NavState nav{.altitude = 7.5};
  nav.north = 3.0, nav.east = 3.0;
  link_.Send(app, topics::kNavState, nav);
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",keep_out={2,2:6,2:6,6:2,6}").why,
              HasSubstr("the vehicle lies in a keep-out zone"));
  EXPECT_TRUE(AnswerTo(app, area + ",keep_out={5,5:6,5:6,6:5,6}").is_accepted);
}

TEST_F(AreaRequest, WhoseRegionDoesNotHoldItIsRefused) {
  SurveyApp app(Context(), Mission());
  const std::string area = "area={0,0:20,0:20,20:0,20}";
  EXPECT_THAT(AnswerTo(app, area + ",operating_region={0,0:20,0:20,10:0,10}").why,
              HasSubstr("`operating_region` does not hold the area"));
  EXPECT_THAT(
      AnswerTo(app, area + ",operating_region={-5,-5:9,-5:10,25:11,-5:25,-5:25,30:-5,30}").why,
      HasSubstr("does not hold the area"))
      << "a notch between the corners";
  const SurveyAreaAnswer same = AnswerTo(app, area + ",operating_region={0,0:20,0:20,20:0,20}");
  EXPECT_TRUE(same.is_accepted) << same.why;
}

TEST_F(AreaRequest, FarFromTheVehicleIsRefused) {
  SurveyApp app(Context(), Mission());
  const std::string far = "area={90000,0:90020,0:90020,20:90000,20}";
  EXPECT_THAT(AnswerTo(app, far).why,
              HasSubstr("90 km from the mission's datum; allowed: up to 20"));
  NavState nav{.altitude = 7.5};
  nav.east = 60000.0;
  link_.Send(app, topics::kNavState, nav);
  EXPECT_THAT(AnswerTo(app, far).why, HasSubstr("30 km from the vehicle"));
}

TEST_F(AreaRequest, IsRefusedUnderWater) {
  SurveyApp app(Context(), Mission());
  DiveUnder(app);
  const SurveyAreaAnswer answer = AnswerTo(app, kEllRequest);
  EXPECT_FALSE(answer.is_accepted);
  EXPECT_THAT(answer.why, HasSubstr("at the surface before the dive alone; phase DIVE"));
  EXPECT_DOUBLE_EQ(link_.Last(topics::kSurveyArea)->north_max, 5.0);
}

TEST_F(AreaRequest, LastsThroughARestart) {
  {
    SurveyApp app(Context(), Mission());
    ASSERT_TRUE(AnswerTo(app, kEllRequest).is_accepted);
    DiveUnder(app);
  }
  link_.published.clear();
  AppContext context = Context();
  context.is_restarted = true;
  const SurveyApp next(context, Mission());
  EXPECT_DOUBLE_EQ(link_.Last(topics::kSurveyArea)->north_max, 20.0);
}

}  // namespace
}  // namespace limpet
