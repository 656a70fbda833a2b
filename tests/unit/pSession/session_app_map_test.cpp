// SPDX-License-Identifier: MIT
// pSession and the map, which pMap tells in tiles.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/session/saved_session.hpp"
#include "tests/unit/pSession/session_app_fixture.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

TEST_F(SessionAppTest, SavesTheMapItAskedFor) {
  Discover();
  EXPECT_EQ(link_.Last(topics::kMapSnapshotRequest), "home");
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  EXPECT_EQ(LoadSession(folder_.path() / "discovery")->files.at("map/0_0.ot.gz"),
            MapTile::Of({}, "12").packed);
}

/// The number of names that a saved file has: two while a generation is made of the one before.
TEST_F(SessionAppTest, WritesOnlyTheTilesThatAreOtherThanBefore) {
  const auto tile = [this](const std::string& name) {
    return *LoadSession(folder_.path() / "discovery")->files.find(name);
  };
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("first"));
  TellTile(app, {0, 0}, "stays");
  TellTile(app, {0, -1}, "changes");
  TellTile(app, {1, 0}, "goes");
  EXPECT_EQ(link_.Count(topics::kSessionSaved), 1) << "not before all of it has come";
  EndMap(app);
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=first");
  const fs::path kept = folder_.path() / "kept";
  fs::create_hard_link(folder_.path() / "discovery" / "session" / "g000002" / "map" / "0_0.ot.gz",
                       kept);
  link_.Send(app, topics::kSessionSave, std::string("second"));
  TellTile(app, {0, -1}, "changed");
  told_.Put({.key = {1, 0}, .packed = {}});
  link_.Send(app, topics::kMapTile, MapTile{.key = {1, 0}, .packed = {}});
  EndMap(app);
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=3,cause=second");
  EXPECT_EQ(fs::hard_link_count(kept), 2U) << "the same file";
  EXPECT_EQ(tile("map/0_-1.ot.gz").second, MapTile::Of({}, "changed").packed);
  EXPECT_EQ(LoadSession(folder_.path() / "discovery")->files.count("map/1_0.ot.gz"), 0U);
}

TEST_F(SessionAppTest, AsksForTheTilesAgainWhereOnesAreMissing) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  told_.Put(MapTile::Of({5, 5}, "lost on the way"));
  TellMap(app, "12");
  EXPECT_EQ(link_.Count(topics::kMapTilesRequest), 1);
  EXPECT_EQ(link_.Count(topics::kSessionSaved), 1);
  TellTile(app, {5, 5}, "lost on the way");
  TellMap(app, "12");
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
}

/// As where pMap has lost what it knew: what only its former life knew goes.
TEST_F(SessionAppTest, TakesTheMapForWhatPMapTellsWhenItTellsAllOfIt) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  TellTile(app, {7, 7}, "of its former life");
  EndMap(app);
  told_ = {};
  link_.Send(app, topics::kSessionSave, std::string("home"));
  TellMap(app, "12");
  EXPECT_EQ(link_.Count(topics::kMapTilesRequest), 1);
  TellMap(app, "12");
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  const SessionFiles files = LoadSession(folder_.path() / "discovery")->files;
  EXPECT_TRUE(files.contains("map/0_0.ot.gz"));
  EXPECT_FALSE(files.contains("map/7_7.ot.gz"));
}

TEST_F(SessionAppTest, AsksAPMapThatContradictsItselfOnceForEachSave) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  for (int i = 0; i < 5; ++i)
    link_.Send(app, topics::kMapTiles, MapTileList{.tiles = 3, .checksum = "0"});
  EXPECT_EQ(link_.Count(topics::kMapTilesRequest), 1);
  app.Tick(link_.time + Seconds(3.0));
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  EXPECT_TRUE(app.warnings().contains("MAP_SILENT"));
}

TEST_F(SessionAppTest, WaitsForALargeMapWhileItComes) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  for (int i = 0; i < 5; ++i) {
    link_.time += Seconds(1.5);
    TellTile(app, {i, 0}, "1");
    app.Tick(link_.time);
  }
  EXPECT_EQ(link_.Count(topics::kSessionSaved), 1);
  EndMap(app);
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  EXPECT_FALSE(app.warnings().contains("MAP_SILENT"));
}

/// Somebody takes the session away while it goes on: the map comes again, and is saved again.
TEST_F(SessionAppTest, AsksForTheMapAgainIfTheDiskHasLostIt) {
  Discover();
  SessionApp app(Context("other"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  TellMap(app, "12");
  fs::remove_all(folder_.path() / "other");
  link_.Send(app, topics::kSessionSave, std::string("again"));
  EndMap(app);
  EXPECT_TRUE(app.warnings().contains("SESSION_NOT_SAVED"));
  EXPECT_EQ(link_.Count(topics::kMapTilesRequest), 1);
  TellMap(app, "12");
  link_.Send(app, topics::kSessionSave, std::string("again"));
  EndMap(app);
  EXPECT_FALSE(app.warnings().contains("SESSION_NOT_SAVED"));
  EXPECT_TRUE(LoadSession(folder_.path() / "other")->files.contains("map/0_0.ot.gz"));
}

TEST_F(SessionAppTest, ExportsTheMapForOtherPrograms) {
  SemanticOctree octree;
  octree.Set({1.1, 2.1, 3.1}, {.occupied = 0.85F, .object = 1.0F, .label = VoxelLabel::kNew});
  const std::string bytes = octree.Serialize();
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  TellMap(app, bytes);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  EndMap(app);
  link_.Send(app, topics::kSessionSave, std::string("again"));  // the map is on the disk alone
  EndMap(app);
  const SessionFiles files = LoadSession(folder_.path() / "discovery")->files;
  EXPECT_THAT(files.at("export/map_color.ot"), ::testing::HasSubstr("id ColorOcTree"));
  EXPECT_THAT(files.at("export/map.ply"), ::testing::HasSubstr("element vertex 1\n"));
  EXPECT_THAT(files.at("export/map.csv"), ::testing::HasSubstr(",new\n"));
}

TEST_F(SessionAppTest, HandsOverTheFormerSessionsMapOnce) {
  Discover();  // its map is two bytes
  SessionApp app(Context("change", folder_.path() / "discovery"), {});
  app.Tick(link_.time);
  EXPECT_EQ(link_.Last(topics::kSessionPriorMap), MapTile::Of({}, "12"));
  app.Tick(link_.time + Seconds(1.0));
  EXPECT_EQ(link_.Count(topics::kSessionPriorMap), 1);
}

TEST_F(SessionAppTest, HandsOverTheMapOfAnOlderSessionInTiles) {
  SemanticOctree octree;
  octree.Set({1.1, 2.1, 3.1}, {.occupied = 0.85F});
  octree.Set({100.1, 2.1, 3.1}, {.occupied = 0.85F});
  SessionMemory older;
  older.map["map.ot"] = octree.Serialize();
  ASSERT_TRUE(SessionWriter(folder_.path() / "old" / "session").Commit({}, FilesOf(older)));
  SessionApp app(Context("change", folder_.path() / "old"), {});
  app.Tick(link_.time);
  EXPECT_EQ(link_.Count(topics::kSessionPriorMap), 2);
  EXPECT_FALSE(app.warnings().contains("FORMER_MAP"));
  older.map["map.ot"] = "of another kind";
  ASSERT_TRUE(SessionWriter(folder_.path() / "strange" / "session").Commit({}, FilesOf(older)));
  const SessionApp warned(Context("change", folder_.path() / "strange"), {});
  EXPECT_TRUE(warned.warnings().contains("FORMER_MAP"));
}

/// Over water too deep for the DVL the map stays empty.
TEST_F(SessionAppTest, ExportsNothingOfAnEmptyMap) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  EndMap(app);
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  EXPECT_FALSE(LoadSession(folder_.path() / "discovery")->files.contains("export/map.ply"));
}

TEST_F(SessionAppTest, SavesWithoutAMapThatDoesNotCome) {
  SessionApp app(Context("discovery"), {});
  app.Tick(link_.time);
  link_.Send(app, topics::kSessionSave, std::string("home"));
  app.Tick(link_.time + Seconds(3.0));
  EXPECT_EQ(link_.Last(topics::kSessionSaved), "generation=2,cause=home");
  EXPECT_TRUE(app.warnings().contains("MAP_SILENT"));
  EndMap(app);
  EXPECT_FALSE(app.warnings().contains("MAP_SILENT"));
}

}  // namespace
}  // namespace limpet
