// SPDX-License-Identifier: MIT
#include "limpet/comparison/session_comparison.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Two sessions that saw nothing, with missions as they say.
class SessionComparisonTest : public ::testing::Test {
 protected:
  SavedSession Saved(const std::string& name, std::map<std::string, std::string> mission) {
    SessionMemory memory;
    memory.mission = std::move(mission);
    EXPECT_TRUE(SessionWriter(folder_.path() / name / "session").Commit({}, FilesOf(memory)));
    return LoadSavedSession(folder_.path() / name, name);
  }
  static std::string ComplaintAbout(const SavedSession& a, const SavedSession& b) {
    try {
      static_cast<void>(CompareSessions(a, b));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(SessionComparisonTest, NamesTheSavedMissionThatItCannotRead) {
  const SavedSession a =
      Saved("discovery", {{"mission.moos", "ProcessConfig = pMap\n{\n  decide_at = 2\n}\n"}});
  EXPECT_THAT(ComplaintAbout(a, Saved("change", {})),
              HasSubstr("discovery/mission/mission.moos:3: decide_at"));
}

TEST_F(SessionComparisonTest, RefusesASessionWithoutAMissionAndSaysWhatHelps) {
  EXPECT_THAT(ComplaintAbout(Saved("discovery", {}), Saved("change", {})), HasSubstr("--mission"));
}

TEST_F(SessionComparisonTest, FindsNothingWhereNothingWasSeen) {
  const std::map<std::string, std::string> mission{
      {"mission.moos",
       "ProcessConfig = pMap\n{\n  camera_fov_across_deg = 80\n  camera_fov_along_deg = 60\n"
       "  camera_width_px = 640\n  camera_height_px = 480\n  object_radius_m = 0.5\n}\n"}};
  const SessionComparison comparison =
      CompareSessions(Saved("discovery", mission), Saved("change", mission));
  EXPECT_TRUE(comparison.objects.empty());
  EXPECT_THAT(Json(comparison), HasSubstr("\"changes\": []"));
}

}  // namespace
}  // namespace limpet
