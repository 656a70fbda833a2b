// SPDX-License-Identifier: MIT
#include "limpet/mission/obstacle_reading.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/scenario_reach.hpp"
#include "limpet/mission/yaml_list.hpp"

namespace limpet::internal {
namespace {

/// `[n, e]`, or nothing and a complaint.
std::optional<Eigen::Vector2d> ReadSize(YamlReader& in, const YAML::Node& node,
                                        const std::string& key) {
  constexpr double kLeast = 0.05, kMost = 1000.0;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
  bool is_good = node.IsSequence() && node.size() == 2;
  for (std::size_t i = 0; is_good && i < 2; ++i) {
    const std::optional<double> value = YamlReader::NumberIn(node[i]);
    is_good = value && *value >= kLeast && *value <= kMost;
    size[static_cast<Eigen::Index>(i)] = value.value_or(0.0);
  }
  if (is_good) return size;
  in.Complain(
      node, key,
      fmt::format("{} is not allowed; allowed: [northwards, eastwards] in metres, each {:g} "
                  "to {:g}",
                  TextOfNode(node), kLeast, kMost));
  return std::nullopt;
}

/// Keys that it lacks, or that its shape has no use for.
void CheckKeys(YamlReader& in, const YAML::Node& node, const std::string& path,
               const ScenarioObstacle& obstacle) {
  if (!node.IsMap()) return;
  for (const char* key : {"name", "shape", "north_m", "east_m", "height_m"}) {
    if (!node[key]) in.Complain(node, path, fmt::format("needs a {}", key));
  }
  if (!node["shape"]) return;
  const bool is_column = obstacle.shape == "column";
  const char* const its_key = is_column ? "radius_m" : "size_m";
  const char* const other_key = is_column ? "size_m" : "radius_m";
  if (!node[its_key])
    in.Complain(node, path, fmt::format("a {} needs a {}", obstacle.shape, its_key));
  if (node[other_key]) {
    in.Complain(node[other_key], path + "." + other_key,
                fmt::format("a {} has none; it has {}", obstacle.shape, its_key));
  }
}

ScenarioObstacle ReadObstacle(YamlReader& in, const YAML::Node& node, const std::string& path) {
  ScenarioObstacle obstacle;
  const auto read_size = [&](const YAML::Node& size) {
    obstacle.size_m = ReadSize(in, size, path + ".size_m").value_or(obstacle.size_m);
  };
  in.ReadMap(node, path,
             {NameField(in, path, obstacle.name),
              in.Choice(path, "shape", obstacle.shape, {"column", "box"}),
              in.Number(path, "north_m", obstacle.north_m, InRange(-kFarthest_m, kFarthest_m)),
              in.Number(path, "east_m", obstacle.east_m, InRange(-kFarthest_m, kFarthest_m)),
              in.Number(path, "radius_m", obstacle.radius_m, InRange(0.05, 500.0)),
              {"size_m", read_size},
              in.Number(path, "height_m", obstacle.height_m, InRange(0.1, 6000.0))});
  CheckKeys(in, node, path, obstacle);
  return obstacle;
}

}  // namespace

void ReadObstacles(YamlReader& in, const YAML::Node& node,
                   std::vector<ScenarioObstacle>& obstacles) {
  DistinctNames names(in, "obstacles");
  ReadList(in, node, "obstacles", [&](const YAML::Node& element, const std::string& path) {
    obstacles.push_back(ReadObstacle(in, element, path));
    names.Add(element, path, obstacles.back().name);
  });
}

void CheckObstacles(YamlReader& in, const YAML::Node& node, const Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.obstacles.size(); ++i) {
    const ScenarioObstacle& obstacle = scenario.obstacles[i];
    const UprightBody body = obstacle.Body(scenario.seabed);
    const std::string path = fmt::format("obstacles[{}]", i);
    if (body.Covers({scenario.start.north_m, scenario.start.east_m}) && body.top() <= 0.0) {
      in.Complain(node[i], path, fmt::format("the vehicle starts inside `{}`", obstacle.name));
    }
    for (const ScenarioOpi& opi : scenario.opis) {
      for (const auto& [session, place] : opi.places) {
        if (place && body.Distance(*place) <= 0.0) {
          in.Complain(node[i], path,
                      fmt::format("`{}` is inside `{}` in {}", opi.name, obstacle.name, session));
        }
      }
    }
  }
}

}  // namespace limpet::internal
