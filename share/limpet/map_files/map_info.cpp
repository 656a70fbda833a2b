// SPDX-License-Identifier: MIT
#include "limpet/map_files/map_info.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/map_files/depth_grid.hpp"
#include "limpet/map_files/object_files.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// ln(0.7 / 0.3), P_a = 0.7: a voxel above belongs to an object [Bucci 2025].
constexpr float kObjectLogOdds = 0.8473F;

struct OctreeInfo {
  double resolution = 0.0;  ///< [m]
  std::size_t nodes = 0;
  std::size_t occupied = 0, of_objects = 0;  ///< voxels
  Eigen::AlignedBox3d extent_W;              ///< of the occupied ones, NED [m]
};

struct DepthInfo {
  std::size_t cells = 0;
  double least = 0.0, greatest = 0.0;  ///< NED [m]
  double sigma = 0.0;                  ///< mean, of each column beside the others [m]
  double zero_sigma = 0.0;             ///< of what all are off by together [m]
};

struct MapInfo {
  std::optional<OctreeInfo> octree;
  std::optional<DepthInfo> depth;
};

OctreeInfo InfoOf(const SemanticOctree& octree) {
  OctreeInfo info{.resolution = octree.resolution(), .nodes = octree.nodes(), .extent_W = {}};
  const OccupiedMap occupied = OccupiedOf(octree);
  for (const Voxel& voxel : occupied.voxels) {
    ++info.occupied;
    info.of_objects += voxel.belief.object > kObjectLogOdds ? 1 : 0;
    info.extent_W.extend(voxel.p_W);
  }
  return info;
}

std::optional<DepthInfo> InfoOf(const DepthGrid& grid) {
  DepthInfo info{.zero_sigma = grid.zero_sigma_m};
  for (std::size_t cell = 0; cell < grid.down_m.size(); ++cell) {
    if (!grid.IsKnown(cell)) continue;
    const auto down = static_cast<double>(grid.down_m[cell]);
    info.least = info.cells == 0 ? down : std::min(info.least, down);
    info.greatest = info.cells == 0 ? down : std::max(info.greatest, down);
    info.sigma += static_cast<double>(grid.sigma_m[cell]);
    ++info.cells;
  }
  if (info.cells == 0) return std::nullopt;
  info.sigma /= static_cast<double>(info.cells);
  return info;
}

Expected<MapInfo> InfoOf(const SavedSession& session) {
  MapInfo info;
  const Expected<DepthGrid> depths = DepthGridOf(session.memory);
  if (!depths) return depths.error();
  info.depth = InfoOf(*depths);
  if (session.memory.map.empty()) return info;
  const Expected<SemanticOctree> octree = OctreeOf(session.memory.map);
  if (!octree) return octree.error();
  info.octree = InfoOf(*octree);
  return info;
}

OrderedJson Range(double from, double to) { return OrderedJson::array({from, to}); }

OrderedJson Json(const std::optional<OctreeInfo>& octree) {
  if (!octree) return nullptr;
  OrderedJson out{{"resolution_m", octree->resolution},
                  {"nodes", octree->nodes},
                  {"occupied_voxels", octree->occupied},
                  {"object_voxels", octree->of_objects}};
  if (octree->occupied > 0) {
    const Eigen::Vector3d low = octree->extent_W.min(), high = octree->extent_W.max();
    out["extent_m"] = {{"north", Range(low.x(), high.x())},
                       {"east", Range(low.y(), high.y())},
                       {"down", Range(low.z(), high.z())}};
  }
  return out;
}

OrderedJson Json(const std::optional<DepthInfo>& depth) {
  if (!depth) return nullptr;
  return {{"cells", depth->cells},
          {"least_m", depth->least},
          {"greatest_m", depth->greatest},
          {"sigma_m", depth->sigma},
          {"zero_sigma_m", depth->zero_sigma}};
}

OrderedJson JsonOf(const OpiBelief& opi) {
  const Eigen::Vector3d& p_W = opi.object.p_W;
  const Eigen::Vector3d sigma = opi.object.sd_W();
  return {{"id", opi.id},
          {"class", opi.object.color},
          {"decided", NameOf(opi.decided)},
          {"p_present", opi.posterior.present()},
          {"ned_m", {p_W.x(), p_W.y(), p_W.z()}},
          {"sd_m", {sigma.x(), sigma.y(), sigma.z()}},
          {"looks", opi.looks},
          {"radius_m", opi.object.size ? OrderedJson(opi.object.size->radius) : nullptr},
          {"radius_sd_m", opi.object.size ? OrderedJson(opi.object.size->sd) : nullptr}};
}

OrderedJson DatumJson(const SessionFacts& facts) {
  const std::optional<GeoPoint> datum = DatumOf(facts);
  if (!datum) return nullptr;
  return {{"latitude_deg", datum->latitude_deg}, {"longitude_deg", datum->longitude_deg}};
}

OrderedJson AreaJson(const std::optional<SurveyArea>& area) {
  if (!area) return nullptr;
  return {{"north_m", Range(area->north_min, area->north_max)},
          {"east_m", Range(area->east_min, area->east_max)},
          {"object_height_max_m", area->object_height_max}};
}

OrderedJson WaterJson(const std::optional<WaterRecord>& water) {
  if (!water) return nullptr;
  return {{"visibility_m", water->estimate.visibility.value()},
          {"sd_m", water->estimate.sd.value()}};
}

std::string ObjectsTable(const std::vector<OpiBelief>& objects) {
  std::string text = fmt::format("  {:>4} {:<10} {:<14} {:>6} {:>8} {:>8} {:>7} {:>6}\n", "id",
                                 "class", "decided", "there", "north", "east", "down", "looks");
  for (const OpiBelief& opi : objects) {
    const Eigen::Vector3d& p_W = opi.object.p_W;
    fmt::format_to(std::back_inserter(text),
                   "  {:>4} {:<10} {:<14} {:>6.3f} {:>8.2f} {:>8.2f} {:>7.2f} {:>6}\n", opi.id,
                   OneLine(opi.object.color, 10), NameOf(opi.decided), opi.posterior.present(),
                   p_W.x(), p_W.y(), p_W.z(), opi.looks);
  }
  return text;
}

}  // namespace

Expected<std::string> MapInfoJson(const SavedSession& session) {
  const Expected<MapInfo> info = InfoOf(session);
  if (!info) return info.error();
  const SessionFacts& facts = session.facts;
  OrderedJson objects = OrderedJson::array();
  for (const OpiBelief& opi : session.memory.objects.opis)
    objects.push_back(JsonOf(opi));
  const OrderedJson out{{"mission", facts.mission},
                        {"session", facts.session},
                        {"seed", facts.seed},
                        {"limpet", facts.limpet},
                        {"saved_at_s", facts.saved_at},
                        {"cause", facts.cause},
                        {"datum", DatumJson(facts)},
                        {"area", AreaJson(session.memory.area)},
                        {"frames", session.memory.frames.size()},
                        {"water", WaterJson(session.memory.water)},
                        {"octree", Json(info->octree)},
                        {"depth", Json(info->depth)},
                        {"objects", std::move(objects)}};
  return out.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Expected<std::string> MapInfoText(const SavedSession& session) {
  const Expected<MapInfo> info = InfoOf(session);
  if (!info) return info.error();
  const SessionFacts& facts = session.facts;
  std::string text =
      fmt::format("{} of {}, seed {}; saved at {:.0f} s ({}), limpet {}\n",
                  OneLine(facts.session, 40), OneLine(facts.mission, 60), facts.seed,
                  facts.saved_at, OneLine(facts.cause, 40), OneLine(facts.limpet, 20));
  const auto pair = [&text](const char* name, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", name, value);
  };
  const std::optional<GeoPoint> datum = DatumOf(facts);
  pair("datum",
       datum ? fmt::format("{:.7f}, {:.7f}", datum->latitude_deg, datum->longitude_deg) : "none");
  if (const auto& area = session.memory.area) {
    pair("area", fmt::format("north {:g} to {:g} m, east {:g} to {:g} m", area->north_min,
                             area->north_max, area->east_min, area->east_max));
  }
  pair("frames", std::to_string(session.memory.frames.size()));
  if (const auto& water = session.memory.water) {
    pair("water", fmt::format("visibility {:.1f} m, give or take {:.1f} m",
                              water->estimate.visibility.value(), water->estimate.sd.value()));
  }
  pair("voxels", info->octree
                     ? fmt::format("{} occupied, {} of objects, of {:g} m", info->octree->occupied,
                                   info->octree->of_objects, info->octree->resolution)
                     : "none kept");
  if (info->depth) {
    pair("depth", fmt::format("{:.2f} to {:.2f} m in {} columns, sd {:.2f} m", info->depth->least,
                              info->depth->greatest, info->depth->cells, info->depth->sigma));
    pair("", fmt::format("all of them may be off together: the depth sensor's zero, sd {:.2f} m",
                         info->depth->zero_sigma));
  }
  return text + ObjectsTable(session.memory.objects.opis);
}

}  // namespace limpet
