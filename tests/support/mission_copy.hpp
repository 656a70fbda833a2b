// SPDX-License-Identifier: MIT
// `limpet check` as a command line, and copies of missions to make slips in.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/verbs/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {

struct Checked {
  int exit_code = 0;
  std::string text;
};

inline Checked Check(const std::vector<std::string>& args) {
  ::testing::internal::CaptureStdout();
  const int exit_code = RunCheck(args);
  return {exit_code, ::testing::internal::GetCapturedStdout()};
}

/// Text that stands in a file, and what is to stand there; of a new file the first is empty.
struct Edit {
  std::string file;
  std::string from;
  std::string to;
};

/// The plug with an app's block, from a mission's folder.
inline std::string PlugOf(const std::string& app) { return "../plugs/plug_" + app + ".moos"; }

/// FeelHippo but for some lines of its file, flying the mission.
inline std::vector<Edit> Vehicle(const std::string& lines) {
  return {{"vehicle.yaml", "", "based_on: feelhippo.yaml\nname: Changed\n" + lines + "\n"},
          {"mission.moos", "ServerHost", "#define VEHICLE_FILE vehicle.yaml\nServerHost"}};
}

/// A copy of missions/table1, with the plugs beside it.
class MissionCopy {
 public:
  MissionCopy() {
    const std::filesystem::path source = LIMPET_SOURCE_DIR;
    std::filesystem::copy(source / "missions/table1", path());
    std::filesystem::copy(source / "plugs", folder_.path() / "plugs");
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "m"; }
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
  /// Changes the first place that has `from`.
  void Apply(const Edit& edit) const {
    const std::filesystem::path file = path() / edit.file;
    std::ifstream in(file);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t at = text.find(edit.from);
    ASSERT_NE(at, std::string::npos) << edit.from;
    text.replace(at, edit.from.size(), edit.to);
    std::ofstream(file) << text;
  }
  [[nodiscard]] Checked Run() const { return Check({path().string()}); }

 private:
  TemporaryFolder folder_;
};

/// Edits of a mission, and what `limpet check` makes of them.
struct Slip {
  std::string name;
  std::vector<Edit> edits;
  int exit_code = 0;
  std::vector<std::string> says;
};

inline std::ostream& operator<<(std::ostream& out, const Slip& slip) { return out << slip.name; }

inline void ExpectSaid(const Slip& slip) {
  const MissionCopy mission;
  for (const Edit& edit : slip.edits) {
    mission.Apply(edit);
  }
  const Checked checked = mission.Run();
  EXPECT_EQ(checked.exit_code, slip.exit_code) << checked.text;
  for (const std::string& text : slip.says) {
    EXPECT_THAT(checked.text, ::testing::HasSubstr(text));
  }
}

/// Files of missions/table1 and of its plugs, for edits.
inline const std::string kMoos = "mission.moos";
inline const std::string kBhv = "../plugs/plug_survey.bhv";
inline const std::string kAntler = PlugOf("ANTLER");
inline const std::string kMap = PlugOf("pMap");
inline const std::string kSurvey = PlugOf("pSurvey");
inline const std::string kHelm = PlugOf("pHelm");
inline const std::string kTruth = "scenario.yaml";

inline Edit Altitude(const std::string& meters) {
  return {kMoos, "survey_altitude_m = 4", "survey_altitude_m = " + meters};
}
inline Edit Without(const std::string& line, const std::string& file = kMoos) {
  return {file, line + "\n", ""};
}

}  // namespace limpet
