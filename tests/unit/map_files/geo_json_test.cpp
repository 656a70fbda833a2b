// SPDX-License-Identifier: MIT
#include "limpet/map_files/geo_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

TEST(GeoJson, APointSaysLongitudeBeforeLatitude) {
  const OrderedJson point =
      GeoPointJson(LocalGrid(GeoPoint{.latitude_deg = 43.0, .longitude_deg = 5.0}), {0, 0, 7});
  EXPECT_EQ(point.dump(), R"({"type":"Point","coordinates":[5.0,43.0]})");
}

TEST(GeoJson, ACollectionIsReadBackWhateverBytesItsNamesHold) {
  const OrderedJson feature{{"type", "Feature"}, {"properties", {{"class", "a\xff"}}}};
  const std::string text = FeatureCollectionText(OrderedJson::array({feature}));
  const OrderedJson read = OrderedJson::parse(text);
  EXPECT_EQ(read["type"], "FeatureCollection");
  EXPECT_EQ(read["features"].size(), 1U);
  EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace limpet
