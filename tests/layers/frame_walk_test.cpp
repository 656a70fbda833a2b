// SPDX-License-Identifier: MIT
#include "tests/layers/frame_walk.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::vector<FrameStep> WalkOfTheArchitecture() {
  return ReadFrameWalk(ReadAll(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs/architecture.md"));
}

TEST(FrameWalk, IsTakenByTheCodeStepByStep) {
  const std::vector<FrameStep> walk = WalkOfTheArchitecture();
  EXPECT_GT(walk.size(), 5U) << "the table was not found";
  EXPECT_THAT(StepsNotTaken(walk, TreeFiles()), IsEmpty());
}

TEST(FrameWalk, FromCameraToVerdictHasAtMostEightRoomsAndThreeStructs) {
  const std::vector<FrameStep> walk = WalkOfTheArchitecture();
  EXPECT_LE(RoomsOf(walk).size(), 8U);
  EXPECT_LE(TypesOf(walk).size(), 3U);
}

TEST(FrameWalk, LeavesTheSmootherAside) {
  const Names frames = TypesOf(WalkOfTheArchitecture());
  ASSERT_THAT(frames, SizeIs(3));
  for (const SourceFile& file : TreeFiles()) {
    if (!file.path.starts_with("estimation/smoothing/")) continue;
    EXPECT_THAT(file.text, Not(HasSubstr("limpet/objects/"))) << file.path;
    for (const std::string& type : frames)
      EXPECT_THAT(file.text, Not(HasSubstr(type))) << file.path;
  }
}

TEST(FrameWalk, IsReadFromItsTable) {
  const std::vector<FrameStep> walk = ReadFrameWalk(
      "text\n| file | function | struct | next |\n| --- | --- | --- | --- |\n"
      "| `apps/a/a.cpp` | `A::Take` | `Frame` | `Tell`: B |\n"
      "| `apps/a/b.cpp` | `B::Take` | a view | `Done` |\n\n| `late.cpp` | `X` | `Y` | `Z` |\n");
  ASSERT_THAT(walk, SizeIs(2));
  EXPECT_EQ(walk[0].function, "A::Take");
  EXPECT_EQ(walk[0].next, "Tell");
  EXPECT_THAT(RoomsOf(walk), ElementsAre("apps/a"));
  EXPECT_THAT(TypesOf(walk), ElementsAre("Frame"));
}

TEST(FrameWalk, ThatTheCodeDoesNotTakeIsComplainedAbout) {
  const FrameStep step{
      .file = "a/a.cpp", .function = "A::Take", .type = "Frame", .next = "b_.Take"};
  const SourceFile header{"a/a.hpp", "struct Frame {};\n"};
  EXPECT_THAT(StepsNotTaken({step}, {header, {"a/a.cpp", "void A::Take(int x) { b_.Take(x); }\n"}}),
              IsEmpty());
  EXPECT_THAT(StepsNotTaken({step}, {{"a/a.cpp", "void A::Taken() {}\n"}}),
              ElementsAre("a/a.cpp: has no A::Take", "a/a.cpp: names no Frame",
                          "a/a.cpp: does not call b_.Take"));
  EXPECT_THAT(StepsNotTaken({step}, {header}), ElementsAre("a/a.cpp: there is no such file"));
}

}  // namespace
}  // namespace limpet::layers
