// SPDX-License-Identifier: MIT
#include "estimation/association/landmark_terms.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "estimation/association/object_motion.hpp"
#include "estimation/smoothing/factors/birthplace_factor.hpp"
#include "estimation/smoothing/factors/same_place_factor.hpp"

namespace limpet {
namespace {

// Root of how many looks see about the same of an object's motion: together they are worth one.
constexpr double kLooksPerSwing = 3.0;

}  // namespace

void LandmarkTerms::Map(TrackedObject& object, const TrackState& as) {
  mount_.Begin(params_.model.size_spread > 0.0);
  const int slot = smoother_.AddLandmark(object.p_W);
  object.Map(next_id_++, slot, as, sizes_.Take(params_.model.LogSizeOf(object.color())));
  const int node = object.observations.front().node;
  const BirthplaceFactor hold(object.p_W - smoother_.PoseAt(node).head<3>(),
                              Meters(params_.place_prior_m));
  smoother_.AddTerm(node, Term::OnObservation(hold, object.slot()));
  for (std::size_t i = 0; i < object.observations.size(); ++i)
    AddTerms(object, object.observations[i], i == 0);
}

void LandmarkTerms::AddTerms(const TrackedObject& object, Observation& observation,
                             bool with_seabed) {
  const LookSlots slots{.landmark = object.slot(), .mount = mount_.slots(), .size = object.size()};
  const BoxReading reading = observation.reading;
  if (object.motion_sd > 0.0) {
    observation.reading = OfMeanPlace(reading, kLooksPerSwing * object.motion_sd, mount_.camera(),
                                      params_.model.radius_m);
  }
  std::vector<Term> terms =
      TermsOf(observation, slots, mount_.camera(), params_.model, with_seabed);
  observation.reading = reading;
  for (Term& term : terms)
    observation.terms.push_back(smoother_.AddTerm(observation.node, std::move(term)));
}

void LandmarkTerms::NoteMotion(TrackedObject& object, double motion_sd) {
  object.motion_sd = motion_sd;
  for (std::size_t i = 0; i < object.observations.size(); ++i) {
    RemoveTerms(object.observations[i]);
    AddTerms(object, object.observations[i], i == 0);
  }
}

void LandmarkTerms::RemoveTerms(Observation& observation) {
  for (const TermId& term : observation.terms)
    smoother_.RemoveTerm(term);
  observation.terms.clear();
}

void LandmarkTerms::MergeTentative(TrackedObject& tentative, TrackedObject& into) {
  bool is_first = true;
  for (Observation& observation : tentative.observations.TakeAll()) {
    AddTerms(into, observation, std::exchange(is_first, false));
    into.observations.Add(std::move(observation));
  }
  into.review.is_due = true;
  ++tracks_.identity_news;
  into.sightings.Absorb(tentative.sightings);
  into.sightings.last_path = tentative.sightings.last_path;
}

void LandmarkTerms::Remove(TrackedObject& object) {
  ReleaseTiedTo(object);
  smoother_.RemoveLandmark(object.slot());
  object.observations.TakeAll();
  object.state = Gone{};
}

void LandmarkTerms::Tie(TrackedObject& object, TrackedObject& to) {
  smoother_.AddBorderTerm(object.slot(), Term::OnBorder(SamePlaceFactor(Meters(kTieSigma)),
                                                        std::array{object.slot(), to.slot()}));
  object.state = Tied{.to = to.id(), .since = tracks_.now};
  object.review.is_due = to.review.is_due = true;
  to.sightings.last_path = std::max(to.sightings.last_path, object.sightings.last_path);
}

void LandmarkTerms::Release(TrackedObject& object) {
  smoother_.RemovePairTerms(object.slot());
  object.state = InDoubt{};
  ++tracks_.identity_news;
}

void LandmarkTerms::ReleaseTiedTo(const TrackedObject& object) {
  for (TrackedObject& other : tracks_.objects) {
    if (other.IsTiedTo(object.id())) Release(other);
  }
}

void LandmarkTerms::Absorb(TrackedObject& object) {
  TrackedObject& into = *tracks_.FindById(*object.tied_to());
  for (TrackedObject& other : tracks_.objects) {
    if (!other.IsTiedTo(object.id())) continue;
    smoother_.RemovePairTerms(other.slot());
    Tie(other, into);
  }
  bool is_first = true;
  for (Observation& observation : object.observations.TakeAll()) {
    RemoveTerms(observation);
    AddTerms(into, observation, std::exchange(is_first, false));
    into.observations.Add(std::move(observation));
  }
  into.observations.Sort();
  into.sightings.Absorb(object.sightings);
  absorbed_slots_.push_back(object.slot());
  object.state = Gone{};
}

bool LandmarkTerms::RemoveAbsorbed(bool all) {
  const auto removed = std::erase_if(absorbed_slots_, [&](int slot) {
    const bool is_due = all || smoother_.HasCaughtUp(slot);
    if (is_due) smoother_.RemoveLandmark(slot);
    return is_due;
  });
  return removed > 0;
}

}  // namespace limpet
