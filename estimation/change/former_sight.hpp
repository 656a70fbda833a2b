// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "estimation/change/former_ties.hpp"
#include "estimation/change/place_watch.hpp"
#include "estimation/change/status_params.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/objects/object_estimate.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// Where the former session looked from, in its frame and in order of time, with what it saw there
/// and how well it saw.
struct FormerViews {
  std::vector<ObservedFrame> frames;  ///< boxes of the listed objects may be left out
  WatchModel model;                   ///< its visibility is not asked: `water` is
  LookParams looks;
  VisibilityBelief water{DetectionModel().visibility, StatusParams().visibility_spread};
};

/// What the former session saw, or would have seen, of places where it lists nothing. A session
/// whose views are not known has looked nowhere: it proves nothing about such a place.
class FormerSight {
 public:
  void SetViews(FormerViews views);
  /// Every place is judged again when it is next asked for.
  void Forget() { watches_.clear(); }
  /// What it saw where `newcomer`, an object of this session, now lies.
  [[nodiscard]] const PlaceWatch& At(const Landmark& newcomer, const FormerTies& ties);
  /// Its water: what it found out itself, and what of the newcomers among `objects` it may have
  /// missed.
  [[nodiscard]] VisibilityBelief Water(const std::vector<Landmark>& objects, const FormerTies& ties,
                                       const StatusPriors& priors);

 private:
  [[nodiscard]] OwnerOf OwnerIn(const std::vector<FormerObject>& listed) const;

  FormerViews views_;
  std::map<int, PlaceWatch> watches_;  ///< by landmark
};

}  // namespace limpet
