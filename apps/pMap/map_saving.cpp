// SPDX-License-Identifier: MIT
// What a MapApp tells whoever saves the map.
#include "apps/pMap/map_app.hpp"

namespace limpet {

void MapApp::OnSnapshotRequest(const Stamped<std::string>&) {
  statuses_.Rejudge();
  PaintObstacles();
  PublishObjects();
  Publish(topics::kWaterRecord, WaterRecord{.visibility = planned_visibility_.value(),
                                            .estimate = statuses_.Water().estimate(),
                                            .contrasts = statuses_.contrasts().bins()});
  map_.SetFormerOffset(statuses_.offset());
  map_teller_.Begin();  // lays what still waits: depths, too
  Publish(topics::kMapDepths, PackedBytes{map_.beams().depths().Serialize()});
  TellMap(MapTeller::kAtOnce);
}

void MapApp::OnTilesRequest(const Stamped<std::string>&) {
  map_teller_.BeginAnew();
  TellMap(MapTeller::kAtOnce);
}

void MapApp::Finish(Seconds /*now*/) {
  while (map_teller_.is_at_it())
    TellMap(MapTeller::kAtOnce);
}

void MapApp::TellMap(int most) {
  while (const std::optional<MapTile> tile = map_teller_.Next(most)) {
    Publish(topics::kMapTile, *tile);
  }
  if (!map_teller_.is_at_it()) Publish(topics::kMapTiles, map_teller_.told());
}

}  // namespace limpet
