// SPDX-License-Identifier: MIT
#include "limpet/core/folders_above.hpp"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FoldersAbove, NearestFirst) {
  const TemporaryFolder folder;
  const fs::path deep = folder.path() / "a/b";
  fs::create_directories(folder.path() / "share/things");
  fs::create_directories(deep / "share/things");
  std::vector<fs::path> found;
  AddFoldersAbove(deep, "share/things", found);
  EXPECT_THAT(found, ElementsAre(deep / "share/things", folder.path() / "share/things"));
}

TEST(FoldersAbove, AreNotFoundTwice) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "share");
  std::vector<fs::path> found;
  AddFoldersAbove(folder.path(), "share", found);
  AddFoldersAbove(folder.path(), "share", found);
  EXPECT_THAT(found, ElementsAre(folder.path() / "share"));
}

TEST(FoldersAbove, OfNoFolderAreNone) {
  std::vector<fs::path> found;
  AddFoldersAbove("", "share", found);
  AddFoldersAbove("/", "no-such-folder", found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(RunningProgramFolder, HoldsThisTest) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(RunningProgramFolder()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, Contains("unit_core"));
}

}  // namespace
}  // namespace limpet
