// SPDX-License-Identifier: MIT
#include "limpet/vehicle_file/vehicle_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/source_text.hpp"
#include "limpet/mission/yaml_reader.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using internal::TextOfNode;
using internal::YamlReader;

/// A scalar as it stands, a list as `[a, b, c]`.
std::string ValueText(const YAML::Node& node) {
  if (!node.IsSequence()) return node.IsScalar() ? node.Scalar() : TextOfNode(node);
  std::vector<std::string> parts;
  for (const YAML::Node& part : node) {
    parts.push_back(part.IsScalar() ? part.Scalar() : TextOfNode(part));
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::vector<YamlReader::Field> FieldsOf(YamlReader& in, const std::string& path,
                                        const std::vector<ParamSpec>& specs) {
  std::vector<YamlReader::Field> fields;
  fields.reserve(specs.size());
  for (const ParamSpec& spec : specs) {
    fields.push_back({spec.name, [&in, path, spec](const YAML::Node& node) {
                        if (auto complaint = spec.set(ValueText(node))) {
                          in.Complain(node, path + "." + spec.name, *std::move(complaint));
                        }
                      }});
  }
  return fields;
}

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
                  Thruster& thruster) {
  ThrusterEntry entry;
  in.ReadMap(node, path, FieldsOf(in, path, DescribeParams(entry)));
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
  if (!node.IsSequence() || node.size() != kThrusters) {
    in.Complain(node, path,
                fmt::format("{} is not allowed; allowed: a list of {} thrusters", TextOfNode(node),
                            kThrusters));
    return;
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    ReadThruster(in, node[i], fmt::format("{}[{}]", path, i), layout.thrusters[i]);
  }
  if (in.problems().empty() && layout.ControlledAxes().empty()) {
    in.Complain(
        node, path,
        "these thrusters cannot push the vehicle ahead, aside and down and turn it, each by "
        "itself");
  }
}

void CheckBody(YamlReader& in, const YAML::Node& root, const VehicleParams& params) {
  if (params.width_m >= params.length_m) {
    in.Complain(root["hull"], "hull.width_m", "a hull is longer than wide");
  }
  if (params.surfaced_depth_m >= params.submerged_depth_m) {
    in.Complain(root["hull"], "hull.surfaced_depth_m", "lies above hull.submerged_depth_m");
  }
}

VehicleFile ReadVehicle(YamlReader& in, const YAML::Node& root) {
  VehicleFile file;
  bool has_thrusters = false;
  std::vector<YamlReader::Field> sections;
  sections.push_back({"name", [&](const YAML::Node& node) { file.name = ValueText(node); }});
  for (VehicleFileSection& section : VehicleFileSections(file.params)) {
    sections.push_back({section.name, [&, section](const YAML::Node& node) {
                          std::vector<YamlReader::Field> fields =
                              FieldsOf(in, section.name, section.keys);
                          if (section.name == "thrusters") {
                            fields.push_back({"list", [&](const YAML::Node& list) {
                                                has_thrusters = true;
                                                ReadThrusterList(in, list, file.params.thrusters);
                                              }});
                          }
                          in.ReadMap(node, section.name, fields);
                        }});
  }
  in.ReadMap(root, "", sections);
  if (!in.problems().empty()) return file;
  if (file.name.empty()) in.Complain(root, "name", "is missing: which vehicle is it?");
  if (!has_thrusters) {
    in.Complain(root, "thrusters.list",
                fmt::format("is missing: {} entries of name, at_m and push", kThrusters));
  }
  CheckBody(in, root, file.params);
  return file;
}

/// `share/vehicles` of every folder above `folder`.
void AddVehicleFolders(fs::path folder, std::vector<fs::path>& found) {
  std::error_code ignored;
  for (int level = 0; level < 32 && !folder.empty(); ++level) {
    const fs::path candidate = folder / "share" / "vehicles";
    if (fs::is_directory(candidate, ignored) &&
        std::ranges::find(found, candidate) == found.end()) {
      found.push_back(candidate);
    }
    if (folder == folder.parent_path()) return;
    folder = folder.parent_path();
  }
}

std::vector<fs::path> VehicleFolders(const fs::path& mission_folder) {
  std::error_code ignored;
  std::vector<fs::path> folders{mission_folder};
  AddVehicleFolders(fs::absolute(mission_folder, ignored).lexically_normal(), folders);
  AddVehicleFolders(fs::read_symlink("/proc/self/exe", ignored).parent_path(), folders);
  return folders;
}

}  // namespace

std::vector<VehicleFileSection> VehicleFileSections(VehicleParams& params) {
  return {{"hull", DescribeParams(params)}, {"thrusters", DescribeParams(params.thrusters)}};
}

VehicleFile ParseVehicleFile(const std::string& text, const std::string& file) {
  YamlReader in(file);
  VehicleFile vehicle;
  try {
    vehicle = ReadVehicle(in, YAML::Load(text));
  } catch (const YAML::Exception& error) {
    in.Complain(error.mark.line + 1, "", "not YAML: " + error.msg);
  }
  if (!in.problems().empty()) throw ConfigError(in.problems());
  return vehicle;
}

VehicleFile LoadVehicleFile(const fs::path& file) {
  return ParseVehicleFile(ReadTextFile(file), file.string());
}

fs::path FindVehicleFile(const fs::path& named, const fs::path& mission_folder) {
  std::error_code ignored;
  for (const fs::path& folder : VehicleFolders(mission_folder)) {
    if (fs::is_regular_file(folder / named, ignored)) return folder / named;
  }
  return {};
}

VehicleFile LoadMissionVehicle(const std::string& named, const fs::path& mission_folder) {
  const fs::path file = named.empty() ? fs::path() : FindVehicleFile(named, mission_folder);
  if (!file.empty()) return LoadVehicleFile(file);
  std::vector<std::string> known, looked_in;
  std::error_code ignored;
  for (const fs::path& folder : VehicleFolders(mission_folder)) {
    looked_in.push_back(folder.string());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      const bool is_vehicle =
          entry.path().extension() == ".yaml" &&
          (folder != mission_folder || entry.path().filename() == "vehicle.yaml");
      if (is_vehicle) known.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(known);
  const std::string complaint = named.empty() ? "is missing: which vehicle flies this mission?"
                                              : fmt::format("there is no `{}`", named);
  throw ConfigError(ConfigProblem{
      .where = {},
      .key = kVehicleFileGlobal,
      .text = fmt::format("{}; known: {} (looked in {})", complaint,
                          known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")),
                          fmt::join(looked_in, ", "))});
}

}  // namespace limpet
