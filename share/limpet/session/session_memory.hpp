// SPDX-License-Identifier: MIT
// What a session knows, and the files it is kept in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/session/object_chips.hpp"
#include "limpet/session/session_store.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// From the frame with this index in SessionMemory::frames on, the mission was in `phase`.
struct PhaseStart {
  std::size_t frame = 0;
  std::string phase;
};

/// Which session was this one's former one: the one that its landmarks were matched with.
struct FormerFacts {
  std::string mission, session, seed;
  double saved_at = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("mission", mission), visit("session", session), visit("seed", seed);
    visit("saved_at", saved_at);
  }
};
[[nodiscard]] FormerFacts FormerFactsOf(const SessionFacts& facts);

/// The semantic map: file name to bytes as they lie on the disk, each a serialised octree or gzip
/// of one: "map/0_-1.ot.gz". A session from before the map had tiles has "map.ot" alone.
using SessionMap = std::map<std::string, std::string>;

/// Files: area.txt, former.txt, objects.json, obstacles.json, known_landmarks.json, landmarks.json,
/// frames.csv, phases.csv, water.json, map/*, depths.csv, chips.csv, chips/*, mission/*.
struct SessionMemory {
  std::optional<SurveyArea> area;
  std::optional<FormerFacts> former;  ///< nothing in a discovery session, or an older one
  OpiBeliefs objects;
  /// All landmarks as pNav had them when `objects` were judged; nothing in an older session.
  std::optional<Landmarks> known_landmarks;
  LandmarkCovariance landmarks;       ///< of the objects' landmarks; empty if never heard
  std::vector<ObservedFrame> frames;  ///< every frame with its pose and boxes
  std::optional<WaterRecord> water;   ///< nothing in an older session
  std::vector<PhaseStart> phases;     ///< in order; before the first one none was announced
  SessionMap map;                     ///< empty if none was heard
  std::vector<SavedChip> chips;       ///< pictures of the objects; none without images
  Obstacles obstacles;                ///< that stood in the way; none in an older session
  std::string depths;                 ///< as MAP_DEPTHS; empty in an older session
  std::map<std::string, std::string> mission;  ///< the mission's own files
};

/// Positions are kept to 0.1 mm, angles to 10 microradians, pixels to 0.01.
[[nodiscard]] SessionFiles FilesOf(const SessionMemory& memory);
/// The error names the file whose content is not understood.
[[nodiscard]] Expected<SessionMemory> MemoryOf(const SessionFiles& files);

/// Name of the file in SessionMemory::mission that holds the mission as it was run: plugs expanded,
/// settings of the command line in place.
inline constexpr const char* kMissionAsRun = "as_run.moos";

/// Phase of each frame, "" if none was announced.
[[nodiscard]] std::vector<std::string> PhaseOfFrames(const SessionMemory& memory);

/// What a later session takes over: objects that were there at the end of this one, and where it
/// looked from. Without `map_parameters`, which the mission tells.
[[nodiscard]] SessionPrior PriorOf(const SessionFacts& facts, const SessionMemory& memory);

}  // namespace limpet
