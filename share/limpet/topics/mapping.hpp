// SPDX-License-Identifier: MIT
// What pMap believes about the ground and the objects on it; what a former session left.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/detection_model.hpp"
#include "limpet/objects/former_session.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/objects/object_estimate.hpp"
#include "limpet/topics/map_tile.hpp"
#include "limpet/topics/packed_bytes.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// Geometry of the survey grid: cells of `cell_m`, row-major by north then east, from the
/// south-west corner.
struct GridFrame {
  double north_min = 0.0, east_min = 0.0;
  double cell_m = 0.25;
  int rows = 0;     ///< along north
  int columns = 0;  ///< along east
};

/// What has been seen of a cell of the grid. `seen_height` is the greatest height above the seabed
/// up to which it has been inside the image [m]: 0 is "bottom only", a negative one says never, and
/// that the rest means nothing. Of that, what lies below `seen_floor` was out of reach in this
/// water.
struct SeenCell {
  float seen_height = -1.0F;
  float seabed_down = 0.0F;  ///< NED depth of the seabed here [m], from the DVL beams near by
  float seen_floor = 0.0F;   ///< height above the seabed [m]; 0: the bottom was in sight
  /// True if anything of the cell was inside an image and in sight.
  [[nodiscard]] bool is_in_sight() const {
    return seen_height >= 0.0F && seen_floor <= seen_height;
  }
};

/// Cells that changed since the last message, as they are now: some were not seen after all,
/// because the track turned out to lie elsewhere.
struct GridDelta {
  GridFrame frame;
  struct Cell {
    std::uint32_t index = 0;
    SeenCell now;
  };
  std::vector<Cell> cells;
};
/// Header of 48 little-endian bytes (magic "LGD2", count u32, north_min, east_min, cell_m f64,
/// rows, columns u32, 8 reserved), then 16 bytes per cell. "LGD1" of older logs has no floors and
/// 12 bytes per cell.
template <>
struct TopicCodec<GridDelta> {
  [[nodiscard]] static Value Encode(const GridDelta& delta);
  [[nodiscard]] static std::optional<GridDelta> Decode(const Value& value);
};

/// Shares of the area that the vehicle has seen, 0 to 1: expected ones, since it does not know
/// exactly where its images lie.
struct Coverage {
  double seabed = 0.0;    ///< bottom inside the image
  double band = 0.0;      ///< mean over the heights of the band
  double band_top = 0.0;  ///< at the greatest height
  /// Shares of what counts as done where paths are planned: images as they are believed to lie,
  /// drawn in by what two passes may have come apart. Absent: the writer keeps no such count.
  std::optional<double> done_seabed = std::nullopt, done_band = std::nullopt,
                        done_band_top = std::nullopt;
  template <class V>
  void Describe(V& visit) {
    visit("seabed", seabed), visit("band", band), visit("band_top", band_top);
    visit("done_seabed", done_seabed), visit("done_band", done_band);
    visit("done_band_top", done_band_top);
  }
};

struct OpiBeliefs {
  std::vector<OpiBelief> opis;
};
template <>
struct TopicCodec<OpiBeliefs> : JsonCodec<OpiBeliefs> {};

/// Something in the vehicle's way that stands up from the seabed.
struct Obstacle {
  int id = 0;                                    ///< stays its own as long as it is known
  std::vector<std::array<double, 2>> outline{};  ///< convex: north, east [m]
  double top = 0.0;                              ///< NED depth of the shallowest echo [m]
  bool operator==(const Obstacle&) const = default;
};
struct Obstacles {
  std::vector<Obstacle> obstacles;
};
template <>
struct TopicCodec<Obstacles> : JsonCodec<Obstacles> {};

/// What the map judges by whether a frame looks at a place: camera and detector as it believes
/// them. Who plans looks plans them by this, through a LookModel (`survey/look.hpp`), which has the
/// camera as it is reckoned with; a message has angles, in which people and parameters give it, and
/// how far images are drawn in, which is of no single look.
struct MapLook {
  /// The camera's image: full angles [rad] and size. Who plans takes it to look straight down.
  double fov_across = 0.0, fov_along = 0.0;
  int width_px = 0, height_px = 0;
  DetectionModel detection;    ///< in the water that plans are made for
  double object_radius = 0.0;  ///< [m]
  /// Images count as drawn in by so much on every side: passes may have come apart [m].
  std::optional<double> seam_allowance = std::nullopt;
  template <class V>
  void Describe(V& visit) {
    visit("seam_allowance", seam_allowance);
    visit("fov_across", fov_across), visit("fov_along", fov_along);
    visit("width_px", width_px), visit("height_px", height_px);
    detection.Describe(visit);
    visit("object_radius", object_radius);
  }
};

/// How far the vehicle can see in this water, as its own detector sees (docs/water.md).
struct WaterVisibility {
  Meters visibility;  ///< range at which an object's contrast is gone
  Meters sd;          ///< its standard deviation
  template <class V>
  void Describe(V& visit) {
    visit("visibility_m", visibility), visit("sd_m", sd);
  }
};

/// How strongly the ground stood out in the images from one range of distances.
struct ContrastBin {
  double from = 0.0;          ///< distance; up to the next quarter metre [m]
  int clear = 0;              ///< images in which the ground stood out of the noise
  double log_contrast = 0.0;  ///< mean over those
  int faint = 0;              ///< images in which it did not
  double log_limit = 0.0;     ///< what it would have had to exceed, mean over those
};

/// What a session keeps of its water.
struct WaterRecord {
  double visibility = 0.0;             ///< by which it counted what it had seen [m]
  WaterVisibility estimate;            ///< at the end
  std::vector<ContrastBin> contrasts;  ///< what images alone said
};
template <>
struct TopicCodec<WaterRecord> : JsonCodec<WaterRecord> {};

struct SessionPrior {
  std::string session;  ///< name of the former session
  FormerSession former;
  /// Where its map looked from, thinned to independent looks, but for looks with boxes that are
  /// nobody's; only such boxes are kept. Tells a new object from one that was never looked for.
  std::vector<FormerView> views;
  /// Keys and values of pMap's block in the former mission: its camera, and how well it saw. Empty
  /// if not known.
  std::vector<std::array<std::string, 2>> map_parameters;
  std::optional<WaterVisibility> water{};  ///< how far it saw, by its own account, if it gave one
  std::vector<Obstacle> obstacles{};       ///< that stood in its way, in its frame
};
template <>
struct TopicCodec<SessionPrior> : JsonCodec<SessionPrior> {};

namespace topics {
inline const auto kMapDelta =
    Declare<GridDelta>("MAP_DELTA", "changed cells of the survey grid",
                       {.unit = "m", .frame = "NED", .rate = "2 Hz", .writers = {"pMap"}});
inline const auto kMapGridRequest =
    Declare<std::string>("MAP_GRID_REQUEST", "asks for all cells as one MAP_DELTA; value says why",
                         {.rate = "on restart", .writers = {"pHelm"}, .is_command = true});
inline const auto kMapCoverage = Declare<Coverage>(
    "MAP_COVERAGE", "expected shares of the area seen; and of it done, as plans count it",
    {.unit = "0 to 1", .rate = "2 Hz", .writers = {"pMap"}});
inline const auto kMapOpis = Declare<OpiBeliefs>(
    "MAP_OPIS", "objects and their status",
    {.unit = "m", .frame = "NED", .rate = "on change, at most 2 Hz", .writers = {"pMap"}});
inline const auto kMapObstacles = Declare<Obstacles>(
    "MAP_OBSTACLES", "what stands in the way, as sonar and DVL found it: all of it, each time",
    {.unit = "m", .frame = "NED", .rate = "on change", .writers = {"pMap"}});
inline const auto kObstacleAlert = Declare<std::string>(
    "OBSTACLE_ALERT",
    "one obstacle, new or with another outline: `name=ob_3#poly=pts={x,y:...}#id=ob_3`",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pMap"}});
inline const auto kObstacleResolved =
    Declare<std::string>("OBM_RESOLVED", "an obstacle that is none after all: its id",
                         {.rate = "on event", .writers = {"pMap"}});
inline const auto kMapLook =
    Declare<MapLook>("MAP_LOOK", "by what the map judges whether a frame looks at a place",
                     {.unit = "m, rad", .rate = "once, and in other water", .writers = {"pMap"}});
inline const auto kWaterState = Declare<WaterVisibility>(
    "WATER_STATE", "how far the vehicle can see, estimated from what it saw",
    {.unit = "m", .rate = "0.2 Hz", .writers = {"pMap"}});
inline const auto kWaterRecord =
    Declare<WaterRecord>("WATER_RECORD", "what a session keeps of its water",
                         {.unit = "m", .rate = "on MAP_SNAPSHOT_REQUEST", .writers = {"pMap"}});
inline const auto kMapDepths = Declare<PackedBytes>(
    "MAP_DEPTHS", "depth of the seabed by columns, as text of depths.csv (docs/map-files.md)",
    {.unit = "m", .frame = "NED", .rate = "before each MAP_TILES", .writers = {"pMap"}});
inline const auto kMapTile = Declare<MapTile>(
    "MAP_TILE", "semantic octree of a square of the map, if it is other than when it was last sent",
    {.unit = "m", .frame = "NED", .rate = "on MAP_SNAPSHOT_REQUEST", .writers = {"pMap"}});
inline const auto kMapTiles = Declare<MapTileList>(
    "MAP_TILES", "which MAP_TILEs make the map, the last ones of each",
    {.rate = "after the MAP_TILEs of a MAP_SNAPSHOT_REQUEST", .writers = {"pMap"}});
inline const auto kMapSnapshotRequest = Declare<std::string>(
    "MAP_SNAPSHOT_REQUEST", "asks for what is other in the map; value says why",
    {.rate = "with each save", .writers = {"pSession"}, .is_command = true});
inline const auto kMapTilesRequest = Declare<std::string>(
    "MAP_TILES_REQUEST", "asks for all of the map's tiles again; value says why",
    {.rate = "where MAP_TILES tells of others than have come",
     .writers = {"pSession"},
     .is_command = true});
inline const auto kSessionPrior = Declare<SessionPrior>(
    "SESSION_PRIOR", "objects of the loaded former session, and where it looked from",
    {.unit = "m, rad, s", .frame = "NED", .rate = "once", .writers = {"pSession"}});
inline const auto kSessionPriorMap = Declare<MapTile>(
    "SESSION_PRIOR_MAP", "a tile of the loaded former session's semantic octree, in its frame",
    {.unit = "m", .frame = "NED", .rate = "once for each of its tiles", .writers = {"pSession"}});
inline const auto kSessionSave =
    Declare<std::string>("SESSION_SAVE", "asks pSession to save; value says why",
                         {.rate = "on event", .writers = {"pSurvey"}, .is_command = true});
inline const auto kSessionSaved =
    Declare<std::string>("SESSION_SAVED", "a generation is complete on disk: generation=,cause=",
                         {.rate = "on event", .writers = {"pSession"}});
}  // namespace topics

}  // namespace limpet
