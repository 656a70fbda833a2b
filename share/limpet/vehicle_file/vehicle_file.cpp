// SPDX-License-Identifier: MIT
#include "limpet/vehicle_file/vehicle_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/source_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/mission/yaml_reader.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

/// Least number of thrusters: with fewer nothing pushes ahead, aside and down and turns, each by
/// itself.
constexpr std::size_t kLeastThrusters = 4;

namespace fs = std::filesystem;
using internal::TextOfNode;
using internal::ValueText;
using internal::YamlReader;

/// One entry of `thrusters.list`.
struct ThrusterEntry {
  std::string name;
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_B = Eigen::Vector3d::Zero();

  template <class V>
  void Describe(V& visit) {
    visit("name", name, "For messages and logs");
    visit("at_m", at_B, "m", "Where it pushes, from the body origin", InRange(-10.0, 10.0));
    visit("push", push_B, "", "The way it pushes the vehicle at a positive command; any length",
          InRange(-1e3, 1e3));
  }
};

void ReadThruster(YamlReader& in, const YAML::Node& node, const std::string& path,
                  std::set<std::string>& names, Thruster& thruster) {
  ThrusterEntry entry;
  in.ReadMap(node, path, in.Declared(path, DescribeParams(entry)));
  for (const char* key : {"name", "at_m", "push"}) {
    if (node.IsMap() && !node[key]) in.Complain(node, path + "." + key, "is missing");
  }
  if (!node.IsMap() || !node["push"]) return;
  if (!names.insert(entry.name).second) {
    in.Complain(node, path + ".name", fmt::format("`{}` is the name of two thrusters", entry.name));
  }
  const double length = entry.push_B.norm();
  if (length <= 0.0) {
    in.Complain(node, path + ".push",
                "a thruster pushes some way: `push: [forward, starboard, down]`");
    return;
  }
  // What is a unit vector to the last digit stays as it is written.
  const bool is_unit = std::abs(length - 1.0) < 1e-12;
  thruster = {.p_B = entry.at_B, .axis_B = is_unit ? entry.push_B : entry.push_B / length};
}

/// The thrusters of a file replace those of the default vehicle, all of them.
void ReadThrusterList(YamlReader& in, const YAML::Node& node, ThrusterLayout& layout) {
  const std::string path = "thrusters.list";
  if (!node.IsSequence() || node.size() < kLeastThrusters || node.size() > kMostThrusters) {
    in.Complain(node, path,
                fmt::format("{} is not allowed; allowed: a list of {} to {} thrusters",
                            TextOfNode(node), kLeastThrusters, kMostThrusters));
    return;
  }
  layout.thrusters.assign(node.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.size(); ++i) {
    ReadThruster(in, node[i], fmt::format("{}[{}]", path, i), names, layout.thrusters[i]);
  }
  if (!in.problems().empty()) return;
  if (layout.ControlledAxes().empty()) {
    in.Complain(
        node, path,
        "these thrusters cannot push the vehicle ahead, aside and down and turn it, each by "
        "itself");
  } else if (const auto alone = layout.Unpaired()) {
    in.Complain(node, fmt::format("{}[{}]", path, *alone),
                "its counterpart on the other side is missing: no other pushes as it does from "
                "there, the same or the opposite way");
  } else if (!layout.HeavesLevel()) {
    in.Complain(node, path,
                "these thrusters cannot push the vehicle down without pitching it: one ahead of "
                "or behind the middle has no counterpart");
  }
}

void CheckBody(YamlReader& in, const YAML::Node& root, const VehicleParams& params) {
  if (params.width_m >= params.length_m) {
    in.Complain(root["hull"], "hull.width_m", "a hull is longer than wide");
  }
  if (const double thickness = MeanThickness(params); thickness >= params.length_m) {
    in.Complain(
        root["hull"], "hull.mass_kg",
        fmt::format("a hull of {:g} kg, {:g} m long and {:g} m wide displaces as much as if "
                    "it were {:.2f} m thick; allowed: thinner than long",
                    params.mass, params.length_m, params.width_m, thickness));
  }
  if (const double down_n = params.thrusters.MostHeave(); params.net_buoyancy_n >= down_n) {
    in.Complain(
        root["hull"], "hull.net_buoyancy_n",
        fmt::format("the thrusters push down with {:.1f} N at most: it could not dive", down_n));
  }
  if (params.surfaced_depth_m >= params.submerged_depth_m) {
    in.Complain(
        root["hull"], "hull.surfaced_depth_m",
        fmt::format("`{:g}` is not allowed; allowed: less than hull.submerged_depth_m, {:g}",
                    params.surfaced_depth_m, params.submerged_depth_m));
  }
  if (params.antenna_B.z() >= 0.0) {
    in.Complain(root["hull"], "hull.antenna_m",
                "does not stand above the body's origin: it is under water wherever the vehicle "
                "floats, and no fix would come; allowed: a negative last number");
  }
}

/// A key of a section that says where something is carried.
struct Place {
  const char* section;
  const char* key;
  Eigen::Vector3d p_B;
};

/// Nothing is carried farther than a metre beyond the hull: a place out there is one in other
/// units, or in another order.
void CheckPlaces(YamlReader& in, const YAML::Node& root, const VehicleFile& vehicle) {
  const double farthest = 0.5 * vehicle.params.length_m + 1.0;
  for (const Place& place : {Place{"hull", "antenna_m", vehicle.params.antenna_B},
                             {"dvl", "at_m", vehicle.sensors.dvl.p_BD},
                             {"obstacle_sonar", "at_m", vehicle.sensors.sonar.p_BS},
                             {"camera", "at_m", vehicle.camera.p_BC}}) {
    const double off = place.p_B.norm();
    if (off <= farthest) continue;
    in.Complain(root[place.section], fmt::format("{}.{}", place.section, place.key),
                fmt::format("stands {:.2f} m from the body's origin, of a hull {:g} m long; "
                            "allowed: {:g} m, which is a metre beyond it",
                            off, vehicle.params.length_m, farthest));
  }
}

void CheckSensors(YamlReader& in, const YAML::Node& root, const SensorSheets& sensors) {
  if (sensors.sonar.least_range >= sensors.sonar.greatest_range) {
    in.Complain(
        root["obstacle_sonar"], "obstacle_sonar.least_range_m",
        fmt::format("`{:g}` is not allowed; allowed: less than "
                    "obstacle_sonar.greatest_range_m, {:g}",
                    sensors.sonar.least_range.value(), sensors.sonar.greatest_range.value()));
  }
  if (sensors.dvl.least_altitude >= sensors.dvl.greatest_altitude) {
    in.Complain(
        root["dvl"], "dvl.least_altitude_m",
        fmt::format("`{:g}` is not allowed; allowed: less than dvl.greatest_altitude_m, {:g}",
                    sensors.dvl.least_altitude.value(), sensors.dvl.greatest_altitude.value()));
  }
}

void CheckBattery(YamlReader& in, const YAML::Node& root, const BatterySheet& battery) {
  if (battery.is_present && battery.empty_v >= battery.full_v) {
    in.Complain(root["battery"], "battery.empty_v",
                fmt::format("`{:g}` is not allowed; allowed: less than battery.full_v, {:g}",
                            battery.empty_v, battery.full_v));
  }
}

/// Where a camera's axis meets the image, of so many pixels; nothing: in its middle.
struct AxisPlace {
  const char* key;
  std::optional<double> px;
  int size_px;
};

void CheckAxis(YamlReader& in, const YAML::Node& root, const AxisPlace& axis) {
  if (!axis.px || *axis.px < axis.size_px) return;
  in.Complain(root["camera"], axis.key,
              fmt::format("`{:g}`: the axis does not meet the image; allowed: less than {}",
                          *axis.px, axis.size_px));
}

void CheckCamera(YamlReader& in, const YAML::Node& root, const CameraParams& camera) {
  const double highest = std::abs(camera.tilt.value()) + 0.5 * camera.fov_along.value();
  if (highest >= RadiansFromDegrees(85.0)) {
    in.Complain(root["camera"], "camera.tilt_deg",
                fmt::format("the camera looks up or to the horizon: tilt and half of fov_along_deg "
                            "make {:.0f} deg; allowed: less than 85 deg from straight down",
                            DegreesFromRadians(highest)));
  }
  CheckAxis(in, root, {"camera.cx_px", camera.cx_px, camera.width_px});
  CheckAxis(in, root, {"camera.cy_px", camera.cy_px, camera.height_px});
  if (!LensModel::IsOneToOne(camera.pinhole(), camera.lens_distortion())) {
    in.Complain(
        root["camera"], "camera.distortion",
        "folds the image: towards its border two directions would come to lie in one pixel");
  }
}

/// What the files read so far say.
struct Reading {
  VehicleFile vehicle;
  bool has_thrusters = false;
};

void ReadSections(YamlReader& in, const YAML::Node& root, Reading& reading) {
  VehicleFile& file = reading.vehicle;
  std::vector<YamlReader::Field> sections;
  sections.push_back({kBasedOn, [](const YAML::Node&) {}});  // read before
  sections.push_back({"name", [&](const YAML::Node& node) { file.name = ValueText(node); }});
  for (KeySection& section : VehicleFileSections(file)) {
    sections.push_back({section.name, [&, section](const YAML::Node& node) {
                          if (section.name == "battery") file.battery.is_present = true;
                          std::vector<YamlReader::Field> fields =
                              in.Declared(section.name, section.keys);
                          if (section.name == "thrusters") {
                            fields.push_back({"list", [&](const YAML::Node& list) {
                                                reading.has_thrusters = true;
                                                ReadThrusterList(in, list, file.params.thrusters);
                                              }});
                          }
                          in.ReadMap(node, section.name, fields);
                        }});
  }
  in.ReadMap(root, "", sections);
}

/// Reads the files that this one is based on, the deepest first.
Reading ReadBase(YamlReader& in, const YAML::Node& root, const fs::path& folder) {
  Reading reading;
  if (!root.IsMap() || !root[kBasedOn]) return reading;
  const YAML::Node named = root[kBasedOn];
  const fs::path base = FindFactFile(VehicleFacts(), ValueText(named), folder);
  if (base.empty()) {
    in.Complain(named, kBasedOn, fmt::format("there is no {}", TextOfNode(named)));
    return reading;
  }
  std::vector<fs::path> chain = FactFileChain(VehicleFacts(), base);
  if (chain.size() >= kMostFactFiles) {
    in.Complain(named, kBasedOn, "files that are based on one another without end");
    return reading;
  }
  std::ranges::reverse(chain);
  for (const fs::path& file : chain) {
    YamlReader one(file.string());
    ReadSections(one, one.OnlyDocument(ReadTextFile(file)), reading);
    if (!one.problems().empty()) throw ConfigError(one.problems());
  }
  return reading;
}

VehicleFile ReadVehicle(YamlReader& in, const YAML::Node& root, const fs::path& folder) {
  Reading reading = ReadBase(in, root, folder);
  ReadSections(in, root, reading);
  if (!in.problems().empty()) return reading.vehicle;
  if (reading.vehicle.name.empty()) in.Complain(root, "name", "is missing: which vehicle is it?");
  if (!reading.has_thrusters) {
    in.Complain(root, "thrusters.list",
                fmt::format("is missing: {} to {} entries of name, at_m and push", kLeastThrusters,
                            kMostThrusters));
  }
  CheckBody(in, root, reading.vehicle.params);
  CheckPlaces(in, root, reading.vehicle);
  CheckSensors(in, root, reading.vehicle.sensors);
  CheckBattery(in, root, reading.vehicle.battery);
  CheckCamera(in, root, reading.vehicle.camera);
  return std::move(reading.vehicle);
}

/// The keys that blocks know as `camera_...`.
std::vector<ParamSpec> CameraKeys(VehicleFile& vehicle) {
  constexpr std::string_view kPrefix = "camera_";
  std::vector<ParamSpec> keys = DescribeParams(vehicle.camera);
  for (ParamSpec& key : keys) {
    if (key.name.starts_with(kPrefix)) key.name.erase(0, kPrefix.size());
  }
  std::ranges::move(DescribeParams(vehicle.camera_timing), std::back_inserter(keys));
  std::ranges::move(DescribeParams(vehicle.sensors.camera_mount), std::back_inserter(keys));
  return keys;
}

}  // namespace

std::vector<KeySection> VehicleFileSections(VehicleFile& vehicle) {
  SensorSheets& sensors = vehicle.sensors;
  return {{"hull", DescribeParams(vehicle.params)},
          {"thrusters", DescribeParams(vehicle.params.thrusters)},
          {"imu", DescribeParams(sensors.imu)},
          {"fog", DescribeParams(sensors.fog)},
          {"dvl", DescribeParams(sensors.dvl)},
          {"depth", DescribeParams(sensors.depth)},
          {"gps", DescribeParams(sensors.gps)},
          {"obstacle_sonar", DescribeParams(sensors.sonar)},
          {"camera", CameraKeys(vehicle)},
          {"battery", DescribeParams(vehicle.battery)}};
}

VehicleFile ParseVehicleFile(const std::string& text, const std::string& file) {
  YamlReader in(file);
  VehicleFile vehicle;
  in.ReadDocument(text, [&](const YAML::Node& root) {
    vehicle = ReadVehicle(in, root, fs::path(file).parent_path());
  });
  return vehicle;
}

VehicleFile LoadVehicleFile(const fs::path& file) {
  return ParseVehicleFile(ReadTextFile(file), file.string());
}

VehicleFile LoadMissionVehicle(const std::string& named, const fs::path& mission_folder) {
  const fs::path file = FindFactFile(VehicleFacts(), named, mission_folder);
  if (!file.empty()) return LoadVehicleFile(file);
  throw ConfigError(UnknownFactFile(VehicleFacts(), named, mission_folder));
}

}  // namespace limpet
