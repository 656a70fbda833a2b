// SPDX-License-Identifier: MIT
#include "limpet/survey/geo_area.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

constexpr const char* kJson = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "buoy"}, "geometry": {"type": "Point", "coordinates": [10.28, 43.72]}},
  {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
    [[10.283, 43.721], [10.284, 43.721], [10.284, 43.722], [10.283, 43.721]],
    [[10.2836, 43.7212, 5], [10.2838, 43.7212], [10.2838, 43.7214], [10.2836, 43.7212]]]}}]})";

constexpr const char* kKml = R"(<?xml version="1.0"?><kml><Document><Placemark><Polygon id="a">
  <outerBoundaryIs><LinearRing><coordinates>
    10.283,43.721,0 10.284,43.721,0
    10.284,43.722,0 10.283,43.721,0 </coordinates></LinearRing></outerBoundaryIs>
  <innerBoundaryIs><LinearRing><coordinates>10.2836,43.7212 10.2838,43.7212 10.2838,43.7214</coordinates></LinearRing></innerBoundaryIs>
</Polygon></Placemark></Document></kml>)";

std::string GeoProblemOf(std::string_view text) {
  const auto area = ParseGeoArea(text);
  return area ? "" : area.error().text;
}

TEST(GeoArea, IsTheSameFromGeoJsonAndFromKml) {
  for (const char* text : {kJson, kKml}) {
    const auto area = ParseGeoArea(text);
    ASSERT_TRUE(area) << area.error().text;
    ASSERT_EQ(area->outline.size(), 3U);
    EXPECT_DOUBLE_EQ(area->outline[1].longitude_deg, 10.284);
    EXPECT_DOUBLE_EQ(area->outline[2].latitude_deg, 43.722);
    ASSERT_EQ(area->holes.size(), 1U);
    EXPECT_EQ(area->holes[0].size(), 3U);
  }
}

TEST(GeoArea, OfKmlIsReadAsXmlIs) {
  const auto area = ParseGeoArea(R"(<k:kml xmlns:k='http://www.opengis.net/kml/2.2'>
    <!-- <Polygon><outerBoundaryIs><coordinates>1,1 2,2 3,1</coordinates></outerBoundaryIs></Polygon> -->
    <k:Polygon
      id='b'><k:outerBoundaryIs><k:LinearRing><k:coordinates><![CDATA[10,43 11,43 11,44]]></k:coordinates>
    </k:LinearRing></k:outerBoundaryIs></k:Polygon></k:kml>)");
  ASSERT_TRUE(area) << area.error().text;
  ASSERT_EQ(area->outline.size(), 3U);
  EXPECT_DOUBLE_EQ(area->outline[2].latitude_deg, 44.0);
}

TEST(GeoArea, OfKmlIsReadToItsEndWhateverCommentStandsAmongTheCorners) {
  const auto area = ParseGeoArea(
      "<kml><Polygon><outerBoundaryIs><LinearRing><coordinates>10,43 11,43 <!-- the pier --> "
      "11,44<![CDATA[ 10,44]]></coordinates></LinearRing></outerBoundaryIs></Polygon></kml>");
  ASSERT_TRUE(area) << area.error().text;
  EXPECT_EQ(area->outline.size(), 4U);
}

TEST(GeoArea, MayBeginWithAByteOrderMark) {
  for (const char* text : {kJson, kKml}) {
    EXPECT_EQ(GeoProblemOf(std::string("\xEF\xBB\xBF") + text), "");
  }
}

TEST(GeoArea, ComesOutOnTheGridWhereTheGridSaysItIs) {
  const GeoPoint datum{.latitude_deg = 43.721, .longitude_deg = 10.283};
  const LocalGrid grid(datum);
  for (const PlanePoint& place : {PlanePoint(0.0, 0.0), PlanePoint(1234.0, -876.0)}) {
    const auto again = PlacesOnGrid({grid.At(place)}, datum);
    ASSERT_TRUE(again);
    EXPECT_LT((again->front() - place).norm(), 1e-3);
  }
}

TEST(GeoArea, OfAnotherHemisphereOrWithItsCoordinatesExchangedIsRefused) {
  const GeoPoint datum{.latitude_deg = 43.721, .longitude_deg = 10.283};
  const auto problem = [&datum](const GeoPoint& at) {
    return PlacesOnGrid({at}, datum).error().text;
  };
  EXPECT_THAT(problem({-43.721, 10.283}), HasSubstr("latitude -43.721"));
  EXPECT_THAT(problem({-43.721, 10.283}), HasSubstr(", 9723 km from the mission's LatOrigin"))
      << "over the ground, not through the earth";
  EXPECT_THAT(problem({-43.721, -169.717}),
              HasSubstr("on the other side of the earth, 20015 km from"));
  EXPECT_THAT(problem({10.283, 43.721}), HasSubstr("is longitude first in the file?"));
  EXPECT_THAT(problem({44.221, 10.283}), HasSubstr("56 km from the mission's LatOrigin 43.721"));
}

TEST(GeoArea, SaysWhatIsWrongWithAFile) {
  EXPECT_THAT(GeoProblemOf("{"), HasSubstr("is no JSON"));
  EXPECT_THAT(GeoProblemOf(""), HasSubstr("is no JSON"));
  EXPECT_THAT(GeoProblemOf("[1, 2]"), HasSubstr("has 0 polygons"));
  EXPECT_THAT(GeoProblemOf("<kml></kml>"), HasSubstr("has 0 polygons"));
  EXPECT_THAT(GeoProblemOf("<kml><Polygon></kml>"), HasSubstr("is no XML: "));
  EXPECT_THAT(GeoProblemOf("<Polygon></Polygon>"), HasSubstr("0 outer boundaries"));
  EXPECT_THAT(GeoProblemOf(R"({"type":"Polygon","coordinates":[[[10,91]]]})"),
              HasSubstr("no place on earth"));
  EXPECT_THAT(GeoProblemOf(R"({"type":"Polygon","coordinates":[["a"]]})"),
              HasSubstr("[longitude, latitude]"));
  EXPECT_THAT(GeoProblemOf(R"({"type":"MultiPolygon","coordinates":[[[[1,1]]],[[[2,2]]]]})"),
              HasSubstr("has 2 polygons; allowed: one"));
  EXPECT_THAT(GeoProblemOf("<Polygon><outerBoundaryIs><coordinates>1;2</coordinates>"
                           "</outerBoundaryIs></Polygon>"),
              HasSubstr("longitude,latitude"));
}

/// A polygon of GeoJSON, and one of another place.
constexpr std::string_view kHere =
    R"({"type":"Polygon","coordinates":[[[10,43],[11,43],[11,44]]]})";
constexpr std::string_view kThere =
    R"({"type":"Polygon","coordinates":[[[12,43],[13,43],[13,44]]]})";

std::string FeatureOf(std::string_view geometry) {
  return R"({"type":"Feature","properties":{},"geometry":)" + std::string(geometry) + "}";
}
std::string CollectionOf(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}
std::string GeometriesOf(std::string_view geometries) {
  return R"({"type":"GeometryCollection","geometries":[)" + std::string(geometries) + "]}";
}

TEST(GeoArea, IsFoundHoweverDeepItLies) {
  for (const std::string& text :
       {GeometriesOf(kHere), FeatureOf(GeometriesOf(kHere)), CollectionOf(std::string(kHere)),
        CollectionOf(FeatureOf(GeometriesOf(GeometriesOf(kHere)))),
        CollectionOf(FeatureOf("null") + "," + FeatureOf(kHere)), "[" + FeatureOf(kHere) + "]"}) {
    const auto area = ParseGeoArea(text);
    ASSERT_TRUE(area) << text << ": " << area.error().text;
    EXPECT_EQ(area->outline.size(), 3U);
  }
}

TEST(GeoArea, LosesNoPartOfASite) {
  const std::string first = FeatureOf(kHere) + ",";
  for (const std::string& second :
       {std::string(kThere), FeatureOf(GeometriesOf(kThere)), GeometriesOf(kThere)}) {
    EXPECT_THAT(GeoProblemOf(CollectionOf(first + second)), HasSubstr("has 2 polygons"));
  }
  EXPECT_THAT(GeoProblemOf(CollectionOf(first + R"({"properties":{},"geometry":null})")),
              HasSubstr("has `features[1]` without a `type`"));
  EXPECT_THAT(GeoProblemOf(CollectionOf(
                  first + FeatureOf(R"({"type":"polygon","coordinates":[[[1,1],[2,1],[2,2]]]})"))),
              HasSubstr("has `features[1].geometry` of the type `polygon`, which GeoJSON has not; "
                        "nearest that it has: `Polygon`"));
  EXPECT_THAT(GeoProblemOf(R"({"type":"FeatureCollection"})"),
              HasSubstr("has `features`, which is no list"));
}

TEST(GeoArea, IsInDegreesOfWgs84Alone) {
  const auto in_frame = [](const std::string& name) {
    return GeoProblemOf(
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":")" + name +
        R"("}},"features":[)" + std::string(kHere) + "]}");
  };
  for (const char* known :
       {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "urn:ogc:def:crs:EPSG::4326"}) {
    EXPECT_EQ(in_frame(known), "") << known;
  }
  for (const char* other : {"EPSG:4258", "urn:ogc:def:crs:EPSG::3857", "EPSG:32632"}) {
    EXPECT_THAT(in_frame(other), HasSubstr(std::string("frame (crs) ") + other)) << other;
  }
}

TEST(GeoArea, OfAFileThatIsNoTextSaysWhatItIs) {
  EXPECT_THAT(GeoProblemOf(std::string("PK\x03\x04\x14\0", 6)),
              HasSubstr("is a ZIP archive (KMZ); allowed: the .kml file"));
  EXPECT_THAT(GeoProblemOf(std::string("\xFF\xFE{\0", 4)), HasSubstr("is written in UTF-16"));
  EXPECT_THAT(GeoProblemOf(std::string("\0{", 2)), HasSubstr("is written in UTF-16"));
}

}  // namespace
}  // namespace limpet
