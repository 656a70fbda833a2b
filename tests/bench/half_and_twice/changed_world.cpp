// SPDX-License-Identifier: MIT
#include "tests/bench/half_and_twice/changed_world.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "limpet/core/units.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/objects/detection_model.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"
#include "limpet/vision/box_model.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

struct Factor {
  const char* name;
  double times;
};
constexpr Factor kFactors[] = {{"half", 0.5}, {"twice", 2.0}};

/// A key below `errors:` that is a factor itself.
struct ErrorKey {
  const char *name, *sensor, *key, *what;
};
constexpr ErrorKey kErrorKeys[] = {
    {"imu_noise", "imu", "noise_factor", "noise of rates and forces"},
    {"imu_bias", "imu", "bias_factor", "biases of rates and forces"},
    {"fog_noise", "fog", "noise_factor", "angular random walk of the gyro"},
    {"dvl_noise", "dvl", "noise_factor", "noise of the DVL's velocity and ranges"},
    {"dvl_bias", "dvl", "bias_factor", "scale, misalignment and bias of the DVL"},
    {"depth_noise", "depth", "noise_factor", "noise of the depth"},
    {"depth_bias", "depth", "bias_factor", "bias of the depth"},
    {"thrust", "thrusters", "thrust_factor", "thrust at a command"},
    {"thrust_lag", "thrusters", "lag_factor", "lag of the thrust"}};

/// A number of the scenario, as the vehicle believes it: table1 flies the default sheets.
struct ScenarioKey {
  const char *name, *key;
  double believed;
  const char* what;
};
std::vector<ScenarioKey> ScenarioKeys() {
  return {{"heading", "heading_sigma_deg", DegreesFromRadians(ImuSheet().heading_sigma.value()),
           "1-sigma of the compass"},
          {"fog_bias", "yaw_bias_deg_per_h", FogSheet().bias_deg_per_h, "bias of the gyro"},
          {"gps", "gps_sigma_m", GpsSheet().sigma_m, "1-sigma of fixes"},
          {"clutter", "false_detections_per_image", Scenario().sensors.false_detections_per_image,
           "false boxes per image"},
          {"visibility", "visibility_m", DetectionModel().visibility.value(), "visibility"},
          {"radius", "radius_m", ScenarioOpi().radius_m, "radius of the objects"}};
}

constexpr double kDropouts_per_min[] = {0.5, 1.0, 2.0, 3.0, 4.0};
constexpr double kCurrent_mps = 0.25;

std::vector<ChangedWorld> BoxWorlds() {
  const BoxModelConstants believed;
  std::vector<ChangedWorld> worlds;
  for (const Factor& factor : kFactors) {
    worlds.push_back({.name = fmt::format("boxes_{}", factor.name),
                      .what = fmt::format("noise of the detector's boxes x {:g}", factor.times),
                      .settings = fmt::format(" --set uSimCamera.box_centre_sd_px={:g} --set "
                                              "uSimCamera.box_size_sd_px={:g}",
                                              believed.centre_sd_px * factor.times,
                                              believed.size_sd_px * factor.times)});
  }
  return worlds;
}

std::vector<ChangedWorld> DriftWorlds() {
  std::vector<ChangedWorld> worlds;
  double course = 0.0;
  for (const double per_min : kDropouts_per_min) {
    course += 1.3;
    worlds.push_back(
        {.name = fmt::format("drift_{:g}", per_min),
         .what = fmt::format("{:g} dropouts of the DVL a minute in {:g} m/s of current", per_min,
                             kCurrent_mps),
         .scenario = {{"dvl_dropout_per_min", per_min},
                      {"current_north_mps", kCurrent_mps * std::cos(course)},
                      {"current_east_mps", kCurrent_mps * std::sin(course)}}});
  }
  return worlds;
}

std::vector<ChangedWorld> ErrorWorlds() {
  std::vector<ChangedWorld> worlds;
  for (const ErrorKey& key : kErrorKeys) {
    for (const Factor& factor : kFactors) {
      worlds.push_back({.name = fmt::format("{}_{}", key.name, factor.name),
                        .what = fmt::format("{} x {:g}", key.what, factor.times),
                        .errors = fmt::format("errors: {{{}: {{{}: {:g}}}}}\n", key.sensor, key.key,
                                              factor.times)});
    }
  }
  return worlds;
}

std::vector<ChangedWorld> ScenarioWorlds() {
  std::vector<ChangedWorld> worlds;
  for (const ScenarioKey& key : ScenarioKeys()) {
    for (const Factor& factor : kFactors) {
      worlds.push_back({.name = fmt::format("{}_{}", key.name, factor.name),
                        .what = fmt::format("{} x {:g}", key.what, factor.times),
                        .scenario = {{key.key, key.believed * factor.times}}});
    }
  }
  worlds.push_back({.name = "heading_six",
                    .what = "1-sigma of the compass x 6",
                    .scenario = {{"heading_sigma_deg",
                                  6.0 * DegreesFromRadians(ImuSheet().heading_sigma.value())}}});
  return worlds;
}

std::string TextOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<ChangedWorld> ChangedWorlds() {
  std::vector<ChangedWorld> worlds{{.name = "plain", .what = "nothing"}};
  for (const auto& more : {ErrorWorlds(), ScenarioWorlds(), BoxWorlds(), DriftWorlds()})
    std::ranges::copy(more, std::back_inserter(worlds));
  return worlds;
}

void WriteMission(const ChangedWorld& world, const fs::path& mission, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder.parent_path());
  fs::copy(mission, folder, fs::copy_options::recursive);
  std::string text = TextOf(folder / "scenario.yaml");
  for (const ChangedWorld::Entry& change : world.scenario) {
    const std::regex entry(R"(\b)" + change.key + R"(:\s*[^,}\s]+)");
    if (!std::regex_search(text, entry)) {
      throw std::runtime_error(fmt::format("{}: no {}", mission.string(), change.key));
    }
    text = std::regex_replace(text, entry, fmt::format("{}: {:g}", change.key, change.value));
  }
  std::ofstream(folder / "scenario.yaml") << text << world.errors;
}

}  // namespace limpet
