// SPDX-License-Identifier: MIT
// A mission as statements: each value with the line that gives it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/app/registry.hpp"
#include "limpet/core/camera_model.hpp"
#include "limpet/core/config.hpp"
#include "limpet/mission/behavior_file.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {

/// The value of one parameter, and who says it.
struct Setting {
  std::string owner;  ///< app, or name of the behavior
  std::string key;
  std::string text;
  std::string unit;
  SourceLine where;  ///< of the line; of the block if it is the default
  bool is_default = false;

  /// The number in the unit of the text; 0 if it is no number.
  [[nodiscard]] double number() const;
  /// `pSurvey altitude_m = 8 (mission.moos:93)`.
  [[nodiscard]] std::string Named() const;
  /// A problem of this line.
  [[nodiscard]] ConfigProblem Refuse(std::string text) const;
};

/// One of Limpet's apps that the mission launches, with its block (empty if it has none).
struct LaunchedApp {
  std::string process;
  const AppEntry* entry = nullptr;
  ConfigBlock block;
  SourceLine where;          ///< of its `Run` line
  std::string stands_for{};  ///< the stock program that the line names; empty: it names ours
};

/// Apps of Limpet's that are named as MOOS's are: in other people's missions a block is written for
/// those.
[[nodiscard]] bool IsNamesake(std::string_view process);

/// A mission that is other people's alone: it launches something, but neither LimpetDB nor an app
/// that only Limpet has.
[[nodiscard]] bool IsOthersAlone(const MissionFile& mission);

/// What a mission says, ready to be asked. Files that cannot be read are problems; what they would
/// say is then missing.
class MissionReading {
 public:
  MissionReading(const MissionFile& mission, std::filesystem::path folder);

  [[nodiscard]] const MissionFile& mission() const { return mission_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::vector<LaunchedApp>& apps() const { return apps_; }
  /// `Run` lines of programs that are not Limpet's, databases and consoles aside: they may write
  /// anything.
  [[nodiscard]] const std::vector<LaunchEntry>& strangers() const { return strangers_; }
  [[nodiscard]] bool Launches(std::string_view process) const;
  /// True if ours runs in place of a stock program, and not under its own name, too.
  [[nodiscard]] bool StandsIn(std::string_view process) const;
  /// A mission of other people's, or a piece of one: it launches programs that are not Limpet's, or
  /// none that is Limpet's by its name.
  [[nodiscard]] bool is_foreign() const;

  /// Parameter of an app that is launched; nothing if it is not, or has no such parameter.
  [[nodiscard]] std::optional<Setting> Find(std::string_view process, std::string_view key) const;
  /// Every line of a parameter that may repeat, or its default.
  [[nodiscard]] std::vector<Setting> FindAll(std::string_view process, std::string_view key) const;
  /// One parameter of each behavior of a type, in file order.
  [[nodiscard]] std::vector<Setting> OfBehaviors(std::string_view type, std::string_view key) const;

  [[nodiscard]] const std::vector<BehaviorFile>& behavior_files() const { return behavior_files_; }
  /// File of the vehicle; empty if there is none.
  [[nodiscard]] const std::filesystem::path& vehicle_path() const { return vehicle_path_; }
  /// Nothing without a file that can be read.
  [[nodiscard]] const std::optional<VehicleFile>& vehicle() const { return vehicle_; }
  /// A key of the vehicle's file with its line: that of the file alone where it has the default.
  [[nodiscard]] SourceLine InVehicle(std::string_view key) const;
  [[nodiscard]] const std::optional<Scenario>& scenario() const { return scenario_; }
  /// The first line of scenario.yaml that has `text`, or its file alone.
  [[nodiscard]] SourceLine InScenario(std::string_view text) const;
  /// The first line that has `text` from where a section begins on, e.g. `errors.fog` or `opis[2]`,
  /// the third of a list; or its file alone.
  [[nodiscard]] SourceLine InScenario(std::string_view section, std::string_view text) const;
  /// Problems of behavior files, scenario.yaml and expect.yaml.
  [[nodiscard]] const std::vector<ConfigProblem>& problems() const { return problems_; }
  /// What these files say that is ignored.
  [[nodiscard]] const std::vector<ConfigProblem>& warnings() const { return warnings_; }

 private:
  void SortLaunches();
  void LoadBehaviorFiles();
  void LoadTruth();
  void LoadVehicle();

  MissionFile mission_;
  std::filesystem::path folder_;
  std::vector<LaunchedApp> apps_;
  std::vector<LaunchEntry> strangers_;
  std::vector<BehaviorFile> behavior_files_;
  std::filesystem::path vehicle_path_;
  std::optional<VehicleFile> vehicle_;
  std::optional<Scenario> scenario_;
  std::string scenario_text_;
  std::string scenario_file_;
  std::vector<ConfigProblem> problems_, warnings_;
};

}  // namespace limpet
