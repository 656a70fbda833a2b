// SPDX-License-Identifier: MIT
#include "tests/bench/change_worlds/drawn_world.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <fmt/ostream.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kHalfSide = 12.0;    // of the area [m]
constexpr double kApart = 3.6;        // between places, so that it is clear which is meant [m]
constexpr double kWallSpace = 0.8;    // between a place and the area's edge [m]
constexpr double kBand = 2.0;         // objects float up to so far above the seabed [m]
constexpr double kAboveDive = 2.5;    // water above the vehicle at survey altitude [m]
constexpr double kHighestView = 6.5;  // pMap's default [m]

struct Stay {
  std::optional<Eigen::Vector2d> before, now;
};

double LogUniform(Random& random, double low, double high) {
  return low * std::pow(high / low, random.Uniform(0.0, 1.0));
}

class Layout {
 public:
  explicit Layout(Random& random) : random_(random) {}

  Eigen::Vector2d FreePlace() {
    const double most = kHalfSide - kWallSpace;
    for (int tries = 0;; ++tries) {
      const double east = random_.Uniform(-most, most), north = random_.Uniform(-most, most);
      const Eigen::Vector2d place(north, east);
      if (IsFree(place, tries < 1000 ? kApart : 0.5 * kApart)) {
        taken_.push_back(place);
        return place;
      }
    }
  }

  Stay Moved() {
    const Eigen::Vector2d before = FreePlace();
    const double distance = random_.Uniform(0.5, 2.0);
    Eigen::Vector2d now;
    do {
      const double course = random_.Uniform(0.0, 2.0 * std::numbers::pi);
      now = before + distance * Eigen::Vector2d(std::cos(course), std::sin(course));
    } while (now.cwiseAbs().maxCoeff() > kHalfSide - kWallSpace);
    taken_.push_back(now);
    return {before, now};
  }

 private:
  [[nodiscard]] bool IsFree(const Eigen::Vector2d& place, double apart) const {
    return std::ranges::all_of(taken_,
                               [&](const auto& other) { return (other - place).norm() >= apart; });
  }

  Random& random_;
  std::vector<Eigen::Vector2d> taken_;
};

std::vector<Stay> DrawObjects(Random& random) {
  Layout layout(random);
  std::vector<Stay> objects{layout.Moved()};
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d place = layout.FreePlace();
    const bool is_gone = i == 4 || i == 5, is_new = i >= 6;
    objects.push_back({.before = is_new ? std::nullopt : std::optional(place),
                       .now = is_gone ? std::nullopt : std::optional(place)});
  }
  return objects;
}

std::string PlaceText(const std::optional<Eigen::Vector2d>& place, double depth) {
  return place ? fmt::format("[{:.2f}, {:.2f}, {:.2f}]", place->x(), place->y(), depth) : "null";
}

struct World {
  double altitude, depth, radius, visibility, false_boxes;
};

std::string ScenarioText(const World& world, Random& random) {
  const std::uint64_t ground = random.Index(1000);
  const double roughness = random.Uniform(0.02, 0.1), toward = random.Uniform(0.0, 360.0);
  const double slope = random.Uniform(0.0, 1.5);
  std::string text = fmt::format(
      "seabed:  {{depth_m: {:.2f}, slope_deg: {:.1f}, slope_toward_deg: {:.0f}, roughness_m: "
      "{:.2f}, seed: {}}}\n",
      world.depth, slope, toward, roughness, ground);
  const double set_east = random.Uniform(-0.05, 0.05), set_north = random.Uniform(-0.05, 0.05);
  text += fmt::format(
      "water:   {{visibility_m: {:.2f}, current_north_mps: {:.3f}, current_east_mps: {:.3f}}}\n",
      world.visibility, set_north, set_east);
  const double heading = random.Uniform(0.0, 360.0);
  const double east = random.Uniform(-11.0, 11.0), north = random.Uniform(-11.0, 11.0);
  text += fmt::format("start:   {{north_m: {:.1f}, east_m: {:.1f}, heading_deg: {:.0f}}}\nopis:\n",
                      north, east, heading);
  int number = 0;
  for (const Stay& stay : DrawObjects(random)) {
    const double rest = world.depth - world.radius;
    const double depth = random.Chance(0.5) ? rest : random.Uniform(world.depth - kBand, rest);
    text +=
        fmt::format("  - {{name: O{}, color: {}, radius_m: {:.3f}, discovery: {}, change: {}}}\n",
                    ++number, random.Chance(0.5) ? "yellow" : "orange", world.radius,
                    PlaceText(stay.before, depth), PlaceText(stay.now, depth));
  }
  const double gps = LogUniform(random, 0.4, 2.0), compass = LogUniform(random, 0.25, 1.0);
  const double yaw_bias = LogUniform(random, 0.5, 2.0);
  const double outliers = random.Uniform(0.0, 0.02), dropouts = random.Uniform(0.0, 1.0);
  text += fmt::format(
      "camera:  boxes\nsensors: {{dvl_dropout_per_min: {:.2f}, dvl_outlier_share: {:.3f}, "
      "yaw_bias_deg_per_h: {:.2f}, heading_sigma_deg: {:.2f}, gps_sigma_m: {:.2f}, "
      "false_detections_per_image: {:.3f}}}\n",
      dropouts, outliers, yaw_bias, compass, gps, world.false_boxes);
  return text;
}

std::string MissionText(std::uint64_t seed, const World& world, double said_radius) {
  std::string text = fmt::format(
      "// World {}. What the vehicle knows; the truth is in scenario.yaml.\n"
      "ServerHost   = localhost\nServerPort   = 9000\nCommunity    = limpet\n"
      "MOOSTimeWarp = 1\nLatOrigin    = 43.7210\nLongOrigin   = 10.2830\n",
      seed);
  for (const char* axis : {"NORTH", "EAST"}) {
    text += fmt::format("#define AREA_{0}_MIN {1}\n#define AREA_{0}_MAX {2}\n", axis, -kHalfSide,
                        kHalfSide);
  }
  text += fmt::format("#define BAND {}\n#define HIGHEST_VIEW {:.2f}\n", kBand,
                      std::max(kHighestView, 1.3 * world.altitude));
  text += fmt::format("survey_altitude_m = {:.2f}\nobject_radius_m   = {:.2f}\n", world.altitude,
                      said_radius);
  return text + "#include plug_survey.moos\n";
}

}  // namespace

void WriteDrawnWorld(std::uint64_t seed, const std::filesystem::path& folder) {
  Random random(seed, "change_worlds");
  const double altitude = random.Uniform(2.5, 8.0);
  const World world{.altitude = altitude,
                    .depth = altitude + kAboveDive,
                    .radius = random.Uniform(0.2, 0.6),
                    .visibility = LogUniform(random, 3.0, 10.0),
                    .false_boxes = LogUniform(random, 0.01, 1.0)};
  const double said_radius = world.radius * LogUniform(random, 1.0 / 1.3, 1.3);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "mission.moos") << MissionText(seed, world, said_radius);
  std::ofstream(folder / "mission.bhv") << "#include plug_survey.bhv\n";
  World later = world;
  Random water(seed, "water of the change session");
  later.visibility = LogUniform(water, 3.0, 10.0);
  Random again = random;  // all else alike
  std::ofstream(folder / "scenario.yaml") << ScenarioText(world, random);
  std::ofstream(folder / "scenario_change.yaml") << ScenarioText(later, again);
}

}  // namespace limpet
