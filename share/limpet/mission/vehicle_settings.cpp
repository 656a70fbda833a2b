// SPDX-License-Identifier: MIT
#include "limpet/mission/vehicle_settings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "limpet/core/number_text.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

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

/// A scalar as it stands, a list as `[a, b, c]`; nothing for a map.
std::optional<std::string> TextIn(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (!node.IsSequence()) return std::nullopt;
  std::vector<std::string> parts;
  for (const YAML::Node& part : node) {
    if (!part.IsScalar()) return std::nullopt;
    parts.push_back(part.Scalar());
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

YAML::Node ReadYaml(const fs::path& file) {
  try {
    return YAML::Load(ReadTextFile(file));
  } catch (const YAML::Exception&) {
  } catch (const ConfigError&) {
  }
  return {};
}

/// The first of a key counts.
void AddEntries(const fs::path& file, std::vector<ConfigEntry>& entries) {
  const YAML::Node root = ReadYaml(file);
  if (!root.IsMap()) return;
  for (const auto& section : root) {
    if (!section.first.IsScalar() || !section.second.IsMap()) continue;
    for (const auto& pair : section.second) {
      if (!pair.first.IsScalar()) continue;
      const std::string key = section.first.Scalar() + "." + pair.first.Scalar();
      const std::optional<std::string> text = TextIn(pair.second);
      if (text && std::ranges::find(entries, key, &ConfigEntry::key) == entries.end()) {
        entries.push_back({key, *text, {file.string(), pair.first.Mark().line + 1}});
      }
    }
  }
}

/// What the file says for a taker; nothing if it does not.
std::optional<ConfigEntry> ValueFor(const VehicleTaker& taker,
                                    const std::vector<ConfigEntry>& entries) {
  const auto entry = std::ranges::find(entries, taker.vehicle_key, &ConfigEntry::key);
  if (entry == entries.end()) return std::nullopt;
  std::string text = entry->value;
  if (taker.part >= 0) {
    std::erase_if(text, [](char letter) { return letter == '[' || letter == ']'; });
    const std::vector<std::string> parts = Split(text, ',');
    if (static_cast<std::size_t>(taker.part) >= parts.size()) return std::nullopt;
    text = std::string(Trim(parts[static_cast<std::size_t>(taker.part)]));
  }
  return ConfigEntry{taker.key, text, entry->where};
}

bool IsSameValue(const std::string& a, const std::string& b) {
  constexpr double kSlack = 1e-9;
  const std::optional<double> first = ParseNumber(a);
  const std::optional<double> other = ParseNumber(b);
  if (!first || !other) return a == b;
  return std::abs(*first - *other) <= kSlack * std::abs(*first);
}

void DropFormer(const VehicleTaker& taker, const std::optional<ConfigEntry>& value,
                ConfigBlock& block) {
  std::erase_if(block.entries, [&](const ConfigEntry& entry) {
    if (!EqualsIgnoringCase(entry.key, taker.key)) return false;
    if (!value) {
      block.problems.push_back({entry.where, entry.key,
                                fmt::format("`{}`: the vehicle's file says it, by its key {}",
                                            entry.value, taker.vehicle_key)});
    } else if (!IsSameValue(entry.value, value->value)) {
      block.problems.push_back(
          {entry.where, entry.key,
           fmt::format("`{}`: the vehicle's file says it, and says {} ({}:{}: {})", entry.value,
                       value->value, value->where.file, value->where.line, taker.vehicle_key)});
    }
    return true;
  });
}

/// A block may stand under the name that its program is launched as.
std::string OwnerOf(const ConfigBlock& block, const MissionFile& mission) {
  const auto launch = std::ranges::find_if(mission.launches, [&block](const LaunchEntry& l) {
    return EqualsIgnoringCase(l.moos_name, block.name);
  });
  return launch == mission.launches.end() ? block.name
                                          : fs::path(launch->binary).filename().string();
}

std::vector<VehicleTaker> MakeTakers() {
  std::vector<VehicleTaker> takers;
  for (const char* owner : {"pHelm", "pMap", "pNav", "uSimCamera"}) {
    takers.push_back({owner, "camera_fov_across_deg", "camera.fov_across_deg"});
    takers.push_back({owner, "camera_fov_along_deg", "camera.fov_along_deg"});
    takers.push_back({owner, "camera_width_px", "camera.width_px"});
    takers.push_back({owner, "camera_height_px", "camera.height_px"});
    takers.push_back({owner, "camera_at_m", "camera.at_m"});
    takers.push_back({owner, "camera_tilt_deg", "camera.tilt_deg"});
    takers.push_back({owner, "camera_fx_px", "camera.fx_px"});
    takers.push_back({owner, "camera_fy_px", "camera.fy_px"});
    takers.push_back({owner, "camera_cx_px", "camera.cx_px"});
    takers.push_back({owner, "camera_cy_px", "camera.cy_px"});
    takers.push_back({owner, "camera_distortion", "camera.distortion"});
  }
  takers.push_back({"uSimCamera", "rate_hz", "camera.rate_hz"});
  takers.push_back({"uSimCamera", "latency_s", "camera.latency_s"});
  takers.push_back({"pMap", "dvl_yaw_deg", "dvl.yaw_deg"});
  takers.push_back({"pMap", "dvl_beam_angle_deg", "dvl.beam_angle_deg"});
  const auto former = [&takers](const char* key, const char* vehicle_key, int part) {
    takers.push_back({"pNav", key, vehicle_key, part, true});
  };
  former("heading_sigma_deg", "imu.heading_sigma_deg", -1);
  former("dvl_x_m", "dvl.at_m", 0);
  former("dvl_y_m", "dvl.at_m", 1);
  former("dvl_z_m", "dvl.at_m", 2);
  former("top_speed_mps", "hull.top_speed_mps", -1);
  takers.push_back({"pNodeReporter", "platform_length", "hull.length_m"});
  takers.push_back({"pNodeReporter", "vessel_length", "hull.length_m"});
  return takers;
}

}  // namespace

std::vector<fs::path> VehicleFolders(const fs::path& mission_folder) {
  std::error_code ignored;
  std::vector<fs::path> folders{mission_folder};
  AddVehicleFolders(fs::absolute(mission_folder, ignored).lexically_normal(), folders);
  AddVehicleFolders(fs::read_symlink("/proc/self/exe", ignored).parent_path(), folders);
  return folders;
}

fs::path FindVehicleFile(const fs::path& named, const fs::path& mission_folder) {
  std::error_code ignored;
  for (const fs::path& folder : VehicleFolders(mission_folder)) {
    if (fs::is_regular_file(folder / named, ignored)) return folder / named;
  }
  return {};
}

std::vector<fs::path> VehicleFileChain(const fs::path& file) {
  std::vector<fs::path> chain;
  fs::path next = file;
  while (!next.empty() && chain.size() < kMostVehicleFiles) {
    chain.push_back(next);
    const YAML::Node root = ReadYaml(next);
    if (!root.IsMap() || !root[kBasedOn] || !root[kBasedOn].IsScalar()) break;
    next = FindVehicleFile(root[kBasedOn].Scalar(), next.parent_path());
  }
  return chain;
}

const std::vector<VehicleTaker>& VehicleTakers() {
  static const std::vector<VehicleTaker> takers = MakeTakers();
  return takers;
}

std::string_view VehicleKeyFor(std::string_view owner, std::string_view key) {
  for (const VehicleTaker& taker : VehicleTakers()) {
    if (owner == taker.owner && EqualsIgnoringCase(key, taker.key)) return taker.vehicle_key;
  }
  return "";
}

std::vector<ConfigEntry> VehicleEntries(const fs::path& file) {
  std::vector<ConfigEntry> entries;
  for (const fs::path& one : VehicleFileChain(file)) {
    AddEntries(one, entries);
  }
  return entries;
}

void TakeVehicle(MissionFile& mission) {
  const std::string named = mission.Global(kVehicleFileGlobal);
  const fs::path file =
      named.empty() ? fs::path() : FindVehicleFile(named, fs::path(mission.file).parent_path());
  const std::vector<std::string> former_files = std::move(mission.vehicle_files);
  mission.vehicle_files.clear();
  for (const fs::path& one : VehicleFileChain(file)) {
    mission.vehicle_files.push_back(one.string());
  }
  const std::vector<ConfigEntry> entries = VehicleEntries(file);
  for (ConfigBlock& block : mission.blocks) {
    const std::string owner = OwnerOf(block, mission);
    std::erase_if(block.entries, [&former_files](const ConfigEntry& entry) {
      return std::ranges::find(former_files, entry.where.file) != former_files.end();
    });
    for (const VehicleTaker& taker : VehicleTakers()) {
      if (!EqualsIgnoringCase(owner, taker.owner)) continue;
      const std::optional<ConfigEntry> value = ValueFor(taker, entries);
      if (taker.is_former) {
        DropFormer(taker, value, block);
      } else if (value && block.Find(taker.key) == nullptr) {
        block.entries.push_back(*value);
      }
    }
  }
}

}  // namespace limpet
