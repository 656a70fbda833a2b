// SPDX-License-Identifier: MIT
// Landmarks in doubt: which of them are landmarks known before. They are in the graph from the
// start, each for itself, so that all that is learnt later counts; what is taken for another is
// tied to it, and the tie is taken back when the rest no longer agrees.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Cholesky>

#include "estimation/association/joint_identity.hpp"
#include "estimation/association/object_tracker.hpp"
#include "estimation/association/pair_evidence.hpp"
#include "estimation/smoothing/factors/same_place_factor.hpp"

namespace limpet {
namespace {

constexpr double kTieSigma = 0.05;     // [m]
constexpr double kOutOfView = 2.0;     // [s] since the last box
constexpr double kLongInView = 8.0;    // [s]
constexpr double kReachOfDoubt = 1.0;  // [m] beyond four standard deviations
constexpr double kImplausible = 25.0;  // squared distance, three degrees of freedom
constexpr double kSure = 0.98;         // share of the likelihood
constexpr double kSureEnough = 0.7;    // when nothing more is to come
constexpr double kLikely = 0.5;
constexpr double kSurest = 0.9995;            // not to be looked at again
constexpr double kRivals = 0.003;             // most that other known landmarks may share
constexpr double kProbation = 60.0;           // [s]
constexpr double kLongestProbation = 1200.0;  // [s]
constexpr std::size_t kMostTied = 4, kMostShownOpen = 4, kMostInDoubt = 10;
constexpr int kWidth = 24;        // hypotheses followed up
constexpr double kPause = 3.0;    // [s] at least, between considerations
constexpr double kPeriod = 60.0;  // [s] between considerations without news

}  // namespace

/// Landmarks in doubt or tied, oldest first, then what they may be; and their identities.
struct ObjectTracker::Identities {
  std::vector<TrackedObject*> things;
  IdentityProblem problem;
  std::vector<IdentityHypothesis> hypotheses;
  [[nodiscard]] int claimants() const { return static_cast<int>(problem.claimants.size()); }
  [[nodiscard]] TrackedObject& thing(int i) const { return *things[static_cast<std::size_t>(i)]; }
};

bool ObjectTracker::IsDecidable(const TrackedObject& object, bool is_last) const {
  if (!object.is_mapped() || !object.is_open || object.looks.empty()) {
    return false;  // without looks: absorbed just now, and about to go
  }
  return is_last || now_ - object.last_seen() > kOutOfView ||
         now_ - object.looks.front().t > kLongInView;
}

TrackedObject* ObjectTracker::ById(int id) {
  const auto found = std::ranges::find(objects_, id, &TrackedObject::id);
  return found == objects_.end() ? nullptr : &*found;
}

int ObjectTracker::NameOf(const TrackedObject& object) const {
  if (object.same_as < 0) return object.is_landmark() ? object.id : -1;
  const auto to = std::ranges::find(objects_, object.same_as, &TrackedObject::id);
  return to == objects_.end() ? -1 : NameOf(*to);
}

bool ObjectTracker::LimitOpen() {
  std::vector<TrackedObject*> shown, in_doubt;
  for (TrackedObject& object : objects_) {
    if (!object.is_mapped() || !object.is_open || object.same_as >= 0) continue;
    (object.is_in_doubt ? in_doubt : shown).push_back(&object);
  }
  std::ranges::stable_sort(shown, std::greater{}, &TrackedObject::certainty);
  for (std::size_t i = 0; i + kMostShownOpen < shown.size(); ++i)
    shown[i]->is_open = false;
  std::ranges::sort(in_doubt, {}, &TrackedObject::id);
  bool has_changed = false;
  for (std::size_t i = 0; i + kMostInDoubt < in_doubt.size(); ++i) {
    TrackedObject& object = *in_doubt[i];
    object.is_open = object.is_in_doubt = false;
    if (object.is_likely_new) continue;
    ReleaseTiedTo(object);
    smoother_.RemoveLandmark(object.slot);
    object.slot = -1;
    object.looks.clear();
    has_changed = true;
  }
  std::erase_if(objects_, [](const TrackedObject& object) { return object.looks.empty(); });
  return has_changed;
}

ObjectTracker::Identities ObjectTracker::CollectIdentities(bool is_last) {
  Identities all;
  std::vector<TrackedObject*>& things = all.things;
  for (TrackedObject& object : objects_) {
    if (IsDecidable(object, is_last)) things.push_back(&object);
  }
  std::ranges::sort(things, {}, &TrackedObject::id);
  const auto claimants = static_cast<int>(things.size());
  if (claimants == 0) return all;
  double spread = 0.0;
  for (const TrackedObject* claimant : things)
    spread = std::max(spread, claimant->spread);
  const double reach = kReachOfDoubt + 4.0 * spread;
  for (TrackedObject& object : objects_) {
    const auto may_be = [&](const TrackedObject* claimant) {
      return claimant->same_as == object.id ||
             (object.id < claimant->id && (claimant->p - object.p).norm() < reach);
    };
    if (object.is_landmark() && std::any_of(things.begin(), things.begin() + claimants, may_be)) {
      things.push_back(&object);
    }
  }
  std::vector<int> slots;
  IdentityProblem& problem = all.problem;
  problem.places.resize(static_cast<Eigen::Index>(3 * things.size()));
  for (std::size_t i = 0; i < things.size(); ++i) {
    slots.push_back(things[i]->slot);
    problem.places.segment<3>(static_cast<Eigen::Index>(3 * i)) =
        smoother_.LandmarkAt(things[i]->slot);
  }
  problem.covariance =
      smoother_.Covariance(slots).bottomRightCorner(problem.places.size(), problem.places.size());
  for (int i = 0; i < claimants; ++i) {
    const int same_as = all.thing(i).same_as;
    if (same_as < 0) continue;
    const auto to = std::ranges::find(things, same_as, &TrackedObject::id);
    const bool is_out =
        to != things.end() && TakeOutTie(problem.places, problem.covariance, i,
                                         static_cast<int>(to - things.begin()), kTieSigma);
    if (!is_out) return {};
  }
  AddClaimants(all, claimants);
  return all;
}

void ObjectTracker::AddClaimants(Identities& all, int claimants) const {
  IdentityProblem& problem = all.problem;
  const auto count = static_cast<int>(all.things.size());
  const double confused = params_.gate.confused_class_share;
  const double new_cost = -2.0 * std::log(params_.objects_per_m3);
  const Company company = CompanyOf();
  problem.company = company.density, problem.crowd = company.crowd;
  problem.beside_m = params_.beside_m;
  for (const TrackedObject* object : all.things)
    problem.has_company.push_back(object->is_landmark() && CountBeside(*object) > 0);
  for (int i = 0; i < claimants; ++i) {
    IdentityProblem::Claimant claimant{.thing = i, .new_cost = new_cost, .options = {}};
    for (int k = 0; k < count; ++k) {
      if (all.thing(k).id >= all.thing(i).id) continue;
      const double together = TogetherCost(all.thing(i), all.thing(k));
      if (together > 0.0) problem.apart.push_back({i, k, together});
      if (together >= kCertainlyTwo) continue;
      const Eigen::Vector3d d = problem.places.segment<3>(3 * i) - problem.places.segment<3>(3 * k);
      Eigen::Matrix3d S = problem.covariance.block<3, 3>(3 * i, 3 * i) +
                          problem.covariance.block<3, 3>(3 * k, 3 * k) -
                          problem.covariance.block<3, 3>(3 * i, 3 * k) -
                          problem.covariance.block<3, 3>(3 * k, 3 * i);
      S.diagonal().array() += problem.model_sigma * problem.model_sigma;
      if (d.dot(S.llt().solve(d)) > kImplausible) continue;
      claimant.overlap_cost += OverlapCost(d, S, params_.model.radius_m);
      claimant.options.push_back(
          {.thing = k, .cost = ClassCost(all.thing(i), all.thing(k), confused)});
    }
    problem.claimants.push_back(std::move(claimant));
  }
}

int ObjectTracker::CountBeside(const TrackedObject& object) const {
  return static_cast<int>(std::ranges::count_if(objects_, [&](const TrackedObject& other) {
    return other.is_landmark() && other.id != object.id &&
           (other.p - object.p).norm() < params_.beside_m;
  }));
}

ObjectTracker::Company ObjectTracker::CompanyOf() const {
  constexpr double kUnpaired = 4.0;  // landmarks without a neighbour that count before any is known
  constexpr double kCrowded = 0.5, kPaired = 2.0;  // the same, of those with more than one
  constexpr double kOwnHeight = 1.0;               // [m] that objects of one place differ in
  double paired = 0.0, crowded = kCrowded, all = kUnpaired;
  for (const TrackedObject& object : objects_) {
    if (!object.is_landmark()) continue;
    const int beside = CountBeside(object);
    all += 1.0;
    paired += beside > 0 ? 1.0 : 0.0;
    crowded += beside > 1 ? 1.0 : 0.0;
  }
  const double around = std::numbers::pi * params_.beside_m * params_.beside_m * kOwnHeight;
  return {.density = paired / all / around, .crowd = crowded / (paired + kPaired)};
}

double ObjectTracker::NewCost() const {
  return -2.0 * std::log(params_.objects_per_m3 + CompanyOf().density);
}

bool ObjectTracker::Reconsider(bool is_last) {
  const auto is_decidable = [&](const TrackedObject& object) {
    return IsDecidable(object, is_last);
  };
  const auto ready = static_cast<int>(std::ranges::count_if(objects_, is_decidable));
  // Without doubts only what comes anew needs a decision.
  const bool is_restless =
      is_provisional_ || std::ranges::any_of(objects_, &TrackedObject::is_in_doubt);
  const bool has_news = ready > considered_count_ || (is_restless && identity_news_ > 0);
  const double period = has_news ? kPause : is_restless ? kPeriod : kProbation;
  const bool is_due = now_ - considered_t_ > period;
  if (ready == 0 || !(is_last || is_due)) {
    return false;
  }
  considered_t_ = now_;
  const bool has_limited = LimitOpen();
  identity_news_ = 0;
  Identities all = CollectIdentities(is_last);
  if (all.claimants() == 0) {
    return has_limited;
  }
  all.hypotheses = LikeliestIdentities(all.problem, kWidth);
  const bool has_decided = Decide(all, is_last);
  const bool has_absorbed = AbsorbSure(all);
  NoteProvisional();
  considered_count_ = static_cast<int>(std::ranges::count_if(objects_, is_decidable));
  return has_limited || has_absorbed || has_decided;
}

bool ObjectTracker::Decide(const Identities& all, bool is_last) {
  const double enough = is_last ? kSureEnough : kSure;
  bool has_changed = false;
  for (int i = 0; i < all.claimants(); ++i) {
    TrackedObject& object = all.thing(i);
    int best = i;
    double best_share = 0.0, share_of_tie = 0.0, rivals = -ShareOf(all.hypotheses, i, i);
    for (int k = 0; k < static_cast<int>(all.things.size()); ++k) {
      const double share = ShareOf(all.hypotheses, i, k);
      rivals += share;
      if (share > best_share) best = k, best_share = share;
      if (all.thing(k).id == object.same_as) share_of_tie = share;
    }
    if (object.same_as >= 0 && share_of_tie < kLikely) {
      Release(object);
      has_changed = true;
    }
    object.certainty = object.same_as >= 0 ? share_of_tie : best_share;
    object.is_likely_new = best == i;
    rivals -= best == i ? 0.0 : best_share;
    if (object.same_as >= 0 || best_share < enough || (!is_last && rivals > kRivals)) continue;
    if (best != i) {
      Tie(object, all.thing(best));
      has_changed = true;
    } else {
      object.is_in_doubt = false;
    }
  }
  NoteProvisional();
  for (int i = 0; i < all.claimants(); ++i) {
    TrackedObject& object = all.thing(i);
    if (object.is_landmark() && (!is_provisional_ || object.certainty > kSurest)) {
      object.is_open = false;
    }
  }
  return has_changed;
}

void ObjectTracker::NoteProvisional() {
  is_provisional_ = std::ranges::any_of(objects_, [](const TrackedObject& object) {
    return object.is_mapped() && object.same_as >= 0 && object.certainty < kSurest;
  });
}

void ObjectTracker::Tie(TrackedObject& object, TrackedObject& to) {
  smoother_.AddLandmarkTerm(
      object.slot, Term::OnBlocks(SamePlaceFactor(Meters(kTieSigma)), object.slot, to.slot));
  object.is_in_doubt = false;
  object.is_open = true;
  object.same_as = to.id;
  object.decided_t = now_;
  object.is_fresh = to.is_fresh = true;
  to.last_path = std::max(to.last_path, object.last_path);
}

void ObjectTracker::Release(TrackedObject& object) {
  smoother_.Untie(object.slot);
  object.same_as = -1;
  object.is_in_doubt = true;
  ++identity_news_;
}

void ObjectTracker::ReleaseTiedTo(const TrackedObject& object) {
  for (TrackedObject& other : objects_) {
    if (other.is_mapped() && other.same_as == object.id) Release(other);
  }
}

bool ObjectTracker::AbsorbSure(const Identities& all) {
  std::vector<TrackedObject*> tied;
  for (int i = 0; i < all.claimants(); ++i) {
    TrackedObject& object = all.thing(i);
    const TrackedObject* to = object.same_as < 0 ? nullptr : ById(object.same_as);
    if (to != nullptr && to->is_landmark()) tied.push_back(&object);
  }
  // The surest first; as long as any is provisional, those that came with it are kept.
  std::ranges::stable_sort(tied, std::greater{}, &TrackedObject::certainty);
  std::size_t left = tied.size();
  for (TrackedObject* object : tied) {
    const bool is_proven = object->certainty > kSurest && now_ - object->decided_t > kProbation;
    const bool is_old = now_ - object->decided_t > kLongestProbation;
    if (left <= kMostTied && !is_old && (!is_proven || is_provisional_)) continue;
    Absorb(*object);
    --left;
  }
  return left < tied.size();
}

void ObjectTracker::Absorb(TrackedObject& object) {
  TrackedObject& into = *ById(object.same_as);
  for (TrackedObject& other : objects_) {
    if (other.same_as != object.id) continue;
    smoother_.Untie(other.slot);
    Tie(other, into);
  }
  for (std::size_t i = 0; i < object.looks.size(); ++i) {
    Look& look = object.looks[i];
    for (const TermId& term : look.terms)
      smoother_.RemoveTerm(term);
    look.terms.clear();
    AddTerms(into, look, i == 0);
    into.AddLook(std::move(look));
  }
  std::ranges::stable_sort(into.looks, {}, &Look::frame);
  into.expected += object.expected;
  into.hits += object.hits;
  into.far = std::max(into.far, object.far);
  object.looks.clear();
  empty_slots_.push_back(object.slot);
  object.slot = -1;
}

bool ObjectTracker::ForgetEmptySlots() {
  // Until the last trace of its looks is gone, an absorbed landmark stays tied.
  const auto gone = std::erase_if(empty_slots_, [this](int slot) {
    const bool is_gone = smoother_.HasCaughtUp(slot);
    if (is_gone) smoother_.RemoveLandmark(slot);
    return is_gone;
  });
  return gone > 0;
}

bool ObjectTracker::Conclude() {
  ++identity_news_;
  bool has_changed = Reconsider(true);
  for (TrackedObject& object : objects_) {
    const TrackedObject* to = object.same_as < 0 ? nullptr : ById(object.same_as);
    if (!object.is_mapped() || to == nullptr || !to->is_landmark()) continue;
    Absorb(object);
    has_changed = true;
  }
  for (const int slot : empty_slots_)
    smoother_.RemoveLandmark(slot);
  empty_slots_.clear();
  std::erase_if(objects_, [](const TrackedObject& object) { return object.looks.empty(); });
  NoteProvisional();
  return has_changed;
}

}  // namespace limpet
