// SPDX-License-Identifier: MIT
#include "limpet/session/object_chips.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/session/session_memory.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

SavedChip Chip(int object, const std::string& jpeg) {
  return {.object = object,
          .chip = {.exposure = Seconds(1767225900.25),
                   .box = {.u = 320.5,
                           .v = 100.25,
                           .w = 80,
                           .h = 81.5,
                           .confidence = 0.9,
                           .color = "sea, star"},
                   .jpeg = jpeg}};
}

SessionFiles FilesWith(const std::vector<SavedChip>& chips) {
  SessionFiles files;
  AddChips(chips, files);
  return files;
}

TEST(ObjectChips, ComeBackFromTheirFiles) {
  const auto back = ChipsFrom(FilesWith({Chip(1, std::string("\xff\0x", 3)), Chip(7, "second")}));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), 2U);
  EXPECT_EQ((*back)[0].chip.jpeg, std::string("\xff\0x", 3));
  EXPECT_EQ((*back)[1].object, 7);
  EXPECT_EQ((*back)[1].chip.box.color, "sea, star");
  EXPECT_EQ((*back)[1].chip.box.h, 81.5);
  EXPECT_EQ((*back)[1].chip.exposure.value(), 1767225900.25);
}

TEST(ObjectChips, OfASessionWithoutImagesAreNone) {
  EXPECT_TRUE(FilesWith({}).empty());
  const auto back = ChipsFrom(SessionFiles{});
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->empty());
}

TEST(ObjectChips, NameTheLineOfAPictureThatIsMissingOrOfRubbish) {
  SessionFiles files = FilesWith({Chip(1, "first"), Chip(2, "second")});
  files.erase("chips/0001.jpg");
  EXPECT_THAT(ChipsFrom(files).error().text, HasSubstr("chips.csv: line 3"));
  files = FilesWith({Chip(1, "first")});
  files["chips.csv"] += "chips/0000.jpg,one,2,yellow,0.5,1,2,3,4\n";
  EXPECT_THAT(ChipsFrom(files).error().text, HasSubstr("line 3"));
}

TEST(ObjectChips, StayWithASessionsMemory) {
  SessionMemory memory;
  memory.chips = {Chip(3, "picture")};
  const auto back = MemoryOf(FilesOf(memory));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->chips.size(), 1U);
  EXPECT_EQ(FilesOf(*back), FilesOf(memory));
}

TEST(ObjectChips, AreThoseSeenNowElseThoseSavedBefore) {
  OpiBeliefs objects;
  objects.opis.resize(3);
  for (int i = 0; i < 3; ++i) {
    objects.opis[static_cast<std::size_t>(i)].id = i + 1;
    objects.opis[static_cast<std::size_t>(i)].landmark = 10 + i;
  }
  BestChips seen;
  ObservedFrame frame;
  frame.exposure = Seconds(5.0);
  frame.boxes = {{.u = 9, .v = 9, .w = 8, .h = 8, .confidence = 0.9, .color = {}, .landmark = 10}};
  seen.Add(
      ImageChips{.exposure = Seconds(5.0), .chips = {{.box = frame.boxes.front(), .jpeg = "now"}}});
  seen.Add(frame);
  const auto chips = ChipsOf(objects, seen, {Chip(1, "old"), Chip(2, "kept"), Chip(9, "gone")});
  ASSERT_EQ(chips.size(), 2U);
  EXPECT_EQ(chips[0].chip.jpeg, "now");
  EXPECT_EQ(chips[1].object, 2);
  EXPECT_EQ(chips[1].chip.jpeg, "kept");
}

}  // namespace
}  // namespace limpet
