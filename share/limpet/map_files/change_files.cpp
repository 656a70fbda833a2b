// SPDX-License-Identifier: MIT
#include "limpet/map_files/change_files.hpp"

#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/map_files/geo_json.hpp"
#include "limpet/map_files/geo_place.hpp"
#include "limpet/map_files/object_files.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string IdText(const std::optional<int>& id) { return id ? std::to_string(*id) : ""; }

OrderedJson IdJson(const std::optional<int>& id) {
  return id ? OrderedJson(*id) : OrderedJson(nullptr);
}

/// How far an object was moved [m]; nothing unless it was.
std::optional<double> MovedBy(const SessionComparison& comparison, const OpiBelief& object) {
  const std::optional<Eigen::Vector3d> from_W = comparison.MovedFrom_W(object);
  return from_W ? std::optional((object.object.p_W - *from_W).norm()) : std::nullopt;
}

OrderedJson ChangeFeature(const SessionComparison& comparison, const OpiBelief& object,
                          const LocalGrid& grid) {
  const std::optional<double> moved = MovedBy(comparison, object);
  const Eigen::Vector3d& p_W = object.object.p_W;
  return {{"type", "Feature"},
          {"geometry", GeoPointJson(grid, p_W)},
          {"properties",
           {{"decided", NameOf(object.decided)},
            {"class", object.object.color},
            {"p_confirmed", object.posterior.confirmed},
            {"p_removed", object.posterior.removed},
            {"p_new", object.posterior.appeared},
            {"depth_m", p_W.z()},
            {"id_a", IdJson(object.former_id)},
            {"landmark_b", IdJson(object.landmark)},
            {"looks_b", object.looks},
            {"p_nothing", object.posterior.nothing},
            {"moved_m", moved ? OrderedJson(*moved) : OrderedJson(nullptr)},
            {"p_moved", object.moved_probability ? OrderedJson(*object.moved_probability)
                                                 : OrderedJson(nullptr)}}}};
}

}  // namespace

std::string ChangesToCsv(const SessionComparison& comparison) {
  std::string text =
      "decided,class,p_confirmed,p_removed,p_new,north_m,east_m,down_m,latitude_deg,longitude_deg,"
      "id_a,landmark_b,looks_b,p_nothing,moved_m\n";
  const std::optional<GeoPoint> datum = DatumOf(comparison.b);
  for (const OpiBelief& object : comparison.objects) {
    const Eigen::Vector3d& p_W = object.object.p_W;
    const StatusPosterior& p = object.posterior;
    const std::optional<double> moved = MovedBy(comparison, object);
    fmt::format_to(std::back_inserter(text),
                   "{},{},{:.4f},{:.4f},{:.4f},{:.3f},{:.3f},{:.3f},{},{},{},{},{:.4f},{}\n",
                   NameOf(object.decided), object.object.color, p.confirmed, p.removed, p.appeared,
                   p_W.x(), p_W.y(), p_W.z(), GeoFields(datum, p_W), IdText(object.former_id),
                   IdText(object.landmark), object.looks, p.nothing,
                   moved ? fmt::format("{:.3f}", *moved) : "");
  }
  return text;
}

std::string ChangesToGeoJson(const SessionComparison& comparison, const GeoPoint& datum) {
  const LocalGrid grid(datum);
  OrderedJson features = OrderedJson::array();
  for (const OpiBelief& object : comparison.objects)
    features.push_back(ChangeFeature(comparison, object, grid));
  return FeatureCollectionText(std::move(features));
}

}  // namespace limpet
