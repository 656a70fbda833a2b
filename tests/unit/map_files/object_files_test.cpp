// SPDX-License-Identifier: MIT
#include "limpet/map_files/object_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using ::testing::HasSubstr;

SavedSession Session() {
  SavedSession session;
  session.facts.lat_origin = "43.7210";
  session.facts.long_origin = "10.2830";
  OpiBelief opi;
  opi.id = 3;
  opi.object = {.p_W = {100.0, 50.0, 7.25},
                .cov_W = Eigen::Vector3d(0.04, 0.09, 0.01).asDiagonal(),
                .color = "orange"};
  opi.posterior = {.appeared = 0.98, .nothing = 0.02};
  opi.decided = Status::kNew;
  OpiBelief nothing;
  nothing.id = 4;
  nothing.decided = Status::kNothing;
  session.memory.objects.opis = {opi, nothing};
  session.memory.area =
      SurveyArea{.north_min = -15.0, .north_max = 15.0, .east_min = -18.0, .east_max = 18.0};
  return session;
}

TEST(ObjectFiles, GeoJsonHasLongitudeFirst) {
  const SavedSession session = Session();
  const auto json = nlohmann::json::parse(ObjectsToGeoJson(session, *DatumOf(session.facts)));
  ASSERT_EQ(json["features"].size(), 2U);
  const auto& object = json["features"][0];
  const GeoPoint place = LocalGrid({43.7210, 10.2830}).At({100.0, 50.0});
  EXPECT_NEAR(object["geometry"]["coordinates"][0], place.longitude_deg, 1e-8);
  EXPECT_NEAR(object["geometry"]["coordinates"][1], place.latitude_deg, 1e-8);
  EXPECT_EQ(object["properties"]["decided"], "new");
  EXPECT_NEAR(object["properties"]["sd_east_m"], 0.3, 1e-9);
  const auto& ring = json["features"][1]["geometry"]["coordinates"][0];
  ASSERT_EQ(ring.size(), 5U);
  EXPECT_EQ(ring.front(), ring.back());
}

TEST(ObjectFiles, ATableHasOneRowPerObject) {
  SavedSession session = Session();
  EXPECT_THAT(ObjectsToCsv(session),
              HasSubstr("\n3,orange,new,0.9800,100.000,50.000,7.250,0.200,0.300,0.100,43.7"));
  EXPECT_THAT(ObjectsToCsv(session), ::testing::Not(HasSubstr("\n4,")));
  session.facts.lat_origin = "";
  EXPECT_FALSE(DatumOf(session.facts));
  EXPECT_THAT(ObjectsToCsv(session), HasSubstr(",0.100,,,0,,\n"));
}

TEST(ObjectFiles, HaveTheSizeThatTheVehicleEstimates) {
  SavedSession session = Session();
  session.memory.objects.opis[0].object.size = ObjectSize{.radius = 0.42, .sd = 0.05};
  EXPECT_THAT(ObjectsToCsv(session), HasSubstr(",0,0.420,0.050\n"));
  const auto json = nlohmann::json::parse(ObjectsToGeoJson(session, *DatumOf(session.facts)));
  EXPECT_NEAR(json["features"][0]["properties"]["radius_m"], 0.42, 1e-12);
  session.memory.objects.opis[0].object.size.reset();
  const auto without = nlohmann::json::parse(ObjectsToGeoJson(session, *DatumOf(session.facts)));
  EXPECT_TRUE(without["features"][0]["properties"]["radius_m"].is_null());
}

}  // namespace
}  // namespace limpet
