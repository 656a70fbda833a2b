// SPDX-License-Identifier: MIT
#include "tests/bench/drawn_sites/drawn_site.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "limpet/core/random.hpp"
#include "tests/bench/drawn_sites/site_outline.hpp"

namespace limpet {
namespace {

constexpr double kRadius = 0.5;          // of the objects [m]
constexpr double kRoomOfAnObject = 1.0;  // between it and zones [m]
constexpr double kRoomToStart = 4.0;     // between the start and zones [m]

template <class T, std::size_t kCount>
T OneOf(const std::array<T, kCount>& values, Random& random) {
  return values.at(random.Index(kCount));
}

struct Site {
  SiteOutline outline;
  std::vector<SimplePolygon> zones;
  PlanePoint start_W;
  double altitude = 0.0, depth = 0.0, band = 0.0;  // [m]
  double visibility = 0.0;                         // [m]
  double current = 0.0, sets = 0.0;                // [m/s], [rad]
  double slope = 0.0, falls = 0.0;                 // [rad]
  double dropouts = 0.0;                           // of the DVL [1/min]
  std::string vehicle;

  [[nodiscard]] double SeabedAt(const PlanePoint& place) const {
    return depth + std::tan(slope) * place.dot(PlanePoint(std::cos(falls), std::sin(falls)));
  }
};

PlanePoint DrawStart(const Site& site, Random& random) {
  if (random.Chance(0.5)) {
    return DrawPlace(site.outline.polygon, site.zones, kRoomToStart, random);
  }
  const double beyond = random.Uniform(2.0, 25.0);
  double reach = 0.0;  // of the area
  for (const PlanePoint& corner : site.outline.polygon.corners())
    reach = std::max(reach, corner.norm());
  const double course = random.Uniform(0.0, 2.0 * std::numbers::pi);
  return (reach + beyond) * PlanePoint(std::cos(course), std::sin(course));
}

Site Draw(Random& random) {
  Site site{.outline = DrawOutline(random), .zones = {}, .start_W = {}, .vehicle = {}};
  site.zones = DrawZones(site.outline.polygon, random);
  site.altitude = random.Uniform(3.0, 6.0);
  site.depth = site.altitude + random.Uniform(1.5, 9.0);
  site.band = std::min(OneOf(std::array{0.5, 1.0, 1.0, 1.5, 2.0, 2.0}, random),
                       std::max(1.0, site.altitude - 1.5));
  site.visibility = random.Uniform(5.0, 12.0);
  site.current = OneOf(std::array{0.0, 0.0, 0.05, 0.1, 0.2}, random);
  site.sets = random.Uniform(0.0, 2.0 * std::numbers::pi);
  site.start_W = DrawStart(site, random);
  site.vehicle = OneOf(std::array{"feelhippo.yaml", "feelhippo.yaml", "bluerov2.yaml"}, random);
  const double slope_deg = OneOf(std::array{0.0, 0.0, 0.0, 4.0, 8.0}, random);
  const bool is_deep = site.depth - site.altitude > 4.0;
  site.slope = is_deep ? slope_deg * std::numbers::pi / 180.0 : 0.0;
  site.falls = random.Uniform(0.0, 2.0 * std::numbers::pi);
  site.dropouts = OneOf(std::array{0.0, 0.0, 0.0, 1.0}, random);
  return site;
}

/// In MOOS's local coordinates: x east, y north.
std::string PointsText(const SimplePolygon& polygon) {
  std::string text;
  for (const PlanePoint& corner : polygon.corners()) {
    text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : ":", corner.y(), corner.x());
  }
  return "pts={" + text + "}";
}

std::string MissionText(std::uint64_t seed, const Site& site) {
  std::string text = fmt::format(
      "// Site {}. What the vehicle knows; the truth is in scenario.yaml.\n"
      "ServerHost   = localhost\nServerPort   = 9000\nCommunity    = limpet\n"
      "MOOSTimeWarp = 1\nLatOrigin    = 43.7210\nLongOrigin   = 10.2830\nVehicleFile  = {}\n"
      "#define AREA {}\n",
      seed, site.vehicle, PointsText(site.outline.polygon));
  int number = 0;
  for (const SimplePolygon& zone : site.zones) {
    const std::string suffix = ++number > 1 ? fmt::format("_{}", number) : "";
    text += fmt::format("#define KEEP_OUT{} {}\n", suffix, PointsText(zone));
  }
  text += fmt::format("#define BAND {:.1f}\n", site.band);
  text +=
      fmt::format("survey_altitude_m = {:.1f}\nobject_radius_m   = {}\n", site.altitude, kRadius);
  return text + "#include plug_survey.moos\n";
}

std::string PlaceText(const std::optional<PlanePoint>& place, double down) {
  return place ? fmt::format("[{:.1f}, {:.1f}, {:.2f}]", place->x(), place->y(), down) : "null";
}

/// Where an object is in the change session that is at `place` in the discovery, and the reverse.
struct Stay {
  std::optional<PlanePoint> before, now;
};

/// Half of the objects stay, a fifth go, a fifth come, the others are moved within the area.
Stay DrawStay(const Site& site, const PlanePoint& place, Random& random) {
  const double fate = random.Uniform(0.0, 1.0);
  if (fate < 0.5) return {.before = place, .now = place};
  if (fate < 0.7) return {.before = place, .now = std::nullopt};
  if (fate < 0.9) return {.before = std::nullopt, .now = place};
  const double course = random.Uniform(0.0, 2.0 * std::numbers::pi);
  const PlanePoint moved =
      place + random.Uniform(1.0, 2.2) * PlanePoint(std::cos(course), std::sin(course));
  return {.before = place, .now = site.outline.polygon.Contains(moved) ? moved : place};
}

/// Objects stay where nothing is drawn from `changes`, which may be null.
std::string ObjectsText(const Site& site, Random& random, Random* changes) {
  std::string text;
  const int count = 1 + static_cast<int>(random.Index(6));
  for (int i = 1; i <= count; ++i) {
    const PlanePoint place = DrawPlace(site.outline.polygon, site.zones, kRoomOfAnObject, random);
    const double afloat = random.Uniform(0.0, std::max(0.0, site.band - kRadius));
    const double down = site.SeabedAt(place) - kRadius - 0.1 - afloat;
    const char* color = OneOf(std::array{"yellow", "orange", "green"}, random);
    const Stay stay = changes ? DrawStay(site, place, *changes) : Stay{place, place};
    text +=
        fmt::format("  - {{name: OPI {}, color: {}, radius_m: {}, discovery: {}, change: {}}}\n", i,
                    color, kRadius, PlaceText(stay.before, down), PlaceText(stay.now, down));
  }
  return text;
}

std::string ScenarioText(const Site& site, Random& random, Random* changes) {
  const auto degrees = [](double angle) { return angle * 180.0 / std::numbers::pi; };
  std::string text = fmt::format(
      "seabed:  {{depth_m: {:.1f}, slope_deg: {:.1f}, slope_toward_deg: {:.0f}, roughness_m: 0.05, "
      "seed: 1}}\n",
      site.depth, degrees(site.slope), degrees(site.falls));
  text += fmt::format(
      "water:   {{visibility_m: {:.1f}, current_north_mps: {:.3f}, current_east_mps: {:.3f}}}\n",
      site.visibility, site.current * std::cos(site.sets), site.current * std::sin(site.sets));
  text += fmt::format("start:   {{north_m: {:.1f}, east_m: {:.1f}, heading_deg: {:.0f}}}\nopis:\n",
                      site.start_W.x(), site.start_W.y(), random.Uniform(0.0, 360.0));
  text += ObjectsText(site, random, changes);
  return text + fmt::format(
                    "camera:  boxes\nsensors: {{dvl_dropout_per_min: {}, dvl_outlier_share: 0, "
                    "yaw_bias_deg_per_h: 1, heading_sigma_deg: 0.5, gps_sigma_m: 0.4, "
                    "false_detections_per_image: 0.01}}\n",
                    site.dropouts);
}

}  // namespace

std::string WriteDrawnSite(std::uint64_t seed, Fates fates, const std::filesystem::path& folder) {
  Random random(seed, "drawn_sites"), changes(seed, "what changes on a drawn site");
  const Site site = Draw(random);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "mission.moos") << MissionText(seed, site);
  std::ofstream(folder / "mission.bhv") << "#include plug_survey.bhv\n";
  std::ofstream(folder / "scenario.yaml")
      << ScenarioText(site, random, fates == Fates::kDrawn ? &changes : nullptr);
  return fmt::format(
      "{} {:.0f} m2, {} zones, {:.1f} m above, band {:.1f} m, sees {:.1f} m, {:.2f} m/s, {}",
      site.outline.kind, site.outline.polygon.Area(), site.zones.size(), site.altitude, site.band,
      site.visibility, site.current, site.vehicle);
}

}  // namespace limpet
