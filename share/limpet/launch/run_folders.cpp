// SPDX-License-Identifier: MIT
#include "limpet/launch/run_folders.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/command_line_error.hpp"
#include "limpet/session/session_name.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDiscovery = "discovery";

void RequireName(const std::string& session) {
  if (const auto problem = SessionNameProblem(session))
    throw CommandLineError("--session", problem->text);
}

bool HoldsSomething(const fs::path& folder) {
  std::error_code absent;
  return fs::exists(folder, absent) && !fs::is_empty(folder, absent);
}

bool HoldsSession(const fs::path& folder) {
  return fs::exists(folder / "session" / "manifest.json") || fs::exists(folder / "manifest.json");
}

/// A session that was deployed: it knows the area that it surveyed.
bool HoldsDive(const fs::path& folder) {
  std::error_code absent;
  return std::ranges::any_of(
      fs::directory_iterator(folder / "session", absent),
      [](const fs::directory_entry& entry) { return fs::exists(entry.path() / "area.txt"); });
}

/// `runs/table1-live`; missions that share a folder do not share what they leave.
fs::path FirstOf(const fs::path& mission_file) {
  const fs::path file = fs::absolute(mission_file);
  const std::string part = file.stem() == "mission" ? "" : "-" + file.stem().string();
  return fs::path("runs") / (file.parent_path().filename().string() + part + "-live");
}

fs::path Numbered(const fs::path& first, int number) {
  return number == 1 ? first : fs::path(fmt::format("{}-{}", first.string(), number));
}

/// Number of the latest of the folders that are there, numbered from 1; 0 if none is.
int LatestOf(const fs::path& first) {
  const std::string stem = first.filename().string() + "-";
  std::error_code absent;
  int latest = fs::exists(first) ? 1 : 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(first.parent_path(), absent)) {
    const std::string name = entry.path().filename().string();
    const std::string digits = name.starts_with(stem) ? name.substr(stem.size()) : "";
    if (!digits.empty() && digits.size() < 9 &&
        digits.find_first_not_of("0123456789") == std::string::npos) {
      latest = std::max(latest, std::stoi(digits));
    }
  }
  return latest;
}

fs::path GivenPrior(const LaunchCommand& command) {
  if (!HoldsSession(command.prior_folder)) {
    throw CommandLineError("--prior_folder",
                           command.prior_folder.string() + " holds no saved session");
  }
  return command.prior_folder;
}

RunFolders InGivenFolder(const LaunchCommand& command) {
  const fs::path& run = command.run_folder;
  if (HoldsSomething(run / command.session)) {
    throw CommandLineError(
        "--run_folder",
        fmt::format("{} holds what a former launch left, and is not overwritten; name "
                    "another folder, or leave --run_folder out",
                    (run / command.session).string()));
  }
  if (!command.prior_folder.empty()) {
    return {run, GivenPrior(command)};
  }
  if (command.session == kDiscovery) {
    return {run, {}};
  }
  if (!HoldsSession(run / kDiscovery)) {
    throw CommandLineError("--session",
                           fmt::format("`{}` compares with a former session, and {} holds none; "
                                       "--prior_folder=DIR names another",
                                       command.session, (run / kDiscovery).string()));
  }
  return {run, run / kDiscovery};
}

}  // namespace

RunFolders ChooseRunFolders(const LaunchCommand& command) {
  RequireName(command.session);
  if (!command.run_folder.empty()) {
    return InGivenFolder(command);
  }
  const fs::path first = FirstOf(command.mission_file);
  const int latest = LatestOf(first);
  // A fresh one: beside another dive's sessions nobody could tell which belong together.
  const bool is_fresh = latest == 0 || !HoldsSomething(Numbered(first, latest));
  const int next = std::max(1, is_fresh ? latest : latest + 1);
  if (command.session == kDiscovery || !command.prior_folder.empty()) {
    return {Numbered(first, next), command.prior_folder.empty() ? fs::path() : GivenPrior(command)};
  }
  for (int number = latest; number >= 1; --number) {
    const fs::path run = Numbered(first, number);
    if (HoldsDive(run / kDiscovery)) {
      // Beside its discovery, where `limpet report` looks for both.
      const bool has_room = !HoldsSomething(run / command.session);
      return {has_room ? run : Numbered(first, next), run / kDiscovery};
    }
  }
  throw CommandLineError(
      "--session", fmt::format("`{}` compares with a former session, and no dive is saved in {}; "
                               "fly a discovery first, or name one by --prior_folder=DIR",
                               command.session, first.string() + "*"));
}

}  // namespace limpet
