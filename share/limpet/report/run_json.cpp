// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/session/session_name.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

Eigen::Vector3d PointFrom(const OrderedJson& in) {
  return {in.at(0).get<double>(), in.at(1).get<double>(), in.at(2).get<double>()};
}

OrderedJson PlaceJson(const std::optional<Eigen::Vector3d>& place) {
  return place ? OrderedJson{place->x(), place->y(), place->z()} : OrderedJson(nullptr);
}

OrderedJson ObstaclesJson(const Scenario& scenario) {
  OrderedJson obstacles = OrderedJson::array();
  for (const ScenarioObstacle& obstacle : scenario.obstacles) {
    obstacles.push_back({{"name", obstacle.name},
                         {"shape", obstacle.shape},
                         {"north_m", obstacle.north_m},
                         {"east_m", obstacle.east_m},
                         {"radius_m", obstacle.radius_m},
                         {"size_m", {obstacle.size_m.x(), obstacle.size_m.y()}},
                         {"height_m", obstacle.height_m}});
  }
  return obstacles;
}

std::vector<ScenarioObstacle> ObstaclesFrom(const OrderedJson& in) {
  std::vector<ScenarioObstacle> obstacles;
  for (const OrderedJson& item : in) {
    const OrderedJson& size = item.at("size_m");
    obstacles.push_back({item.at("name"),
                         item.at("shape"),
                         item.at("north_m"),
                         item.at("east_m"),
                         item.at("radius_m"),
                         {size.at(0).get<double>(), size.at(1).get<double>()},
                         item.at("height_m")});
  }
  return obstacles;
}

OrderedJson ScenarioJson(const Scenario& scenario) {
  OrderedJson opis = OrderedJson::array();
  for (const ScenarioOpi& opi : scenario.opis) {
    OrderedJson places = OrderedJson::object();
    for (const auto& [session, place] : opi.places)
      places[session] = PlaceJson(place);
    opis.push_back(
        {{"name", opi.name}, {"color", opi.color}, {"radius_m", opi.radius_m}, {"places", places}});
  }
  const Scenario::Seabed& seabed = scenario.seabed;
  return {{"seabed",
           {{"depth_m", seabed.depth_m},
            {"slope_deg", seabed.slope_deg},
            {"slope_toward_deg", seabed.slope_toward_deg},
            {"roughness_m", seabed.roughness_m},
            {"seed", seabed.seed}}},
          {"visibility_m", scenario.water.visibility_m},
          {"current_north_mps", scenario.water.current_north_mps},
          {"current_east_mps", scenario.water.current_east_mps},
          {"start",
           {{"north_m", scenario.start.north_m},
            {"east_m", scenario.start.east_m},
            {"heading_deg", scenario.start.heading_deg}}},
          {"camera", scenario.camera},
          {"opis", opis},
          {"obstacles", ObstaclesJson(scenario)}};
}

Scenario ScenarioFrom(const OrderedJson& in) {
  Scenario scenario;
  const OrderedJson& seabed = in.at("seabed");
  scenario.seabed = {seabed.at("depth_m"), seabed.at("slope_deg"), seabed.at("slope_toward_deg"),
                     seabed.at("roughness_m"), seabed.at("seed")};
  scenario.water = {in.at("visibility_m"), in.at("current_north_mps"), in.at("current_east_mps")};
  const OrderedJson& start = in.at("start");
  scenario.start = {start.at("north_m"), start.at("east_m"), start.at("heading_deg")};
  scenario.camera = in.at("camera");
  // None in a run of an older version.
  if (in.contains("obstacles")) scenario.obstacles = ObstaclesFrom(in.at("obstacles"));
  for (const OrderedJson& item : in.at("opis")) {
    ScenarioOpi opi{item.at("name"), item.at("color"), item.at("radius_m"), {}};
    for (const auto& [session, place] : item.at("places").items()) {
      auto& entry = opi.places[session];
      if (!place.is_null()) entry = PointFrom(place);
    }
    scenario.opis.push_back(std::move(opi));
  }
  return scenario;
}

OrderedJson SettingsJson(const ReportSettings& settings) {
  const CameraModel& camera = settings.camera_geometry;
  return {{"version", settings.version},
          {"mission", settings.mission},
          {"seed", settings.seed},
          {"planner", settings.planner},
          {"gain", settings.gain},
          {"camera", settings.camera},
          {"width_px", camera.width_px},
          {"height_px", camera.height_px},
          {"fov_across_rad", camera.fov_across()},
          {"fov_along_rad", camera.fov_along()},
          {"lever_arm_m", {camera.p_BC.x(), camera.p_BC.y(), camera.p_BC.z()}},
          {"tilt_rad", std::atan2(camera.R_BC(0, 2), camera.R_BC(2, 2))},
          {"altitude_m", settings.altitude_m},
          {"highest_view_m", settings.highest_view_m},
          {"frame_rate_hz", settings.frame_rate_hz},
          {"object_radius_m", settings.object_radius_m},
          {"object_height_max_m", settings.object_height_max_m},
          {"turning_radius_m", settings.turning_radius_m},
          {"sessions", settings.sessions},
          {"command", settings.command}};
}

/// Empty in a run of an older version. They become paths: anything else is refused.
std::vector<std::string> SessionsFrom(const OrderedJson& settings) {
  std::vector<std::string> sessions;
  if (!settings.contains("sessions")) return sessions;
  sessions = settings.at("sessions").get<std::vector<std::string>>();
  for (const std::string& session : sessions) {
    if (const auto problem = SessionNameProblem(session)) throw std::runtime_error(problem->text);
  }
  return sessions;
}

ReportSettings SettingsFrom(const OrderedJson& in) {
  ReportSettings settings;
  settings.version = in.at("version");
  settings.mission = in.at("mission");
  settings.seed = in.at("seed");
  settings.planner = in.at("planner");
  settings.gain = in.at("gain");
  settings.camera = in.at("camera");
  CameraModel& camera = settings.camera_geometry;
  camera = CameraModel::FromFieldOfView(
      in.at("width_px"), in.at("height_px"),
      {.across = in.at("fov_across_rad"), .along = in.at("fov_along_rad")});
  const OrderedJson& lever = in.at("lever_arm_m");
  camera.p_BC = PointFrom(lever);
  const double tilt = in.value("tilt_rad", 0.0);  // none in a run of an older version
  if (tilt != 0.0) camera.R_BC = RotationFromRollPitchYaw(0.0, tilt, 0.0) * camera.R_BC;
  settings.altitude_m = in.at("altitude_m");
  settings.frame_rate_hz = in.at("frame_rate_hz");
  settings.object_radius_m = in.at("object_radius_m");
  settings.object_height_max_m = in.at("object_height_max_m");
  // None in a run of an older version.
  settings.highest_view_m = in.value("highest_view_m", settings.highest_view_m);
  settings.turning_radius_m = in.value("turning_radius_m", settings.turning_radius_m);
  settings.command = in.at("command");
  settings.sessions = SessionsFrom(in);
  return settings;
}

/// Wall times of a former report: the one thing a log cannot tell.
std::map<std::string, double> FormerWallTimes(const std::filesystem::path& report) {
  std::map<std::string, double> wall;
  std::ifstream file(report);
  const OrderedJson json = OrderedJson::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("sessions")) return wall;
  for (const auto& [name, session] : json["sessions"].items()) {
    const auto entry = session.find("wall_s");
    if (entry != session.end() && entry->is_number()) wall[name] = entry->get<double>();
  }
  return wall;
}

}  // namespace

std::string RunJson(const ReportSettings& settings, const Scenario& scenario) {
  const OrderedJson json{
      {"settings", SettingsJson(settings)},
      {"scenario", settings.has_scenario ? ScenarioJson(scenario) : OrderedJson(nullptr)}};
  return json.dump(2) + "\n";
}

RunDescription ReadRun(const std::filesystem::path& run) {
  const std::filesystem::path path = run / "run.json";
  std::ifstream file(path);
  if (!file) {
    throw ConfigError(
        ConfigProblem{{path.string(), 0}, "run.json", "not there: not a run's folder"});
  }
  try {
    const OrderedJson json = OrderedJson::parse(file);
    const OrderedJson& scenario = json.at("scenario");
    RunDescription description{SettingsFrom(json.at("settings")),
                               scenario.is_null() ? Scenario{} : ScenarioFrom(scenario)};
    description.settings.has_scenario = !scenario.is_null();
    description.settings.wall_s = FormerWallTimes(run / "report.json");
    return description;
  } catch (const std::exception& error) {
    throw ConfigError(ConfigProblem{{path.string(), 0}, "run.json", error.what()});
  }
}

}  // namespace limpet
