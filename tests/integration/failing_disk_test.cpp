// SPDX-License-Identifier: MIT
// A mission whose disk fails under way: it is flown as if nothing were, and what is not recorded is
// said.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_reader.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/safety.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const fs::path kAlpha = fs::path(LIMPET_SOURCE_DIR) / "missions" / "alpha";

struct FlownOnADisk {
  std::vector<std::string> wishes;  ///< of the helm and the pilot, with their times
  std::string warnings;             ///< every PLOG_WARNINGS
  std::vector<LogState> states;
  std::size_t logged = 0;
};

/// Two minutes of alpha. `faults`: lines of the scenario; empty: none.
FlownOnADisk FlyOnADisk(const std::string& faults) {
  const TemporaryFolder folder;
  std::ifstream in(kAlpha / "scenario.yaml");
  const std::string scenario{std::istreambuf_iterator<char>(in), {}};
  const fs::path file = folder.path() / "scenario.yaml";
  std::ofstream(file) << scenario << (faults.empty() ? "" : "faults:\n" + faults);
  MissionFile mission = LoadMission(kAlpha / "mission.moos");
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    ApplySetting(mission, fmt::format("{}.scenario={}", app, file.string()));
  }
  FlownOnADisk flown;
  const auto note = [&flown](const Message& message) {
    if (message.name.starts_with("DESIRED_")) {
      flown.wishes.push_back(fmt::format("{:.3f} {} {}", message.time.value(), message.name,
                                         std::get<double>(message.value)));
    } else if (message.name == "PLOG_WARNINGS") {
      flown.warnings += std::get<std::string>(message.value) + "\n";
    } else if (message.name == topics::kLogState.name) {
      flown.states.push_back(*TopicCodec<LogState>::Decode(message.value));
    }
  };
  static_cast<void>(RunSession(mission,
                               {.session = "discovery",
                                .mission_folder = kAlpha,
                                .run_folder = folder.path() / "run",
                                .prior_folder = {},
                                .seed = 3,
                                .longest = Seconds(120.0)},
                               note));
  Expected<AlogReader> reader = AlogReader::Open(folder.path() / "run" / "discovery.alog");
  for (AlogEntry entry; reader && reader->Next(entry);) {
    ++flown.logged;
  }
  return flown;
}

TEST(FailingDisk, NeitherStopsNorChangesWhatTheHelmWants) {
  const FlownOnADisk sound = FlyOnADisk("");
  ASSERT_THAT(sound.wishes, Not(IsEmpty()));
  EXPECT_THAT(sound.states, IsEmpty());
  for (const char* fault : {"disk_full", "disk_failing", "disk_read_only"}) {
    const FlownOnADisk flown =
        FlyOnADisk(fmt::format("  - {{what: {}, at_s: 40, for_s: 20}}\n", fault));
    EXPECT_EQ(flown.wishes, sound.wishes) << fault;
    ASSERT_EQ(flown.states.size(), 2U) << fault;
    EXPECT_FALSE(flown.states.front().is_written);
    EXPECT_TRUE(flown.states.back().is_written);
    EXPECT_EQ(flown.states.back().missing, 0) << "twenty seconds wait for the disk";
    EXPECT_THAT(flown.warnings, HasSubstr("LOG_FAILED"));
    EXPECT_GE(flown.logged, sound.logged) << "and what was said of the disk";
  }
}

}  // namespace
}  // namespace limpet
