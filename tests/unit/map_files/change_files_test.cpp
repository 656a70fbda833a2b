// SPDX-License-Identifier: MIT
#include "limpet/map_files/change_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using ::testing::HasSubstr;

SessionComparison RemovedAndNew() {
  SessionComparison comparison{.a = {}, .b = {}, .offset = {}, .objects = {}};
  comparison.b.lat_origin = "43.7210";
  comparison.b.long_origin = "10.2830";
  OpiBelief removed;
  removed.former_id = 4;
  removed.object = {.p_W = {100.0, 50.0, 7.25}, .cov_W = {}, .color = "orange"};
  removed.posterior = {.removed = 0.98, .nothing = 0.02};
  removed.decided = Status::kRemoved;
  removed.looks = 6;
  OpiBelief newcomer;
  newcomer.landmark = 9;
  newcomer.object = {.p_W = {-3.0, 11.0, 6.0}, .cov_W = {}, .color = "yellow"};
  newcomer.posterior = {.appeared = 0.997, .nothing = 0.003};
  newcomer.decided = Status::kNew;
  comparison.objects = {removed, newcomer};
  return comparison;
}

TEST(ChangeFiles, ATableHasOneRowPerObjectOfEitherSession) {
  SessionComparison comparison = RemovedAndNew();
  EXPECT_THAT(ChangesToCsv(comparison),
              HasSubstr("\nremoved,orange,0.0000,0.9800,0.0000,100.000,50.000,7.250,43.72"));
  EXPECT_THAT(ChangesToCsv(comparison), HasSubstr(",4,,6,0.0200,\n"));
  comparison.b.lat_origin = "";
  EXPECT_THAT(ChangesToCsv(comparison), HasSubstr("-3.000,11.000,6.000,,,,9,0,0.0030,\n"));
}

TEST(ChangeFiles, AMovedObjectSaysHowFarItWasMoved) {
  SessionComparison comparison = RemovedAndNew();
  OpiBelief& moved = comparison.objects[1];
  moved.decided = Status::kMoved;
  moved.former_id = 4;
  moved.moved_probability = 0.93;
  comparison.former_W[4] = {-3.0, 9.8, 5.5};
  EXPECT_THAT(ChangesToCsv(comparison), HasSubstr(",4,9,0,0.0030,1.300\n"));
  const auto json = nlohmann::json::parse(ChangesToGeoJson(comparison, {43.7210, 10.2830}));
  EXPECT_NEAR(json["features"][1]["properties"]["moved_m"], 1.3, 1e-9);
  EXPECT_TRUE(json["features"][0]["properties"]["moved_m"].is_null());
  EXPECT_EQ(json["features"][1]["properties"]["p_moved"], 0.93);
  EXPECT_TRUE(json["features"][0]["properties"]["p_moved"].is_null());
}

TEST(ChangeFiles, AnObjectIsOnTheMapWhereItIsOnEarth) {
  const GeoPoint datum{43.7210, 10.2830};
  const auto json = nlohmann::json::parse(ChangesToGeoJson(RemovedAndNew(), datum));
  ASSERT_EQ(json["features"].size(), 2U);
  const auto& first = json["features"][0];
  const GeoPoint place = LocalGrid(datum).At({100.0, 50.0});
  EXPECT_NEAR(first["geometry"]["coordinates"][0], place.longitude_deg, 1e-8);
  EXPECT_NEAR(first["geometry"]["coordinates"][1], place.latitude_deg, 1e-8);
  EXPECT_EQ(first["properties"]["decided"], "removed");
  EXPECT_TRUE(first["properties"]["landmark_b"].is_null());
  EXPECT_EQ(json["features"][1]["properties"]["landmark_b"], 9);
}

}  // namespace
}  // namespace limpet
