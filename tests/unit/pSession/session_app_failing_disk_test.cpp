// SPDX-License-Identifier: MIT
// pSession on a disk that fails, and on one that is slower than it.
#include <algorithm>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "apps/pSession/session_app.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "limpet/session/map_tile_table.hpp"
#include "limpet/session/saved_session.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

class SessionAppOnADisk : public ::testing::Test {
 protected:
  SessionAppOnADisk() {
    context_.name = "pSession";
    context_.link = &link_;
    context_.run_folder = folder_.path() / "discovery";
    context_.session = "discovery";
  }
  /// A map of two tiles, of which one is never another one.
  void TellMap(SessionApp& app, const std::string& octree) {
    for (const MapTile& tile : {MapTile::Of({0, 0}, octree), MapTile::Of({0, 1}, "same")}) {
      if (told_.Has(tile.key) && tile.key.east == 1) continue;
      told_.Put(tile);
      link_.Send(app, topics::kMapTile, tile);
    }
    link_.Send(app, topics::kMapTiles, told_.List());
  }
  TemporaryFolder folder_;
  TestLink link_;
  MapTileTable told_;
  AppContext context_;
};

TEST_F(SessionAppOnADisk, KeepsTheLastGenerationAndSaysSoWhileTheDiskFails) {
  FailingFileSystem disk(RealFileSystem());
  context_.disk = &disk;
  SessionApp app(context_, {});
  app.Tick(link_.time);
  for (const auto fault : {FailingFileSystem::Fault::kFull, FailingFileSystem::Fault::kFailing,
                           FailingFileSystem::Fault::kReadOnly}) {
    disk.Set(fault);
    link_.Send(app, topics::kSessionSave, std::string("home"));
    TellMap(app, "1");
    EXPECT_TRUE(app.warnings().contains("SESSION_NOT_SAVED"));
    EXPECT_EQ(LoadSession(folder_.path() / "discovery")->facts.cause, "start");
  }
  disk.Set(FailingFileSystem::Fault::kNone);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  TellMap(app, "1");
  EXPECT_FALSE(app.warnings().contains("SESSION_NOT_SAVED"));
  EXPECT_EQ(LoadSession(folder_.path() / "discovery")->facts.cause, "home");
}

TEST_F(SessionAppOnADisk, HasOnTheDiskWhatItSaysIsSavedWheneverThePowerIsCut) {
  const TemporaryFolder place(PlaceInMemory());
  std::filesystem::create_directory(place.path() / "disk");
  TornDisk disk(place.path() / "disk");
  context_.disk = &disk;
  context_.run_folder = place.path() / "disk" / "discovery";
  SessionApp app(context_, {});
  std::vector<std::size_t> calls;  // when each generation was said to be saved
  app.Tick(link_.time);
  calls.push_back(disk.calls());
  for (int i = 0; i < 4; ++i) {
    link_.Send(app, topics::kSessionSave, std::string("home"));
    TellMap(app, std::to_string(i));
    calls.push_back(disk.calls());
  }
  ASSERT_EQ(link_.Count(topics::kSessionSaved), 5);
  Random random(1, "cuts");
  for (int cut = 0; cut < 60; ++cut) {
    const std::size_t at = calls.front() + random.Index(disk.calls() - calls.front() + 1);
    disk.Cut(at, random, place.path() / "left");
    const Expected<StoredSession> stored = LoadSession(place.path() / "left" / "discovery");
    ASSERT_TRUE(stored) << stored.error().text;
    EXPECT_GE(stored->generation,
              std::ranges::count_if(calls, [at](std::size_t saved) { return saved <= at; }));
  }
}

TEST_F(SessionAppOnADisk, HasSavedAllThatWasAskedForAtItsEndInACommunity) {
  context_.runs_live = true;
  SessionApp app(context_, {});
  app.Tick(link_.time);
  link_.Send(app, topics::kMapOpis, OpiBeliefs{.opis = {OpiBelief{}}});
  for (int i = 0; i < 5; ++i) {  // faster than a disk
    link_.Send(app, topics::kSessionSave, std::string("home"));
    TellMap(app, "1");
  }
  link_.time += Seconds(1.0);
  app.Finish(link_.time);
  const Expected<StoredSession> stored = LoadSession(folder_.path() / "discovery");
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->facts.cause, "end");
  EXPECT_EQ(MemoryOf(stored->files)->objects.opis.size(), 1U);
}

}  // namespace
}  // namespace limpet
