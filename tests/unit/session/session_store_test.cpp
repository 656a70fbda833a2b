// SPDX-License-Identifier: MIT
#include "limpet/session/session_store.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const SessionFacts kFacts{.limpet = "",
                          .mission = "table1",
                          .session = "discovery",
                          .community = "alpha",
                          .seed = 7,
                          .lat_origin = "43.7",
                          .long_origin = "10.3",
                          .saved_at = 1767225600.25,
                          .cause = "end"};
const SessionFiles kFiles{{"objects.json", "{\"opis\":[]}\n"},
                          {"map.ot", std::string("\0\1binary\xff", 9)},
                          {"mission/a.moos", "Community = alpha\n"}};

void Overwrite(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

std::vector<fs::path> AllFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

class SessionStoreTest : public ::testing::Test {
 protected:
  fs::path Saved() {
    const Expected<int> generation = SessionWriter(home_).Commit(kFacts, kFiles);
    EXPECT_TRUE(generation);
    return home_;
  }
  TemporaryFolder folder_;
  fs::path home_ = folder_.path() / "session";
};

TEST_F(SessionStoreTest, RemovesNothingButItsOwnGenerations) {
  SessionWriter writer(home_);
  ASSERT_TRUE(writer.Commit(kFacts, kFiles));
  fs::create_directories(home_ / "gopro");
  Overwrite(home_ / "gopro/dive.mp4", "precious");
  ASSERT_TRUE(writer.Commit(kFacts, kFiles));
  EXPECT_FALSE(fs::exists(home_ / "g000001"));
  EXPECT_TRUE(fs::exists(home_ / "gopro/dive.mp4"));
}

TEST_F(SessionStoreTest, GivesBackWhatWasSaved) {
  const Expected<StoredSession> loaded = LoadSession(Saved());
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->files, kFiles);
  EXPECT_EQ(loaded->facts.seed, 7U);
  EXPECT_EQ(loaded->facts.limpet, "0.1.0");
}

TEST_F(SessionStoreTest, IsFoundFromTheRunFolderToo) {
  Saved();
  EXPECT_TRUE(LoadSession(folder_.path()));
}

TEST_F(SessionStoreTest, KeepsOnlyTheLastGeneration) {
  SessionWriter writer(home_);
  ASSERT_TRUE(writer.Commit(kFacts, kFiles));
  ASSERT_TRUE(writer.Commit(kFacts, {{"objects.json", "later"}}));
  const Expected<StoredSession> loaded = LoadSession(home_);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->generation, 2);
  EXPECT_EQ(loaded->files.at("objects.json"), "later");
  EXPECT_EQ(AllFiles(home_).size(), 2U);
}

TEST_F(SessionStoreTest, WritesEqualBytesForEqualContent) {
  const fs::path other = folder_.path() / "other";
  ASSERT_TRUE(SessionWriter(other).Commit(kFacts, kFiles));
  const std::vector<fs::path> files = AllFiles(Saved());
  for (const fs::path& file : files) {
    EXPECT_EQ(*ReadWhole(file), *ReadWhole(other / file.lexically_relative(home_)));
  }
}

TEST_F(SessionStoreTest, DetectsEveryChangedByteAndNamesTheFile) {
  for (const fs::path& file : AllFiles(Saved())) {
    const std::string good = *ReadWhole(file);
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
      Overwrite(file, bad);
      const Expected<StoredSession> loaded = LoadSession(home_);
      ASSERT_FALSE(loaded) << file << " byte " << i;
      ASSERT_THAT(loaded.error().text, HasSubstr(file.filename().string()));
    }
    Overwrite(file, good);
  }
  EXPECT_TRUE(LoadSession(home_));
}

TEST_F(SessionStoreTest, DetectsEveryTruncation) {
  for (const fs::path& file : AllFiles(Saved())) {
    const std::string good = *ReadWhole(file);
    for (std::size_t size = 0; size < good.size(); ++size) {
      Overwrite(file, good.substr(0, size));
      ASSERT_FALSE(LoadSession(home_)) << file << " cut to " << size;
    }
    Overwrite(file, good);
  }
}

TEST_F(SessionStoreTest, DetectsBytesAddedToAnyFile) {
  for (const fs::path& file : AllFiles(Saved())) {
    const std::string good = *ReadWhole(file);
    Overwrite(file, good + "\n");
    EXPECT_FALSE(LoadSession(home_)) << file;
    Overwrite(file, good);
  }
}

TEST_F(SessionStoreTest, NamesAMissingFile) {
  for (const fs::path& file : AllFiles(Saved())) {
    const std::string good = *ReadWhole(file);
    fs::remove(file);
    const Expected<StoredSession> loaded = LoadSession(home_);
    ASSERT_FALSE(loaded);
    EXPECT_THAT(loaded.error().text, HasSubstr(file.filename().string()));
    Overwrite(file, good);
  }
}

TEST_F(SessionStoreTest, LeavesTheLastGenerationWhenASaveIsCutShort) {
  Saved();
  // What a crash half way through the next save leaves: some files, no manifest.
  fs::create_directories(home_ / "g000002");
  Overwrite(home_ / "g000002" / "objects.json", "half");
  Overwrite(home_ / "manifest.json.new", "{\"body\":");
  const Expected<StoredSession> loaded = LoadSession(home_);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->files, kFiles);
}

TEST_F(SessionStoreTest, SaysWhyItCannotSave) {
  Overwrite(home_, "a file where the folder should be");
  const Expected<int> generation = SessionWriter(home_).Commit(kFacts, kFiles);
  ASSERT_FALSE(generation);
  EXPECT_FALSE(generation.error().text.empty());
}

}  // namespace
}  // namespace limpet
