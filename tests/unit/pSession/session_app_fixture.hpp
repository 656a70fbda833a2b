// SPDX-License-Identifier: MIT
// pSession with a folder of its own, told what others would tell it.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "apps/pSession/session_app.hpp"
#include "limpet/session/map_tile_table.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {

class SessionAppTest : public ::testing::Test {
 protected:
  AppContext Context(const std::string& session, const std::filesystem::path& prior = {}) {
    AppContext context;
    context.name = "pSession";
    context.link = &link_;
    context.mission_folder = folder_.path() / "table1";
    context.run_folder = folder_.path() / session;
    context.prior_folder = prior;
    context.session = session;
    return context;
  }
  static OpiBeliefs OneObject() {
    OpiBelief opi;
    opi.id = 1;
    opi.landmark = 3;
    opi.object.p_W = {4, 1, 5.5};
    opi.object.color = "yellow";
    opi.posterior = {.appeared = 0.98, .nothing = 0.02};
    opi.decided = Status::kNew;
    opi.log_likelihood_ratio = 8.5;
    return {.opis = {opi}};
  }
  /// A discovery session from start to end.
  void Discover() {
    SessionApp app(Context("discovery"), {});
    app.Tick(link_.time);
    link_.Send(app, topics::kMapOpis, OneObject());
    link_.Send(app, topics::kSessionSave, std::string("home"));
    TellMap(app, "12");
  }
  /// A tile as pMap tells it; the octree may be any text.
  void TellTile(SessionApp& app, const TileKey& key, const std::string& octree) {
    const MapTile tile = MapTile::Of(key, octree);
    told_.Put(tile);
    link_.Send(app, topics::kMapTile, tile);
  }
  void EndMap(SessionApp& app) { link_.Send(app, topics::kMapTiles, told_.List()); }
  /// A map of one tile.
  void TellMap(SessionApp& app, const std::string& octree) {
    TellTile(app, {0, 0}, octree);
    EndMap(app);
  }
  TemporaryFolder folder_;
  TestLink link_;
  MapTileTable told_;
};

}  // namespace limpet
