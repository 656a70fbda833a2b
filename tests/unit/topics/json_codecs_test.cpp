// SPDX-License-Identifier: MIT
// The text of what other programs, logs and saved sessions hold: a line that a version wrote is
// read, and written again, byte for byte.
#include <string>

#include <gtest/gtest.h>

#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"
#include "tests/unit/topics/round_trip.hpp"

namespace limpet {
namespace {

template <class T>
void ExpectSameBytes(const std::string& text) {
  const std::optional<T> decoded = TopicCodec<T>::Decode(text);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(std::get<std::string>(TopicCodec<T>::Encode(*decoded)), text);
}

const std::string kSight =
    R"({"altitude":4.000456842982075,"boxes":[{"box":{"color":"orange","confidence":0.9232326689366569,)"
    R"("h":41.338002985091535,"u":375.26882134670086,"v":20.643823415291994,"w":113.68842549239903},)"
    R"("landmark":7}],"exposure":1767225934.0,"frame":124,"ned":[-6.510404940694112,)"
    R"(-7.141642969300916,3.5196724749447905],"pitch":0.0016489699621612375,)"
    R"("roll":-0.0013635916550055322,"yaw":0.9245956845691923})";

const std::string kPrior =
    R"({"boxes":[{"box":{"color":"yellow","confidence":0.6012,"h":32.12,"u":43.41,"v":249.71,"w":32.69},)"
    R"("view":1}],"joint":[0.051,-0.0058,0.0453,0.0003,0.0003,0.0007],)"
    R"("map_parameters":[["object_radius_m","0.5"],["camera_fov_across_deg","80"]],)"
    R"("opis":[{"color":"orange","cov":[0.051,-0.0058,0.0003,0.0453,0.0003,0.0007],"id":1,)"
    R"("log_likelihood_ratio":36.57330369251949,"looks":21,)"
    R"("ned":[-6.172356896106559,-5.134421666485932,6.506311282865518]}],"session":"discovery",)"
    R"("views":[[0.0,-12.5829,-15.2591,0.5096,-0.0002,0.0039,1.5492,7.0383,0.0],)"
    R"([1.66,-12.5838,-15.2585,1.0171,0.0005,0.0032,1.5492,6.4885,0.26]]})";

TEST(WireForm, OfDetectionsStays) {
  ExpectSameBytes<Detections>(
      R"({"boxes":[{"color":"orange","confidence":0.9232326689366569,"h":41.338002985091535,)"
      R"("u":375.26882134670086,"v":20.643823415291994,"w":113.68842549239903}],)"
      R"("exposure":1767225934.0,"frame":124})");
}

TEST(WireForm, OfAnObservedFrameStays) {
  ExpectSameBytes<ObservedFrame>(kSight);
  ExpectSameBytes<ObservedFrame>(R"({"altitude":null,"boxes":[],"exposure":1.5,"frame":0,)"
                                 R"("ned":[1.0,2.0,3.0],"pitch":0.0,"roll":0.0,"yaw":0.5})");
}

TEST(WireForm, OfAnObservedFrameSaysHowSureItsPlaceIsIfTheWriterDoes) {
  EXPECT_FALSE(TopicCodec<ObservedFrame>::Decode(kSight)->sigma.has_value());
  const std::string sure = R"({"altitude":null,"boxes":[],"exposure":1.5,"frame":0,)"
                           R"("ned":[1.0,2.0,3.0],"pitch":0.0,"roll":0.0,"sd_absolute":0.5,)"
                           R"("sd_beside":0.125,"yaw":0.5})";
  ExpectSameBytes<ObservedFrame>(sure);
  const auto frame = TopicCodec<ObservedFrame>::Decode(sure);
  ASSERT_TRUE(frame && frame->sigma);
  EXPECT_EQ(frame->sigma->absolute, 0.5);
  EXPECT_EQ(frame->sigma->beside, 0.125);
}

TEST(WireForm, OfATrackShiftStaysWithAndWithoutSigmas) {
  ExpectSameBytes<TrackShift>(R"({"steps":[[1.0,0.5,0.0,0.0,0.0]]})");
  ExpectSameBytes<TrackShift>(R"({"sigmas":[[1.0,0.5,0.25]],"steps":[[1.0,0.5,0.0,0.0,0.0]]})");
}

TEST(WireForm, OfAnObservedFrameSaysWhereItWasAndWhatItShows) {
  const auto frame = TopicCodec<ObservedFrame>::Decode(kSight);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->X_WB.p_WB,
            Eigen::Vector3d(-6.510404940694112, -7.141642969300916, 3.5196724749447905));
  EXPECT_EQ(frame->X_WB.yaw, 0.9245956845691923);
  EXPECT_EQ(frame->boxes.at(0).landmark, 7);
  EXPECT_EQ(frame->boxes.at(0).w, 113.68842549239903);
}

TEST(WireForm, OfADecisionStays) {
  ExpectSameBytes<HelmBids>(
      R"({"cause":"arrived","considered":2,"options":[{"bids":[{"behavior":"cover","has_veto":false,)"
      R"("value":-0.5004,"weight":1.5,"why":"useful=11.50 length=-12.00"},)"
      R"({"behavior":"region","has_veto":true,"value":0.0,"weight":1.0,)"
      R"("why":"leaves=the operating  region"},)"
      R"({"behavior":"home","has_veto":false,"value":0.0,"weight":1.0,"why":""}],)"
      R"("end":[1.0,2.0],"length":12.0,"rate":0.25,"source":"beam","total":3.5}],)"
      R"("path_id":3,"ranked_by":"rate"})");
}

TEST(WireForm, OfLandmarksStays) {
  ExpectSameBytes<Landmarks>(
      R"({"landmarks":[{"color":"orange","cov":[0.0376,-0.0038,-7.232413314403378e-05,)"
      R"(0.0352,0.0003,0.0017],"id":1,"is_confirmed":true,"looks":28,)"
      R"("ned":[-5.953011914054159,-5.275651358762531,6.488511807801939],"prior_id":1}]})");
}

TEST(WireForm, OfALandmarkThatIsNotConfirmedSaysNone) {
  const auto decoded = TopicCodec<Landmarks>::Decode(
      R"({"landmarks":[{"color":"orange","cov":[1,0,0,1,0,1],"id":1,"is_confirmed":false,)"
      R"("looks":2,"ned":[0,0,6],"prior_id":-1},{"color":"orange","cov":[1,0,0,1,0,1],"id":2,)"
      R"("is_confirmed":true,"looks":9,"ned":[0,0,6],"prior_id":-1}]})");
  ASSERT_TRUE(decoded);
  ASSERT_EQ(decoded->landmarks.size(), 1U);
  EXPECT_EQ(decoded->landmarks[0].id, 2);
}

TEST(WireForm, OfAnUndecidedLandmarkSaysWhatItMayBe) {
  Landmark landmark;
  landmark.former.candidates = {{7, 0.5}, {8, 0.25}};
  const auto decoded = TopicCodec<Landmarks>::Decode(TopicCodec<Landmarks>::Encode({{landmark}}));
  ASSERT_TRUE(decoded);
  const Landmark& same = decoded->landmarks.at(0);
  EXPECT_FALSE(same.former.id);
  ASSERT_EQ(same.former.candidates.size(), 2U);
  EXPECT_EQ(same.former.candidates[1].id, 8);
  EXPECT_EQ(same.former.candidates[1].probability, 0.25);
}

TEST(WireForm, OfObjectsStays) {
  ExpectSameBytes<OpiBeliefs>(
      R"({"opis":[{"centroid":[2.13,9.69,6.99],"centroid_sd":[0.25,0.27,0.13],"color":"orange",)"
      R"("cov":[0.05055000270313892,-0.00266471630185821,0.0,0.052716729863397815,0.0,0.0225],)"
      R"("decided":"removed","entropy":0.002010407440100028,"id":2,"landmark":-1,)"
      R"("log_likelihood_ratio":-8.455850091755652,"looks":14,)"
      R"("ned":[2.165252948213077,9.688318413900872,7.026120948295405],)"
      R"("posterior":{"appeared":7.2795613984329e-23,"confirmed":0.00021260751983256758,)"
      R"("nothing":1.6773756263129142e-17,"removed":0.9997873924801675},"prior_id":2,)"
      R"("probability":0.00021260751983256758}]})");
}

TEST(WireForm, OfAMovedObjectSaysHowSureThatIs) {
  OpiBelief moved{.id = 4, .former_id = 2, .object = {}, .posterior = {.appeared = 0.98}};
  moved.decided = Status::kMoved;
  moved.moved_probability = 0.93;
  moved.object.size = ObjectSize{.radius = 0.2, .sd = 0.02};
  OpiBelief other = moved;
  other.moved_probability.reset();
  const auto decoded =
      TopicCodec<OpiBeliefs>::Decode(TopicCodec<OpiBeliefs>::Encode({{moved, other}}));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->opis.at(0).moved_probability, 0.93);
  EXPECT_EQ(decoded->opis.at(0).object.RadiusOr(0.5), 0.2);
  EXPECT_FALSE(decoded->opis.at(1).moved_probability);
}

TEST(WireForm, OfAFormerSessionStays) { ExpectSameBytes<SessionPrior>(kPrior); }

TEST(WireForm, OfAFormerSessionGivesEachViewItsBoxes) {
  const auto prior = TopicCodec<SessionPrior>::Decode(kPrior);
  ASSERT_TRUE(prior.has_value());
  ASSERT_EQ(prior->views.size(), 2U);
  EXPECT_TRUE(prior->views[0].frame.boxes.empty());
  EXPECT_EQ(prior->views[1].frame.boxes.at(0).color, "yellow");
  EXPECT_EQ(prior->views[1].altitude_age, Seconds(0.26));
}

TEST(WireForm, OfAFormerSessionMayPointABoxAtNoView) {
  std::string text = kPrior;
  text.replace(text.find(R"("view":1)"), 8, R"("view":-9)");
  const auto prior = TopicCodec<SessionPrior>::Decode(text);
  ASSERT_TRUE(prior.has_value());
  for (const FormerView& view : prior->views) {
    EXPECT_TRUE(view.frame.boxes.empty());
  }
}

TEST(JsonTopic, BringsBackDetections) {
  const Detections sent{
      .frame = 7,
      .exposure = Seconds(1767225600.25),
      .boxes = {{.u = 1.5, .v = 2, .w = 3, .h = 4, .confidence = 0.9, .color = "yellow"}}};
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->exposure, sent.exposure);
  ASSERT_EQ(back->boxes.size(), 1U);
  EXPECT_EQ(back->boxes[0].color, "yellow");
  EXPECT_EQ(back->boxes[0].u, 1.5);
}

TEST(JsonTopic, BringsBackDecisionsWithTheirReasons) {
  HelmBids sent;
  sent.cause = "arrived";
  sent.options.push_back(
      {.source = "beam",
       .length = 12.0,
       .total = 3.5,
       .end = {1.0, 2.0},
       .bids = {
           {.behavior = "cover", .weight = 1.0, .bid = {.value = 15.5, .why = {{"useful", 16.0}}}},
           {.behavior = "region", .weight = 1.0, .bid = {.veto = "leaves=the region"}}}});
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  const Bid& cover = back->options.at(0).bids.at(0).bid;
  ASSERT_EQ(cover.why.size(), 1U);
  EXPECT_EQ(cover.why.front().name, "useful");
  EXPECT_EQ(cover.why.front().value, 16.0);
  EXPECT_EQ(cover.veto, std::nullopt);
  const Bid& region = back->options.at(0).bids.at(1).bid;
  EXPECT_EQ(region.veto, "leaves=the region");
  EXPECT_TRUE(region.why.empty());
  EXPECT_EQ(back->options.at(0).end[1], 2.0);
}

TEST(JsonTopic, BringsBackAFrameWithoutAltitude) {
  ObservedFrame sent;
  sent.boxes.push_back({.color = "yellow", .landmark = 3});
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_FALSE(back->altitude.has_value());
  EXPECT_EQ(back->boxes.at(0).landmark, 3);
}

TEST(JsonTopic, DoesNotThrowAtBrokenUtf8) {
  Detections sent;
  sent.boxes.push_back({.u = 0, .v = 0, .w = 1, .h = 1, .confidence = 1, .color = "\xff"});
  EXPECT_TRUE(RoundTrip(sent).has_value());
}

TEST(JsonTopic, RefusesWhatIsNoJsonOrLacksAField) {
  for (const char* text : {"", "{", "[]", "null", "{\"frame\":1}", "{\"frame\":\"x\"}"}) {
    EXPECT_FALSE(TopicCodec<Detections>::Decode(std::string(text)).has_value()) << text;
  }
}

}  // namespace
}  // namespace limpet
