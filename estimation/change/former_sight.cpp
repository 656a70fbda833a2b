// SPDX-License-Identifier: MIT
#include "estimation/change/former_sight.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "estimation/change/watched_place.hpp"
#include "estimation/change/water_from_places.hpp"

namespace limpet {

void FormerSight::SetViews(FormerViews views) {
  views_ = std::move(views);
  views_.model.visibilities = VisibilityBelief::Grid();
  Forget();
}

OwnerOf FormerSight::OwnerIn(const std::vector<FormerObject>& listed) const {
  return [this, &listed](const ObservedFrame& view, const Box& box) {
    const bool is_listed = std::ranges::any_of(listed, [&](const FormerObject& former) {
      const std::optional<Foresight> foresight =
          Foresee(WatchedPlace(former.object), view.X_WB, views_.model);
      return foresight && foresight->Explains(box, views_.model.look.camera);
    });
    return is_listed ? BoxOwner::kAnotherPlace : BoxOwner::kUnknown;
  };
}

const PlaceWatch& FormerSight::At(const Landmark& newcomer, const FormerTies& ties) {
  const ObjectEstimate place = ties.PlaceThen(newcomer.object);
  const auto known = watches_.find(newcomer.id);
  if (known != watches_.end() && !HasMoved(known->second, place)) return known->second;
  PlaceWatch watch(place, views_.looks);
  const OwnerOf owner_of = OwnerIn(ties.former());
  for (const ObservedFrame& view : views_.frames) {
    watch.See(view, views_.model, owner_of);
  }
  return watches_.insert_or_assign(newcomer.id, std::move(watch)).first->second;
}

VisibilityBelief FormerSight::Water(const std::vector<Landmark>& objects, const FormerTies& ties,
                                    const StatusPriors& priors) {
  const double stayed = priors.presence * priors.survival;
  const double came = (1.0 - priors.presence) * priors.appearance;
  const double was_there = stayed / (stayed + came);  // of what is here now
  VisibilityBelief water = views_.water;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!ties.StandsForFormer(i)) LearnWater(At(objects[i], ties), was_there, water);
  }
  return water;
}

}  // namespace limpet
