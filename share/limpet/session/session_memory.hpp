// SPDX-License-Identifier: MIT
// What a session knows, and the files it is kept in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/session/session_store.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

/// Files: area.txt, objects.json, landmarks.json, sights.csv, map.ot, mission/*.
struct SessionMemory {
  std::optional<SurveyArea> area;
  OpiBeliefs objects;
  LandmarkJoint landmarks;    ///< of the objects' landmarks; empty if never heard
  std::vector<Sight> sights;  ///< every frame with its pose and boxes
  std::string map;            ///< the semantic octree as MAP_SNAPSHOT; empty if none
  std::map<std::string, std::string> mission;  ///< the mission's own files
};

/// Positions are kept to 0.1 mm, angles to 10 microradians, pixels to 0.01.
[[nodiscard]] SessionFiles FilesOf(const SessionMemory& memory);
/// The error names the file whose content is not understood.
[[nodiscard]] Expected<SessionMemory> MemoryOf(const SessionFiles& files);

/// What a later session takes over: objects that were there at the end of this one, and where it
/// looked from.
[[nodiscard]] SessionPrior PriorOf(const SessionFacts& facts, const SessionMemory& memory);

}  // namespace limpet
