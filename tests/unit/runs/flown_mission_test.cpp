// SPDX-License-Identifier: MIT
#include "limpet/runs/flown_mission.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

class FlownMissionTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, const std::string& app) const {
    std::ofstream(folder_.path() / name)
        << "ProcessConfig = ANTLER\n{\n  Run = " << app << " @ NewConsole = false\n}\n";
  }
  [[nodiscard]] std::string Problem() const {
    try {
      return "none: " + FlownMissionAt(folder_.path()).string();
    } catch (const ConfigError& error) {
      return error.what();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(FlownMissionTest, IsMissionMoosWhereThereIsOne) {
  Write("mission.moos", "pShare");
  Write("vehicle.moos", "uSimVehicle");
  EXPECT_EQ(FlownMissionAt(folder_.path()), folder_.path() / "mission.moos");
}

TEST_F(FlownMissionTest, IsTheOneWithAVehicleAmongThoseOfSeveralCommunities) {
  Write("shore.moos", "pShare");
  Write("vehicle.moos", "uSimVehicle");
  EXPECT_EQ(FlownMissionAt(folder_.path()), folder_.path() / "vehicle.moos");
}

TEST_F(FlownMissionTest, IsTheFileThatIsNamed) {
  Write("shore.moos", "pShare");
  EXPECT_EQ(FlownMissionAt(folder_.path() / "shore.moos"), folder_.path() / "shore.moos");
}

TEST_F(FlownMissionTest, MustBeNamedWhereNoneOrSeveralHaveAVehicle) {
  Write("shore.moos", "pShare");
  EXPECT_THAT(Problem(), testing::HasSubstr("none of its missions launch uSimVehicle; name the"));
  Write("alpha.moos", "uSimVehicle");
  Write("bravo.moos", "uSimVehicle");
  EXPECT_THAT(Problem(), testing::HasSubstr("several of its missions launch uSimVehicle"));
}

}  // namespace
}  // namespace limpet
