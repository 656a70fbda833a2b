// SPDX-License-Identifier: MIT
#include "estimation/association/identity_decisions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Cholesky>

#include "estimation/association/pair_evidence.hpp"

namespace limpet {
namespace {

constexpr double kOutOfView = 2.0;    // [s] since the last box
constexpr double kLongInView = 8.0;   // [s]
constexpr double kOptionReach = 1.0;  // [m] beyond four standard deviations
constexpr double kTieGate = 25.0;     // squared distance, three degrees of freedom
// Shares of the likelihood.
constexpr double kDecideShare = 0.98;
constexpr double kDecideShareAtEnd = 0.7;  // when nothing more is to come
constexpr double kReleaseShare = 0.5;
constexpr double kFinalShare = 0.9995;        // not to be looked at again
constexpr double kRivalShare = 0.003;         // most that other known landmarks may share
constexpr double kProbation = 60.0;           // [s]
constexpr double kLongestProbation = 1200.0;  // [s]
constexpr std::size_t kMostTied = 4, kMostOnProbation = 4, kMostInDoubt = 10;
constexpr int kHypotheses = 24;   // followed up
constexpr double kPause = 3.0;    // [s] at least, between decisions
constexpr double kPeriod = 60.0;  // [s] between decisions without news

double ShareOfVerdict(const TrackedObject* object) { return object->verdict.share; }
int IdOf(const TrackedObject* object) { return object->id(); }

/// Covariance of the difference of two places.
Eigen::Matrix3d DifferenceCovariance(const IdentityProblem& problem, int i, int k) {
  Eigen::Matrix3d S =
      problem.covariance.block<3, 3>(3 * i, 3 * i) + problem.covariance.block<3, 3>(3 * k, 3 * k) -
      problem.covariance.block<3, 3>(3 * i, 3 * k) - problem.covariance.block<3, 3>(3 * k, 3 * i);
  S.diagonal().array() += problem.model_sigma * problem.model_sigma;
  return S;
}

}  // namespace

bool IdentityDecisions::IsDecidable(const TrackedObject& object, Occasion occasion) const {
  if (!object.is_open() || object.observations.empty()) {
    return false;
  }
  return occasion == Occasion::kEnd || tracks_.now - object.last_seen() > kOutOfView ||
         tracks_.now - object.observations.front().t > kLongInView;
}

int IdentityDecisions::CountDecidable(Occasion occasion) const {
  return static_cast<int>(std::ranges::count_if(
      tracks_.objects, [&](const TrackedObject& object) { return IsDecidable(object, occasion); }));
}

bool IdentityDecisions::IsDue(int ready) const {
  // Without doubts only what comes anew needs a decision.
  const bool has_doubts =
      tracks_.is_provisional ||
      std::ranges::any_of(tracks_.objects, [](const TrackedObject& o) { return o.Is<InDoubt>(); });
  const bool has_news = ready > decidable_then_ || (has_doubts && tracks_.identity_news > 0);
  const double period = has_news ? kPause : has_doubts ? kPeriod : kProbation;
  return tracks_.now - decided_t_ > period;
}

bool IdentityDecisions::DecideWhatIsDue() {
  const int ready = CountDecidable(Occasion::kOngoing);
  return ready > 0 && IsDue(ready) && Decide(Occasion::kOngoing);
}

bool IdentityDecisions::Decide(Occasion occasion) {
  decided_t_ = tracks_.now;
  const bool has_limited = LimitOpen();
  tracks_.identity_news = 0;
  Joint joint = Collect(occasion);
  if (joint.claimants() == 0) {
    return has_limited;
  }
  joint.hypotheses = LikeliestIdentities(joint.problem, kHypotheses);
  const bool has_decided = Apply(joint, occasion);
  const bool has_absorbed = AbsorbProven(joint);
  NoteProvisional();
  decidable_then_ = CountDecidable(occasion);
  return has_limited || has_absorbed || has_decided;
}

bool IdentityDecisions::LimitOpen() {
  std::vector<TrackedObject*> on_probation, in_doubt;
  for (TrackedObject& object : tracks_.objects) {
    if (object.Is<InDoubt>()) in_doubt.push_back(&object);
    if (object.is_landmark() && object.is_open()) on_probation.push_back(&object);
  }
  EndProbationOfBest(std::move(on_probation));
  const bool has_changed = GiveUpOldest(std::move(in_doubt));
  tracks_.EraseEmpty();
  return has_changed;
}

void IdentityDecisions::EndProbationOfBest(std::vector<TrackedObject*> landmarks) {
  std::ranges::stable_sort(landmarks, std::greater{}, ShareOfVerdict);
  for (std::size_t i = 0; i + kMostOnProbation < landmarks.size(); ++i)
    landmarks[i]->state = Confirmed{};
}

bool IdentityDecisions::GiveUpOldest(std::vector<TrackedObject*> in_doubt) {
  std::ranges::sort(in_doubt, {}, IdOf);
  bool has_changed = false;
  for (std::size_t i = 0; i + kMostInDoubt < in_doubt.size(); ++i) {
    TrackedObject& object = *in_doubt[i];
    object.state = Confirmed{};
    if (object.verdict.is_likely_new) continue;
    terms_.Remove(object);
    has_changed = true;
  }
  return has_changed;
}

IdentityDecisions::Joint IdentityDecisions::Collect(Occasion occasion) {
  Joint joint;
  for (TrackedObject& object : tracks_.objects) {
    if (IsDecidable(object, occasion)) joint.tracks.push_back(&object);
  }
  const auto claimants = static_cast<int>(joint.tracks.size());
  if (claimants == 0) return joint;
  std::ranges::sort(joint.tracks, {}, IdOf);
  AddOptions(joint.tracks);
  if (!FillPlaces(joint, claimants)) return {};
  AddClaimants(joint, claimants);
  return joint;
}

void IdentityDecisions::AddOptions(std::vector<TrackedObject*>& tracks) {
  const auto claimants = static_cast<std::ptrdiff_t>(tracks.size());
  double drift_sd = 0.0;
  for (const TrackedObject* claimant : tracks)
    drift_sd = std::max(drift_sd, claimant->drift_sd);
  const double reach = kOptionReach + 4.0 * drift_sd;
  for (TrackedObject& object : tracks_.objects) {
    if (!object.is_landmark()) continue;
    const auto may_be = [&](const TrackedObject* claimant) {
      return claimant->IsTiedTo(object.id()) ||
             (object.id() < claimant->id() && (claimant->p_W - object.p_W).norm() < reach);
    };
    if (std::any_of(tracks.begin(), tracks.begin() + claimants, may_be)) tracks.push_back(&object);
  }
}

bool IdentityDecisions::FillPlaces(Joint& joint, int claimants) const {
  IdentityProblem& problem = joint.problem;
  std::vector<int> slots;
  problem.places.resize(static_cast<Eigen::Index>(3 * joint.tracks.size()));
  for (std::size_t i = 0; i < joint.tracks.size(); ++i) {
    slots.push_back(joint.tracks[i]->slot());
    problem.places.segment<3>(static_cast<Eigen::Index>(3 * i)) = smoother_.BorderAt(slots.back());
  }
  const Eigen::Index n = problem.places.size();
  problem.covariance = smoother_.Covariance(slots).bottomRightCorner(n, n);
  for (int i = 0; i < claimants; ++i) {
    const std::optional<int> to = joint.track(i).tied_to();
    if (!to) continue;
    const auto target = std::ranges::find(joint.tracks, *to, IdOf);
    const bool is_out =
        target != joint.tracks.end() &&
        TakeOutTie(problem.places, problem.covariance,
                   {.a = i, .b = static_cast<int>(target - joint.tracks.begin())}, kTieSigma);
    if (!is_out) return false;
  }
  for (std::size_t i = 0; i < joint.tracks.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    problem.covariance.block<3, 3>(row, row) += joint.tracks[i]->MotionCovariance();
  }
  return true;
}

void IdentityDecisions::AddClaimants(Joint& joint, int claimants) const {
  IdentityProblem& problem = joint.problem;
  const Clustering clustering = ClusteringOf(tracks_.objects, params_.pair_distance_m);
  problem.pair_density = clustering.pair_density;
  problem.crowding = clustering.crowding;
  problem.pair_distance = params_.pair_distance_m;
  for (const TrackedObject* object : joint.tracks) {
    problem.has_neighbour.push_back(
        object->is_landmark() &&
        CountNeighbours(*object, tracks_.objects, params_.pair_distance_m) > 0);
  }
  for (int i = 0; i < claimants; ++i) {
    std::vector<IdentityProblem::Apart> apart;
    IdentityProblem::Claimant claimant = ClaimantOf(i, joint, apart);
    problem.apart.insert(problem.apart.end(), apart.begin(), apart.end());
    problem.claimants.push_back(std::move(claimant));
  }
}

IdentityProblem::Claimant IdentityDecisions::ClaimantOf(
    int i, const Joint& joint, std::vector<IdentityProblem::Apart>& apart) const {
  const IdentityProblem& problem = joint.problem;
  IdentityProblem::Claimant claimant{
      .thing = i, .new_cost = -2.0 * std::log(params_.objects_per_m3), .options = {}};
  for (int k = 0; k < static_cast<int>(joint.tracks.size()); ++k) {
    const TrackedObject &own = joint.track(i), &other = joint.track(k);
    if (other.id() >= own.id()) continue;
    const double together = TogetherCost(own, other);
    if (together > 0.0) apart.push_back({i, k, together});
    if (together >= kTwoObjectsCost) continue;
    const Eigen::Vector3d d = problem.places.segment<3>(3 * i) - problem.places.segment<3>(3 * k);
    const Eigen::Matrix3d S = DifferenceCovariance(problem, i, k);
    if (d.dot(S.llt().solve(d)) > kTieGate) continue;
    claimant.overlap_cost += OverlapCost(d, S, params_.model.radius_m);
    claimant.options.push_back(
        {.thing = k, .cost = ClassCost(own, other, params_.gate.confused_class_share)});
  }
  return claimant;
}

IdentityDecisions::Shares IdentityDecisions::SharesOf(int claimant, const Joint& joint) {
  Shares shares{.best = claimant, .of_rivals = -ShareOf(joint.hypotheses, claimant, claimant)};
  for (int k = 0; k < static_cast<int>(joint.tracks.size()); ++k) {
    const double share = ShareOf(joint.hypotheses, claimant, k);
    shares.of_rivals += share;
    if (share > shares.of_best) shares.best = k, shares.of_best = share;
    if (joint.track(claimant).IsTiedTo(joint.track(k).id())) shares.of_tie = share;
  }
  shares.of_rivals -= shares.best == claimant ? 0.0 : shares.of_best;
  return shares;
}

bool IdentityDecisions::ApplyTo(int claimant, const Joint& joint, Occasion occasion) {
  TrackedObject& object = joint.track(claimant);
  const Shares shares = SharesOf(claimant, joint);
  const bool is_new = shares.best == claimant;
  bool has_changed = false;
  if (object.Is<Tied>() && shares.of_tie < kReleaseShare) {
    terms_.Release(object);
    has_changed = true;
  }
  object.verdict = {.share = object.Is<Tied>() ? shares.of_tie : shares.of_best,
                    .is_likely_new = is_new};
  const bool is_end = occasion == Occasion::kEnd;
  const double enough = is_end ? kDecideShareAtEnd : kDecideShare;
  const bool is_clear = shares.of_best >= enough && (is_end || shares.of_rivals <= kRivalShare);
  if (object.Is<Tied>() || !is_clear) return has_changed;
  if (is_new) {
    object.state = Confirmed{.is_on_probation = true};
    return has_changed;
  }
  terms_.Tie(object, joint.track(shares.best));
  return true;
}

bool IdentityDecisions::Apply(const Joint& joint, Occasion occasion) {
  bool has_changed = false;
  for (int i = 0; i < joint.claimants(); ++i)
    has_changed = ApplyTo(i, joint, occasion) || has_changed;
  NoteProvisional();
  EndProbation(joint);
  return has_changed;
}

void IdentityDecisions::EndProbation(const Joint& joint) {
  for (int i = 0; i < joint.claimants(); ++i) {
    TrackedObject& object = joint.track(i);
    const bool is_final = !tracks_.is_provisional || object.verdict.share > kFinalShare;
    if (object.is_landmark() && is_final) object.state = Confirmed{};
  }
}

void IdentityDecisions::NoteProvisional() {
  tracks_.is_provisional = std::ranges::any_of(tracks_.objects, [](const TrackedObject& object) {
    return object.Is<Tied>() && object.verdict.share < kFinalShare;
  });
}

bool IdentityDecisions::AbsorbProven(const Joint& joint) {
  std::vector<TrackedObject*> tied;
  for (int i = 0; i < joint.claimants(); ++i) {
    TrackedObject& object = joint.track(i);
    const std::optional<int> to = object.tied_to();
    const TrackedObject* target = to ? tracks_.FindById(*to) : nullptr;
    if (target != nullptr && target->is_landmark()) tied.push_back(&object);
  }
  // The likeliest first; as long as any is provisional, those that came with it are kept.
  std::ranges::stable_sort(tied, std::greater{}, ShareOfVerdict);
  std::size_t left = tied.size();
  for (TrackedObject* object : tied) {
    const double age = tracks_.now - std::get<Tied>(object->state).since;
    const bool is_proven = object->verdict.share > kFinalShare && age > kProbation;
    const bool is_old = age > kLongestProbation;
    if (left <= kMostTied && !is_old && (!is_proven || tracks_.is_provisional)) continue;
    terms_.Absorb(*object);
    --left;
  }
  return left < tied.size();
}

bool IdentityDecisions::Conclude() {
  ++tracks_.identity_news;
  bool has_changed = CountDecidable(Occasion::kEnd) > 0 && Decide(Occasion::kEnd);
  for (TrackedObject& object : tracks_.objects) {
    const std::optional<int> to = object.tied_to();
    const TrackedObject* target = to ? tracks_.FindById(*to) : nullptr;
    if (target == nullptr || !target->is_landmark()) continue;
    terms_.Absorb(object);
    has_changed = true;
  }
  terms_.RemoveAbsorbed(true);
  tracks_.EraseEmpty();
  NoteProvisional();
  return has_changed;
}

}  // namespace limpet
