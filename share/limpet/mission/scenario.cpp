// SPDX-License-Identifier: MIT
#include "limpet/mission/scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/fault_reading.hpp"
#include "limpet/mission/obstacle_reading.hpp"
#include "limpet/mission/scenario_reach.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/yaml_list.hpp"
#include "limpet/mission/yaml_reader.hpp"
#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

using internal::kFarthest_m;
using internal::TextOfNode;
using internal::YamlReader;

void ReadSeabed(YamlReader& in, const YAML::Node& node, Scenario::Seabed& seabed) {
  const std::string path = "seabed";
  in.ReadMap(node, path,
             {in.Number(path, "depth_m", seabed.depth_m, InRange(0.5, 6000.0)),
              in.Number(path, "slope_deg", seabed.slope_deg, InRange(0.0, 45.0)),
              in.Number(path, "slope_toward_deg", seabed.slope_toward_deg, InRange(-360.0, 360.0)),
              in.Number(path, "roughness_m", seabed.roughness_m, InRange(0.0, 2.0)),
              in.Integer(path, "seed", seabed.seed, InRange(0.0, 2147483647.0))});
}

void ReadWater(YamlReader& in, const YAML::Node& node, Scenario::Water& water) {
  const std::string path = "water";
  std::vector<YamlReader::Field> fields = {
      in.Number(path, "visibility_m", water.visibility_m, InRange(0.1, 100.0)),
      in.Number(path, "current_north_mps", water.current_north_mps, InRange(-3.0, 3.0)),
      in.Number(path, "current_east_mps", water.current_east_mps, InRange(-3.0, 3.0))};
  std::ranges::move(in.Declared(path, DescribeParams(water.current)), std::back_inserter(fields));
  in.ReadMap(node, path, fields);
}

void ReadStart(YamlReader& in, const YAML::Node& node, Scenario::Start& start) {
  const std::string path = "start";
  in.ReadMap(node, path,
             {in.Number(path, "north_m", start.north_m, InRange(-kFarthest_m, kFarthest_m)),
              in.Number(path, "east_m", start.east_m, InRange(-kFarthest_m, kFarthest_m)),
              in.Number(path, "heading_deg", start.heading_deg, InRange(-360.0, 360.0))});
}

void ReadSensors(YamlReader& in, const YAML::Node& node, Scenario::Sensors& sensors) {
  const std::string path = "sensors";
  in.ReadMap(
      node, path,
      {in.Number(path, "dvl_dropout_per_min", sensors.dvl_dropout_per_min, InRange(0.0, 60.0)),
       in.Number(path, "dvl_outlier_share", sensors.dvl_outlier_share, InRange(0.0, 1.0)),
       in.Number(path, "yaw_bias_deg_per_h", sensors.yaw_bias_deg_per_h, InRange(-360.0, 360.0)),
       in.Number(path, "heading_sigma_deg", sensors.heading_sigma_deg, InRange(0.0, 45.0)),
       in.Number(path, "gps_sigma_m", sensors.gps_sigma_m, InRange(0.0, 100.0)),
       in.Number(path, "false_detections_per_image", sensors.false_detections_per_image,
                 InRange(0.0, 10.0))});
}

/// What differs from the vehicle's data sheets, by sensor.
void ReadErrors(YamlReader& in, const YAML::Node& node, SimulatedErrors& errors) {
  std::vector<YamlReader::Field> sections;
  for (const KeySection& section : ErrorSections(errors)) {
    const std::string path = "errors." + section.name;
    sections.push_back({section.name, [&in, path, keys = section.keys](const YAML::Node& map) {
                          in.ReadMap(map, path, in.Declared(path, keys));
                        }});
  }
  in.ReadMap(node, "errors", sections);
}

/// How rendered pictures look: keys of its own, then a section per stage.
void ReadImageLook(YamlReader& in, const YAML::Node& node, ImageParams& image) {
  std::vector<YamlReader::Field> fields;
  for (const KeySection& section : ImageSections(image)) {
    if (section.name.empty()) {
      std::ranges::move(in.Declared("image", section.keys), std::back_inserter(fields));
      continue;
    }
    const std::string path = "image." + section.name;
    fields.push_back({section.name, [&in, path, keys = section.keys](const YAML::Node& map) {
                        in.ReadMap(map, path, in.Declared(path, keys));
                      }});
  }
  in.ReadMap(node, "image", fields);
}

/// `[n, e, d]`, or nothing and a complaint.
std::optional<Eigen::Vector3d> ReadPlace(YamlReader& in, const YAML::Node& node,
                                         const std::string& key) {
  std::array<double, 3> ned{};
  bool is_good = node.IsSequence() && node.size() == ned.size();
  for (std::size_t i = 0; is_good && i < ned.size(); ++i) {
    const std::optional<double> value = YamlReader::NumberIn(node[i]);
    is_good = value && std::abs(*value) <= kFarthest_m;
    ned[i] = value.value_or(0.0);
  }
  if (!is_good) {
    in.Complain(node, key,
                fmt::format("{} is not allowed; allowed: [north, east, down] in metres, or null",
                            TextOfNode(node)));
    return std::nullopt;
  }
  return Eigen::Vector3d(ned[0], ned[1], ned[2]);
}

/// Any word may name a session, but not one that is a slip of the pen away from a known key.
std::string MisspeltKey(const std::string& key) {
  static const std::vector<std::string> known{"name", "color", "radius_m", "discovery", "change"};
  const std::string nearest = NearestWord(key, known);
  const bool is_near =
      !nearest.empty() && !key.starts_with(nearest) &&
      std::max(nearest.size(), key.size()) - std::min(nearest.size(), key.size()) <= 1;
  return is_near ? nearest : "";
}

void ReadSessionPlace(YamlReader& in, const std::string& path, const std::string& key,
                      const YAML::Node& node, ScenarioOpi& opi) {
  const std::string known = MisspeltKey(key);
  if (key != "discovery" && key != "change" && !known.empty()) {
    in.Complain(node, path + "." + key, fmt::format("unknown key; did you mean `{}`?", known));
  } else if (node.IsNull()) {
    opi.places[key] = std::nullopt;
  } else if (const auto place = ReadPlace(in, node, path + "." + key)) {
    opi.places[key] = place;
  }
}

ScenarioOpi ReadOpi(YamlReader& in, const YAML::Node& node, const std::string& path) {
  ScenarioOpi opi;
  std::vector<YamlReader::Field> fields = {
      internal::NameField(in, path, opi.name), in.Choice(path, "color", opi.color, ColorNames()),
      in.Number(path, "radius_m", opi.radius_m, InRange(0.05, 5.0))};
  std::ranges::move(in.Declared(path, DescribeParams(opi.shape)), std::back_inserter(fields));
  std::ranges::move(in.Declared(path, DescribeParams(opi.motion)), std::back_inserter(fields));
  in.ReadMap(node, path, fields, [&](const std::string& key, const YAML::Node& place) {
    ReadSessionPlace(in, path, key, place, opi);
  });
  if (node.IsMap() && (!node["name"] || !node["color"])) {
    in.Complain(node, path, "needs a name and a color");
  }
  return opi;
}

void ReadOpis(YamlReader& in, const YAML::Node& node, std::vector<ScenarioOpi>& opis) {
  internal::DistinctNames names(in, "objects");
  internal::ReadList(in, node, "opis", [&](const YAML::Node& element, const std::string& path) {
    opis.push_back(ReadOpi(in, element, path));
    names.Add(element, path, opis.back().name);
  });
}

/// An object must be in the water: not above the surface, not wholly inside the seabed.
void CheckPlaces(YamlReader& in, const YAML::Node& opis, const Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.opis.size(); ++i) {
    const ScenarioOpi& opi = scenario.opis[i];
    for (const auto& [session, place] : opi.places) {
      if (!place) {
        continue;
      }
      const double bottom = SeabedDepth(scenario.seabed, place->head<2>());
      if (place->z() - opi.radius_m < 0.0 || place->z() - opi.radius_m > bottom) {
        in.Complain(opis[i], fmt::format("opis[{}].{}", i, session),
                    fmt::format("`{}` is not in the water: down {:.2f} m, radius {:.2f} m, seabed "
                                "at {:.2f} m",
                                opi.name, place->z(), opi.radius_m, bottom));
      }
    }
  }
}

/// The plain look knows spheres of one colour only.
void CheckShapes(YamlReader& in, const YAML::Node& opis, const Scenario& scenario) {
  if (scenario.image.look != "plain") return;
  for (std::size_t i = 0; i < scenario.opis.size(); ++i) {
    if (scenario.opis[i].shape.is_plain()) continue;
    in.Complain(opis[i], fmt::format("opis[{}]", i),
                fmt::format("the shape or band of `{}` shows only with `image: {{look: real}}`",
                            scenario.opis[i].name));
  }
}

Scenario ReadScenario(YamlReader& in, const YAML::Node& root, bool checks_places) {
  Scenario scenario;
  YAML::Node opis, obstacles;
  in.ReadMap(
      root, "",
      {{"seabed", [&](const YAML::Node& n) { ReadSeabed(in, n, scenario.seabed); }},
       {"water", [&](const YAML::Node& n) { ReadWater(in, n, scenario.water); }},
       {"start", [&](const YAML::Node& n) { ReadStart(in, n, scenario.start); }},
       {"opis",
        [&](const YAML::Node& n) {
          opis = n;
          ReadOpis(in, n, scenario.opis);
        }},
       {"obstacles",
        [&](const YAML::Node& n) {
          obstacles = n;
          internal::ReadObstacles(in, n, scenario.obstacles);
        }},
       in.Choice("", "camera", scenario.camera, {"rendered", "boxes"}),
       {"sensors", [&](const YAML::Node& n) { ReadSensors(in, n, scenario.sensors); }},
       {"errors", [&](const YAML::Node& n) { ReadErrors(in, n, scenario.errors); }},
       {"image", [&](const YAML::Node& n) { ReadImageLook(in, n, scenario.image); }},
       {"faults", [&](const YAML::Node& n) { internal::ReadFaults(in, n, scenario.faults); }}});
  CheckShapes(in, opis, scenario);
  if (checks_places && in.problems().empty()) {
    CheckPlaces(in, opis, scenario);
    internal::CheckObstacles(in, obstacles, scenario);
  }
  return scenario;
}

}  // namespace

std::vector<KeySection> DeclaredScenarioSections() {
  static Scenario scenario;
  static ScenarioOpi opi;
  std::vector<KeySection> sections = {{"water", DescribeParams(scenario.water.current)},
                                      {"opis[]", DescribeParams(opi.motion)}};
  std::ranges::move(DescribeParams(opi.shape), std::back_inserter(sections.back().keys));
  for (KeySection& section : ErrorSections(scenario.errors)) {
    sections.push_back({"errors." + section.name, std::move(section.keys)});
  }
  for (KeySection& section : ImageSections(scenario.image)) {
    sections.push_back(
        {section.name.empty() ? "image" : "image." + section.name, std::move(section.keys)});
  }
  return sections;
}

std::optional<Eigen::Vector3d> ScenarioOpi::Place(const std::string& session) const {
  const auto found = places.find(session);
  return found == places.end() ? std::nullopt : found->second;
}

UprightBody ScenarioObstacle::Body(const ScenarioSeabed& seabed) const {
  const double top = SeabedDepth(seabed, {north_m, east_m}) - height_m;
  if (shape == "column")
    return UprightBody::Column({north_m, east_m}, {.radius = radius_m, .top = top});
  return UprightBody::Box({north_m, east_m}, 0.5 * size_m, top);
}

std::vector<UprightBody> BodiesOf(const Scenario& scenario) {
  std::vector<UprightBody> bodies;
  bodies.reserve(scenario.obstacles.size());
  for (const ScenarioObstacle& obstacle : scenario.obstacles) {
    bodies.push_back(obstacle.Body(scenario.seabed));
  }
  return bodies;
}

std::vector<std::string> SessionsOf(const Scenario& scenario) {
  std::set<std::string> sessions;
  for (const ScenarioOpi& opi : scenario.opis) {
    for (const auto& [session, place] : opi.places) {
      sessions.insert(session);
    }
  }
  if (sessions.contains("discovery") || sessions.contains("change")) {
    sessions.insert({"discovery", "change"});
  }
  return {sessions.begin(), sessions.end()};
}

Scenario ParseScenario(const std::string& text, const std::string& file, bool checks_places) {
  YamlReader in(file);
  Scenario scenario;
  in.ReadDocument(
      text, [&](const YAML::Node& root) { scenario = ReadScenario(in, root, checks_places); });
  return scenario;
}

Scenario LoadScenario(const std::filesystem::path& file) {
  return ParseScenario(ReadTextFile(file), file.string());
}

}  // namespace limpet
