// SPDX-License-Identifier: MIT
// The mission as it was run, kept with its session, reads as the mission that it was.
#include "limpet/session/saved_session.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {
namespace {

MissionFile RandomMission(Random& random) {
  const std::array<const char*, 6> values{"5",      "two words", "a,b:c=d",
                                          "-1.5e3", "true",      "north < 3 and (x = 1)"};
  MissionFile mission;
  for (int i = 0; i < 4; ++i) {
    mission.globals.push_back({"Global" + std::to_string(i), std::to_string(random.Index(99)), {}});
  }
  for (int b = 0; b < 3; ++b) {
    ConfigBlock block{.name = "pApp" + std::to_string(b), .where = {}, .entries = {}};
    for (std::uint64_t i = random.Index(6); i > 0; --i) {
      // Keys may repeat: a block may have several `behaviors` lines.
      block.entries.push_back(
          {"key" + std::to_string(random.Index(3)), values[random.Index(values.size())], {}});
    }
    mission.blocks.push_back(block);
  }
  return mission;
}

void ExpectSameEntries(const std::vector<ConfigEntry>& a, const std::vector<ConfigEntry>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].key, b[i].key);
    EXPECT_EQ(a[i].value, b[i].value);
  }
}

TEST(MissionAsRun, ReadsAsTheMissionThatItWas) {
  Random random(1, "mission");
  for (int run = 0; run < 100; ++run) {
    const MissionFile mission = RandomMission(random);
    const MissionFile back =
        ParseMission(MissionText(mission.globals, mission.blocks), "as_run.moos");
    ExpectSameEntries(back.globals, mission.globals);
    ASSERT_EQ(back.blocks.size(), mission.blocks.size());
    for (std::size_t b = 0; b < mission.blocks.size(); ++b) {
      EXPECT_EQ(back.blocks[b].name, mission.blocks[b].name);
      ExpectSameEntries(back.blocks[b].entries, mission.blocks[b].entries);
    }
  }
}

/// A line of a mission with whatever a value may hold, in quotes or not.
std::string RandomEntry(Random& random, int number) {
  const std::array<const char*, 9> pieces{"http://shore", "//", " ", "{", "}", "a", "=", ",", "\t"};
  std::string value;
  for (std::uint64_t i = 1 + random.Index(5); i > 0; --i)
    value += pieces[random.Index(pieces.size())];
  // A brace outside of quotes is no text.
  const bool has_brace = value.find_first_of("{}") != std::string::npos;
  if (has_brace || random.Chance(0.5)) value = "\"" + value + "\"";
  if (random.Chance(0.2)) value += " \"more\"";
  return "key" + std::to_string(number) + " = x" + value + "\n";
}

TEST(MissionAsRun, ReadsAsTheMissionThatItWasWhateverItsValuesHold) {
  Random random(2, "texts");
  for (int run = 0; run < 400; ++run) {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += RandomEntry(random, i);
    for (const char* app : {"pMap", "pHelm"}) {
      text += std::string("ProcessConfig = ") + app + "\n{\n";
      for (int i = 0; i < 3; ++i)
        text += RandomEntry(random, i);
      text += "}\n";
    }
    const MissionFile mission = ParseMission(text, "mission.moos");
    const std::string copy = MissionText(mission.globals, mission.blocks);
    const MissionFile back = ParseMission(copy, "as_run.moos");
    ExpectSameEntries(back.globals, mission.globals);
    ASSERT_EQ(back.blocks.size(), mission.blocks.size());
    for (std::size_t b = 0; b < mission.blocks.size(); ++b)
      ExpectSameEntries(back.blocks[b].entries, mission.blocks[b].entries);
    if (::testing::Test::HasFailure()) FAIL() << text << "\nbecame\n" << copy;
  }
}

TEST(MissionAsRun, AnAddressWithItsSlashesIsKept) {
  const MissionFile mission = ParseMission(
      "Page = \"http://shore/map\"\nProcessConfig = pMap\n{\n  page = \"http://shore\"  // "
      "why\n}\n",
      "mission.moos");
  const MissionFile back =
      ParseMission(MissionText(mission.globals, mission.blocks), "as_run.moos");
  EXPECT_EQ(back.globals.at(0).value, "http://shore/map");
  EXPECT_EQ(back.Block("pMap")->Find("page")->value, "http://shore");
}

TEST(MissionAsRun, GivesAnAppItsBlockWithTheFileAndLineWhereItStands) {
  SavedSession session;
  session.folder = "saved";
  session.memory.mission["other.moos"] = "ProcessConfig = pMap\n{\n  radius = 9\n}\n";
  session.memory.mission[kMissionAsRun] = "\nProcessConfig = pMap\n{\n  radius = 5\n}\n";
  const auto block = BlockOf(session, "pMap");
  ASSERT_TRUE(block && block->Find("radius") != nullptr);
  EXPECT_EQ(block->Find("radius")->value, "5") << "as it was run, not as a file had it";
  EXPECT_EQ(block->Find("radius")->where.line, 4);
  EXPECT_TRUE(block->Find("radius")->where.file.ends_with("mission/as_run.moos"));
  const auto defaults = BlockOf(session, "pNav");
  ASSERT_TRUE(defaults) << "no block in it: the app flew with its defaults";
  EXPECT_TRUE(defaults->entries.empty());
  session.memory.mission.erase(kMissionAsRun);
  EXPECT_EQ(BlockOf(session, "pMap")->Find("radius")->value, "9");
  EXPECT_FALSE(BlockOf(session, "pNav")) << "what the files do not say, nobody knows";
}

}  // namespace
}  // namespace limpet
