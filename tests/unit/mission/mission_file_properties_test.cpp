// SPDX-License-Identifier: MIT
// What is written into a mission is what is read, and damaged text never passes in silence or
// crashes.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {
namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

std::string DrawName(Random& random) {
  std::string name(1 + random.Index(8), 'a');
  for (char& letter : name)
    letter = static_cast<char>('a' + random.Index(26));
  return name;
}

std::string DrawEntryValue(Random& random) {
  constexpr std::string_view kLetters = "abcxyz019._:,+- ()#";
  std::string value = "v";
  for (std::size_t i = random.Index(12); i > 0; --i)
    value += kLetters[random.Index(kLetters.size())];
  return value + "e";
}

std::string Blanks(Random& random) { return std::string(random.Index(4), ' '); }

struct DrawnMission {
  std::vector<std::pair<std::string, Lines>> blocks;
  std::string text;
};

/// Blocks of any entries, with comments and blanks where MOOS allows them.
DrawnMission DrawMission(Random& random) {
  DrawnMission drawn;
  drawn.text = "// a mission\nServerHost = localhost\n";
  for (std::size_t i = 0; i < 1 + random.Index(4); ++i) {
    const std::string name = "p" + std::to_string(i) + DrawName(random);
    Lines lines;
    drawn.text +=
        Blanks(random) + "ProcessConfig" + Blanks(random) + "=" + Blanks(random) + name + "\n{\n";
    for (std::size_t k = random.Index(6); k > 0; --k) {
      const std::string key = "k" + std::to_string(k) + DrawName(random);
      const std::string value = DrawEntryValue(random);
      lines.emplace_back(key, value);
      drawn.text += Blanks(random) + key + Blanks(random) + "=" + Blanks(random) + value +
                    Blanks(random) + (random.Chance(0.3) ? "// why" : "") + "\n";
      if (random.Chance(0.2)) drawn.text += "\n  // note\n";
    }
    drawn.text += "}\n";
    drawn.blocks.emplace_back(name, lines);
  }
  return drawn;
}

class MissionFileProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "mission"};
};

TEST_P(MissionFileProperties, EveryEntryIsReadAsItWasWritten) {
  for (int run = 0; run < 20; ++run) {
    const DrawnMission drawn = DrawMission(random_);
    const MissionFile mission = ParseMission(drawn.text, "drawn.moos");
    ASSERT_EQ(mission.blocks.size(), drawn.blocks.size()) << drawn.text;
    for (std::size_t i = 0; i < drawn.blocks.size(); ++i) {
      const auto& [name, lines] = drawn.blocks[i];
      const ConfigBlock* block = mission.Block(name);
      ASSERT_NE(block, nullptr) << name;
      ASSERT_EQ(block->entries.size(), lines.size()) << drawn.text;
      for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_EQ(block->entries[k].key, lines[k].first);
        EXPECT_EQ(block->entries[k].value, lines[k].second) << drawn.text;
      }
    }
  }
}

TEST_P(MissionFileProperties, EveryEntryKnowsItsLine) {
  const DrawnMission drawn = DrawMission(random_);
  std::vector<std::string> lines{""};
  for (const char letter : drawn.text) {
    if (letter == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += letter;
    }
  }
  for (const ConfigBlock& block : ParseMission(drawn.text, "drawn.moos").blocks) {
    for (const ConfigEntry& entry : block.entries) {
      EXPECT_EQ(entry.where.file, "drawn.moos");
      EXPECT_NE(lines.at(static_cast<std::size_t>(entry.where.line) - 1).find(entry.key),
                std::string::npos);
    }
  }
}

TEST_P(MissionFileProperties, WindowsLineEndsChangeNothing) {
  const DrawnMission drawn = DrawMission(random_);
  std::string windows;
  for (const char letter : drawn.text)
    windows += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  const MissionFile one = ParseMission(drawn.text, "a"), other = ParseMission(windows, "a");
  ASSERT_EQ(one.blocks.size(), other.blocks.size());
  for (std::size_t i = 0; i < one.blocks.size(); ++i) {
    ASSERT_EQ(one.blocks[i].entries.size(), other.blocks[i].entries.size());
    for (std::size_t k = 0; k < one.blocks[i].entries.size(); ++k)
      EXPECT_EQ(one.blocks[i].entries[k].value, other.blocks[i].entries[k].value);
  }
}

TEST_P(MissionFileProperties, DamagedTextIsReadOrRefusedWithALineAndNeverWorse) {
  const DrawnMission drawn = DrawMission(random_);
  for (int run = 0; run < 60; ++run) {
    std::string text = drawn.text;
    for (std::size_t hits = 1 + random_.Index(3); hits > 0; --hits) {
      const std::size_t at = random_.Index(text.size());
      switch (random_.Index(3)) {
        case 0:
          text.erase(at, 1);
          break;
        case 1:
          text.insert(at, 1, static_cast<char>(random_.Index(256)));
          break;
        default:
          text[at] = "{}=$\"\n/"[random_.Index(7)];
          break;
      }
    }
    try {
      const MissionFile mission = ParseMission(text, "damaged.moos");
      EXPECT_LE(mission.blocks.size(), text.size());
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged.moos"), std::string::npos) << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, MissionFileProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
