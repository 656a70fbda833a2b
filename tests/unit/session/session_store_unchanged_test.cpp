// SPDX-License-Identifier: MIT
// Files of a session that are as in the generation before: they are not written again.
#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/session/session_store.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

constexpr const char* kWest = "map/-1_0.ot.gz";
constexpr const char* kEast = "map/0_0.ot.gz";

/// The machine's disk, which tells what it was asked and may refuse links.
class WatchedDisk final : public FileSystem {
 public:
  [[nodiscard]] Opened Open(const fs::path& path, Opening how) override {
    written.push_back(path.filename().string());
    return RealFileSystem().Open(path, how);
  }
  [[nodiscard]] std::error_code Rename(const fs::path& from, const fs::path& to) override {
    return RealFileSystem().Rename(from, to);
  }
  [[nodiscard]] std::error_code Link(const fs::path& existing, const fs::path& name) override {
    if (link_trouble) return std::make_error_code(*link_trouble);
    const std::error_code trouble = RealFileSystem().Link(existing, name);
    link_counts.push_back(fs::hard_link_count(name));
    return trouble;
  }
  [[nodiscard]] std::error_code Remove(const fs::path& path) override {
    return RealFileSystem().Remove(path);
  }
  [[nodiscard]] std::error_code CreateFolder(const fs::path& path) override {
    return RealFileSystem().CreateFolder(path);
  }
  [[nodiscard]] std::error_code SyncFolder(const fs::path& path) override {
    return RealFileSystem().SyncFolder(path);
  }
  [[nodiscard]] std::optional<std::uint64_t> Room(const fs::path& path) const override {
    return RealFileSystem().Room(path);
  }

  std::optional<std::errc> link_trouble;
  std::vector<std::string> written;
  std::vector<std::uintmax_t> link_counts;  ///< of each file that was linked, just then
};

class UnchangedFilesTest : public ::testing::Test {
 protected:
  UnchangedFilesTest() {
    EXPECT_TRUE(writer_.Commit({}, files_));
    disk_.written.clear();
  }
  /// The next generation: other objects, the map as it was.
  [[nodiscard]] Expected<int> CommitKeepingMap(SessionWriter& writer) {
    files_["objects.json"] = "later";
    return writer.Commit({}, {{"objects.json", "later"}}, {kWest, kEast});
  }
  void ExpectSaved(const SessionFiles& files, int generation) const {
    const Expected<StoredSession> loaded = LoadSession(home_);
    ASSERT_TRUE(loaded) << loaded.error().text;
    EXPECT_EQ(loaded->files, files);
    EXPECT_EQ(loaded->generation, generation);
  }

  TemporaryFolder folder_;
  fs::path home_ = folder_.path() / "session";
  WatchedDisk disk_;
  SessionFiles files_{
      {"objects.json", "none"}, {kWest, std::string("\0west\xff", 6)}, {kEast, "east"}};
  SessionWriter writer_{home_, disk_};
};

TEST_F(UnchangedFilesTest, AreTheFilesOfTheGenerationBefore) {
  fs::create_hard_link(home_ / "g000001" / kWest, folder_.path() / "west");
  ASSERT_TRUE(CommitKeepingMap(writer_));
  EXPECT_THAT(disk_.written, UnorderedElementsAre("objects.json", "manifest.json.new"));
  EXPECT_THAT(disk_.link_counts, UnorderedElementsAre(2U, 3U)) << "one has its witness here";
  EXPECT_TRUE(fs::equivalent(folder_.path() / "west", home_ / "g000002" / kWest));
  EXPECT_FALSE(fs::exists(home_ / "g000001"));
  EXPECT_EQ(fs::hard_link_count(home_ / "g000002" / kEast), 1U);
  ExpectSaved(files_, 2);
}

TEST_F(UnchangedFilesTest, AreKeptOverManyGenerations) {
  for (int generation = 2; generation < 6; ++generation) {
    const std::string east = std::to_string(generation);
    files_[kEast] = east;
    ASSERT_TRUE(writer_.Commit({}, {{kEast, east}}, {"objects.json", kWest}));
    ExpectSaved(files_, generation);
  }
  EXPECT_THAT(disk_.written, Not(Contains("-1_0.ot.gz")));
}

TEST_F(UnchangedFilesTest, MakeTheManifestThatFilesWrittenWouldMake) {
  ASSERT_TRUE(CommitKeepingMap(writer_));
  SessionWriter other(folder_.path() / "other");
  ASSERT_TRUE(other.Commit({}, {}));
  ASSERT_TRUE(other.Commit({}, files_));
  EXPECT_EQ(*ReadWhole(home_ / "manifest.json"),
            *ReadWhole(folder_.path() / "other" / "manifest.json"));
}

TEST_F(UnchangedFilesTest, AreKeptByAWriterThatBeginsOverAFolder) {
  SessionWriter next_life(home_, disk_);
  ASSERT_TRUE(CommitKeepingMap(next_life));
  EXPECT_EQ(disk_.link_counts.size(), 2U);
  ExpectSaved(files_, 2);
  ASSERT_TRUE(CommitKeepingMap(next_life));
  ExpectSaved(files_, 3);
}

TEST_F(UnchangedFilesTest, AreCopiesWhereTheDiskHasNoLinks) {
  int generation = 1;
  for (const std::errc trouble :
       {std::errc::operation_not_permitted, std::errc::not_supported,
        std::errc::operation_not_supported, std::errc::function_not_supported,
        std::errc::too_many_links, std::errc::cross_device_link}) {
    disk_.link_trouble = trouble;
    ASSERT_TRUE(CommitKeepingMap(writer_));
    ExpectSaved(files_, ++generation);
  }
  EXPECT_THAT(disk_.link_counts, IsEmpty());
  EXPECT_THAT(disk_.written, AllOf(Contains("-1_0.ot.gz"), Contains("0_0.ot.gz")));
}

TEST_F(UnchangedFilesTest, AreNotCopiedFromADamagedFile) {
  disk_.link_trouble = std::errc::operation_not_permitted;
  std::ofstream(home_ / "g000001" / kEast, std::ios::binary) << "EAST";
  const Expected<int> saved = CommitKeepingMap(writer_);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text, AllOf(HasSubstr(kEast), HasSubstr("checksum")));
  EXPECT_FALSE(fs::exists(home_ / "g000002"));
}

TEST_F(UnchangedFilesTest, EndTheSaveWhereTheDiskFails) {
  disk_.link_trouble = std::errc::io_error;
  EXPECT_FALSE(writer_.Commit({}, {{"objects.json", "later"}}, {kWest, kEast}));
  EXPECT_FALSE(fs::exists(home_ / "g000002"));
  ExpectSaved(files_, 1);
  disk_.link_trouble.reset();
  ASSERT_TRUE(CommitKeepingMap(writer_));
  ExpectSaved(files_, 2);
}

TEST_F(UnchangedFilesTest, AreNamedIfTheGenerationBeforeLacksThem) {
  SessionWriter next_life(home_, disk_);
  for (SessionWriter* writer : {&writer_, &next_life}) {
    const Expected<int> saved =
        writer->Commit({}, {{"objects.json", "later"}}, {kWest, "map/9_9.ot.gz"});
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text, HasSubstr("map/9_9.ot.gz cannot be kept"));
    EXPECT_FALSE(fs::exists(home_ / "g000002"));
    ExpectSaved(files_, 1);
  }
}

TEST_F(UnchangedFilesTest, AreNamedIfThereIsNoGenerationBefore) {
  SessionWriter first(folder_.path() / "other", disk_);
  const Expected<int> saved = first.Commit({}, {{"objects.json", "later"}}, {kWest});
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text, AllOf(HasSubstr(kWest), HasSubstr("no complete session")));
  EXPECT_FALSE(fs::exists(folder_.path() / "other"));
  EXPECT_TRUE(first.Commit({}, files_)) << "all of them written";
}

TEST_F(UnchangedFilesTest, AreNamedIfTheyAreGoneOrCutSinceAndMayBeWrittenAgain) {
  fs::resize_file(home_ / "g000001" / kEast, 2);
  EXPECT_THAT(CommitKeepingMap(writer_).error().text,
              AllOf(HasSubstr(kEast), HasSubstr("2 bytes instead of 4")));
  fs::remove(home_ / "g000001" / kEast);
  EXPECT_THAT(CommitKeepingMap(writer_).error().text,
              AllOf(HasSubstr(kEast), HasSubstr("missing")));
  ASSERT_TRUE(writer_.Commit({}, {{"objects.json", "later"}, {kEast, "east"}}, {kWest}));
  ExpectSaved(files_, 2);
}

TEST_F(UnchangedFilesTest, GiveWayToWhatIsWritten) {
  files_[kEast] = "anew";
  ASSERT_TRUE(writer_.Commit({}, files_, {kWest, kEast}));
  EXPECT_THAT(disk_.link_counts, IsEmpty());
  ExpectSaved(files_, 2);
}

TEST(UnchangedFiles, LeaveALoadableGenerationWheneverThePowerIsCut) {
  const TemporaryFolder place(PlaceInMemory());
  fs::create_directory(place.path() / "disk");
  TornDisk disk(place.path() / "disk");
  SessionWriter writer(place.path() / "disk/session", disk);
  std::vector<SessionFiles> saved{{{"objects.json", "1"}, {kWest, "west"}, {kEast, "east"}}};
  ASSERT_TRUE(writer.Commit({}, saved.back()));
  std::vector<std::size_t> calls{disk.calls()};  // when each was said to be saved
  const SessionFiles changes[] = {{{kEast, "changed"}}, {{"objects.json", "2"}}, {{kWest, "too"}}};
  for (const SessionFiles& written : changes) {
    SessionFiles all = written;
    std::set<std::string> unchanged;
    for (const auto& former : saved.back()) {
      if (all.insert(former).second) unchanged.insert(former.first);
    }
    saved.push_back(std::move(all));
    ASSERT_TRUE(writer.Commit({}, written, unchanged));
    calls.push_back(disk.calls());
  }
  Random random(1, "cuts");
  for (std::size_t at = calls.front(); at <= disk.calls(); ++at) {
    for (int cut = 0; cut < 10; ++cut) {
      disk.Cut(at, random, place.path() / "left");
      const Expected<StoredSession> left = LoadSession(place.path() / "left/session");
      ASSERT_TRUE(left) << "after call " << at << ": " << left.error().text;
      EXPECT_EQ(left->files, saved.at(static_cast<std::size_t>(left->generation) - 1));
      EXPECT_GE(left->generation,
                std::ranges::count_if(calls, [at](std::size_t done) { return done <= at; }));
    }
  }
}

}  // namespace
}  // namespace limpet
