// SPDX-License-Identifier: MIT
// What `limpet check` makes of the globals of a mission: strict in ours, notes in other people's.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "tests/support/mission_copy.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A global, and what is said of it.
struct Global {
  std::string line;
  std::string says;
};

class CheckOfGlobals : public ::testing::TestWithParam<Global> {
 protected:
  [[nodiscard]] Checked Run(const std::string& apps) const {
    const std::filesystem::path moos = folder_.path() / "a.moos";
    std::ofstream(moos) << GetParam().line << "\nCommunity = alpha\nProcessConfig = ANTLER\n{\n"
                        << apps << "}\nProcessConfig = uSimMarine\n{\n  x = 1\n}\n";
    return Check({moos.string()});
  }
  TemporaryFolder folder_;
};

TEST_P(CheckOfGlobals, AreNotesWhereOnlyOtherPeoplesAppsRun) {
  const Checked others = Run("  Run = MOOSDB\n  Run = uSimMarine\n");
  EXPECT_EQ(others.exit_code, kOk) << others.text;
  EXPECT_THAT(others.text, HasSubstr("a.moos:1: note: "));
  EXPECT_THAT(others.text, HasSubstr(GetParam().says));
}

TEST_P(CheckOfGlobals, AreErrorsWhereOneOfOursRuns) {
  const Checked ours = Run("  Run = LimpetDB\n  Run = uSimMarine\n");
  EXPECT_EQ(ours.exit_code, kUsage) << ours.text;
  EXPECT_THAT(ours.text, Not(HasSubstr("a.moos:1: note: "))) << "said once, as an error";
}

INSTANTIATE_TEST_SUITE_P(
    Lines, CheckOfGlobals,
    ::testing::Values(
        Global{"Title = ${LIMPET_NO_SUCH}", "${LIMPET_NO_SUCH}: is defined neither here"},
        Global{"MOOSTimeWarp = 0.5", "`0.5` is not allowed; allowed: 1 to 400"},
        Global{"MOOSTimeWarp = 1000", "allowed: 1 to 400"},
        Global{"MOOSTimeWarp = fast", "allowed: 1 to 400"},
        Global{"LatOrigin = 43.8N", "LatOrigin: `43.8N` is not allowed; allowed: -90 to 90"},
        Global{"ServerPort = abc", "ServerPort: `abc` is not allowed; allowed: 1 to 65535"},
        Global{"VehicleFile = x", "VehicleFile: "},
        Global{"survey_altitude = 3", "did you mean `survey_altitude_m`?"},
        Global{"LonOrigin = 9", "did you mean `LongOrigin`?"},
        Global{"MOOSTimeWarpp = 2", "did you mean `MOOSTimeWarp`?"}));

}  // namespace
}  // namespace limpet
