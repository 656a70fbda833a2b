// SPDX-License-Identifier: MIT
#include "limpet/map_files/object_files.hpp"

#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/map_files/geo_json.hpp"
#include "limpet/map_files/geo_place.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<OpiBelief> ObjectsOf(const SavedSession& session) {
  std::vector<OpiBelief> objects = session.memory.objects.opis;
  std::erase_if(objects, [](const OpiBelief& opi) { return opi.decided == Status::kNothing; });
  return objects;
}

/// Two columns, empty where nobody estimated it.
std::string SizeFields(const std::optional<ObjectSize>& size) {
  return size ? fmt::format("{:.3f},{:.3f}", size->radius, size->sd) : ",";
}

OrderedJson FeatureOf(const OpiBelief& opi, const LocalGrid& grid) {
  const Eigen::Vector3d& p_W = opi.object.p_W;
  const Eigen::Vector3d sigma = opi.object.sd_W();
  return {{"type", "Feature"},
          {"id", opi.id},
          {"geometry", GeoPointJson(grid, p_W)},
          {"properties",
           {{"class", opi.object.color},
            {"decided", NameOf(opi.decided)},
            {"p_present", opi.posterior.present()},
            {"depth_m", p_W.z()},
            {"sd_north_m", sigma.x()},
            {"sd_east_m", sigma.y()},
            {"sd_down_m", sigma.z()},
            {"looks", opi.looks},
            {"radius_m", opi.object.size ? OrderedJson(opi.object.size->radius) : nullptr},
            {"radius_sd_m", opi.object.size ? OrderedJson(opi.object.size->sd) : nullptr}}}};
}

OrderedJson FeatureOf(const SurveyArea& area, const LocalGrid& grid) {
  const PlanePoint low(area.north_min, area.east_min), high(area.north_max, area.east_max);
  // A saved session may hold anything: an area that is none is written as its box.
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  const SimplePolygon outline = shape ? shape->outline() : SimplePolygon::Box(low, high);
  // Counterclockwise, and closed.
  OrderedJson ring = OrderedJson::array();
  for (const PlanePoint& corner : outline.corners()) {
    ring.push_back(GeoPosition(grid, corner));
  }
  ring.push_back(ring.front());
  return {
      {"type", "Feature"},
      {"geometry", {{"type", "Polygon"}, {"coordinates", OrderedJson::array({std::move(ring)})}}},
      {"properties", {{"name", "survey area"}}}};
}

}  // namespace

std::string ObjectsToCsv(const SavedSession& session) {
  std::string text =
      "id,class,decided,p_present,north_m,east_m,down_m,sd_north_m,sd_east_m,sd_down_m,"
      "latitude_deg,longitude_deg,looks,radius_m,radius_sd_m\n";
  const std::optional<GeoPoint> datum = DatumOf(session.facts);
  for (const OpiBelief& opi : ObjectsOf(session)) {
    const Eigen::Vector3d& p_W = opi.object.p_W;
    const Eigen::Vector3d sigma = opi.object.sd_W();
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{}\n", opi.id,
                   opi.object.color, NameOf(opi.decided), opi.posterior.present(), p_W.x(), p_W.y(),
                   p_W.z(), sigma.x(), sigma.y(), sigma.z(), GeoFields(datum, p_W), opi.looks,
                   SizeFields(opi.object.size));
  }
  return text;
}

std::string ObjectsToGeoJson(const SavedSession& session, const GeoPoint& datum) {
  const LocalGrid grid(datum);
  OrderedJson features = OrderedJson::array();
  for (const OpiBelief& opi : ObjectsOf(session))
    features.push_back(FeatureOf(opi, grid));
  if (session.memory.area) features.push_back(FeatureOf(*session.memory.area, grid));
  return FeatureCollectionText(std::move(features));
}

}  // namespace limpet
