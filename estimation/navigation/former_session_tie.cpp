// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_session_tie.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "estimation/matching/frame_search.hpp"
#include "estimation/matching/match_evidence.hpp"
#include "estimation/matching/own_covariance.hpp"
#include "estimation/navigation/former_candidates.hpp"
#include "estimation/navigation/former_displacement.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

// The 99 % quantile of chi-squared with four degrees of freedom: a frame that lies farther off than
// both sessions hold possible is believed the less, the farther.
constexpr double kFrameGate = 13.3;

// A receiver is worse than its sheet says now and then, under a bad sky, say: then by this factor.
constexpr double kWorseFixes = 3.0;
constexpr double kOddsOfWorseFixes = 2.3;  // ln 10: one session of ten

constexpr double kCertain = 12.0;  // of a match, natural logarithm: nothing else is looked for
constexpr double kLeastMoreEvidence =
    3.0;  // ln 20: by so much a frame must be likelier that lies elsewhere
constexpr std::size_t kSearchEvery = 20;  // matches, if no landmarks came: those known have moved
constexpr Meters kFoundShift{1.0};        // of such a frame, until all objects are matched
constexpr Radians kFoundTurn = Radians::FromTextUnit(3.0);

constexpr double kCame = 0.5;            // chance that an object is none of the former session's
constexpr double kPlaced = 0.6;          // [m] deviation per axis of a place among the others
constexpr double kLeastVariance = 1e-6;  // [m^2] of a place, whatever a file says

bool IsCovariance(const Eigen::MatrixXd& matrix) { return matrix.llt().info() == Eigen::Success; }

std::vector<Eigen::Vector3d> PlacesOf(const std::vector<ObjectEstimate>& objects) {
  std::vector<Eigen::Vector3d> places;
  for (const ObjectEstimate& object : objects) {
    places.push_back(object.p_W);
  }
  return places;
}

Eigen::Vector2d MeanOf(const std::vector<ObjectEstimate>& objects) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const ObjectEstimate& object : objects)
    mean += object.p_W.head<2>() / static_cast<double>(objects.size());
  return mean;
}

/// Each place's axes, in place.
void Turn(double angle, Eigen::MatrixXd& joint) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (Eigen::Index i = 0; i + 2 < joint.rows(); i += 3) {
    joint.middleRows<3>(i) = (R * joint.middleRows<3>(i)).eval();
    joint.middleCols<3>(i) = (joint.middleCols<3>(i) * R.transpose()).eval();
  }
}

/// Landmarks without what the prior on some of them says; false if it was all that is known.
bool TakeOut(const JointPrior& prior, PresentLandmarks& present) {
  const Eigen::Index n = present.covariance.rows();
  const Eigen::LLT<Eigen::MatrixXd> llt(present.covariance);
  if (llt.info() != Eigen::Success) return false;
  Eigen::VectorXd mean(n);
  for (std::size_t i = 0; i < present.objects.size(); ++i) {
    mean.segment<3>(static_cast<Eigen::Index>(3 * i)) = present.objects[i].p_W;
  }
  Eigen::MatrixXd information = llt.solve(Eigen::MatrixXd::Identity(n, n));
  Eigen::VectorXd pull = information * mean;
  std::vector<Eigen::Index> rows;
  for (const int slot : prior.slots()) {
    const auto found = std::ranges::find(present.slots, slot);
    if (found == present.slots.end()) return false;
    for (Eigen::Index k = 0; k < 3; ++k)
      rows.push_back(3 * (found - present.slots.begin()) + k);
  }
  information(rows, rows) -= prior.information();
  pull(rows) -= prior.information() * prior.mean();
  const Eigen::LLT<Eigen::MatrixXd> without(information);
  if (without.info() != Eigen::Success) return false;
  present.covariance = without.solve(Eigen::MatrixXd::Identity(n, n));
  mean = without.solve(pull);
  for (std::size_t i = 0; i < present.objects.size(); ++i) {
    present.objects[i].p_W = mean.segment<3>(static_cast<Eigen::Index>(3 * i));
  }
  return mean.allFinite();
}

/// Landmarks whose place among the others is known; of one that was seen after a dropout, say, it
/// would be chance which object it fits.
std::vector<std::size_t> WellPlaced(const PresentLandmarks& present, const Eigen::MatrixXd& own) {
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i + present.others < present.slots.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    const bool is_placed = own.diagonal().segment<2>(row).maxCoeff() < kPlaced * kPlaced;
    if (is_placed) placed.push_back(i);
  }
  return placed;
}

/// Former objects as they are placed.
std::vector<FormerObject> WithPlaces(std::vector<FormerObject> former,
                                     const std::vector<ObjectEstimate>& places) {
  for (std::size_t i = 0; i < former.size(); ++i)
    former[i].object = places[i];
  return former;
}

void SetOwn(std::vector<ObjectEstimate>& objects, const Eigen::MatrixXd& own) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    objects[i].cov_W = own.block<3, 3>(row, row);
  }
}

}  // namespace

void FormerSessionTie::SetFormer(FormerSession former) {
  given_ = std::move(former);
  identities_.clear();
  prior_.reset();
  is_elsewhere_ = false;
  frame_spread_ = 1.0;
  searched_with_ = matches_since_search_ = 0;
  if (!has_former()) {
    return;
  }
  Eigen::MatrixXd& joint = given_.joint_cov_W;
  const auto n = static_cast<Eigen::Index>(3 * given_.objects.size());
  if (joint.size() == 0 || !IsCovariance(joint)) {
    for (FormerObject& known : given_.objects) {
      Eigen::Matrix3d& S = known.object.cov_W;
      S.diagonal() = S.diagonal().cwiseMax(kLeastVariance);
    }
    joint = JointOfSingles(EstimatesOf(given_.objects));
  }
  LIMPET_REQUIRE(joint.rows() == n && joint.cols() == n,
                 "three rows of covariance per former object");
  Place({.pivot_W = MeanOf(EstimatesOf(given_.objects))});
}

void FormerSessionTie::Place(const FrameOffset& placed) {
  placed_ = placed;
  former_ = Moved(EstimatesOf(given_.objects), placed);
  Eigen::MatrixXd joint = given_.joint_cov_W;
  Turn(placed.turn, joint);
  offset_ = {.pivot_W = MeanOf(former_)};
  const SplitCovariance split = SplitFrom(PlacesOf(former_), joint, offset_.pivot_W);
  former_frame_ = split.frame;
  former_own_ = split.own;
  SetOwn(former_, former_own_);
}

double FormerSessionTie::EvidenceOf(const SessionMatch& match,
                                    const std::vector<ObjectEstimate>& candidates,
                                    const Eigen::Matrix4d& now_frame) const {
  const FrameSearchParams search;
  const FramePrior prior = is_elsewhere_ ? FramePrior::Unknown(search.radius_m, search.turn)
                                         : FramePrior::Known(OffsetInformation(now_frame));
  return MatchEvidence(former_, candidates, match, params_, prior);
}

SessionMatch FormerSessionTie::MatchAsPlaced(const std::vector<ObjectEstimate>& candidates,
                                             const Eigen::Matrix4d& now_frame) {
  const auto match = [&](double spread) {
    frame_spread_ = spread;
    return MatchSessions(former_, candidates, params_, OffsetInformation(now_frame));
  };
  SessionMatch near = match(1.0);
  if (is_elsewhere_) return near;
  const double evidence = EvidenceOf(near, candidates, now_frame);
  if (evidence > kCertain) return near;
  SessionMatch far = match(kWorseFixes);
  if (EvidenceOf(far, candidates, now_frame) > evidence + kOddsOfWorseFixes) return far;
  frame_spread_ = 1.0;
  return near;
}

SessionMatch FormerSessionTie::MatchOrSearch(const std::vector<ObjectEstimate>& candidates,
                                             const Eigen::Matrix4d& now_frame) {
  const auto match = [&] { return MatchAsPlaced(candidates, now_frame); };
  const auto evidence_of = [&](const SessionMatch& found) {
    return EvidenceOf(found, candidates, now_frame);
  };
  SessionMatch here = match();
  double evidence = evidence_of(here);
  if (evidence > kCertain) return here;
  if (is_elsewhere_) {
    // What was found elsewhere stands until the frame where it should be explains as much.
    const FrameOffset found = placed_;
    const SessionMatch there = std::move(here);
    const double found_evidence = evidence;
    is_elsewhere_ = false;
    Place({.pivot_W = placed_.pivot_W});
    here = match();
    evidence = evidence_of(here);
    if (found_evidence >= evidence + kLeastMoreEvidence) {
      is_elsewhere_ = true;
      Place(found);
      here = there;
      evidence = found_evidence;
    }
  }
  if (!IsTimeToSearch(candidates.size())) return here;
  const std::optional<FoundFrame> found = SearchFrame(former_, candidates, params_);
  if (!found || found->evidence < evidence + kLeastMoreEvidence) return here;
  is_elsewhere_ = true;
  Place(found->offset);
  return match();
}

bool FormerSessionTie::IsOfThisPlace(const SessionMatch& match,
                                     const std::vector<ObjectEstimate>& candidates,
                                     const Eigen::Matrix4d& now_frame) const {
  const auto known =
      std::ranges::count_if(match.now_of_former, [](const auto& now) { return now.has_value(); });
  const double came = static_cast<double>(candidates.size()) - static_cast<double>(known);
  return EvidenceOf(match, candidates, now_frame) > -came * std::log(kCame);
}

bool FormerSessionTie::IsTimeToSearch(std::size_t candidates) {
  ++matches_since_search_;
  const bool has_more = 10 * candidates > 11 * searched_with_;
  if (!has_more && matches_since_search_ < kSearchEvery) return false;
  searched_with_ = candidates;
  matches_since_search_ = 0;
  return true;
}

bool FormerSessionTie::Match(const PresentLandmarks& landmarks,
                             const std::optional<JointPrior>& applied) {
  PresentLandmarks present = landmarks;
  if (!has_former() || present.slots.empty() || (applied && !TakeOut(*applied, present))) {
    return false;
  }
  const SplitCovariance split =
      SplitFrom(PlacesOf(present.objects), present.covariance, offset_.pivot_W);
  SetOwn(present.objects, split.own);
  const std::vector<std::size_t> placed = WellPlaced(present, split.own);
  std::vector<ObjectEstimate> candidates;
  for (const std::size_t i : placed)
    candidates.push_back(present.objects[i]);
  SessionMatch match = MatchOrSearch(candidates, split.frame);
  // One object alone ties nothing, and is its former self or not.
  if (candidates.size() > 1 && !IsOfThisPlace(match, candidates, split.frame))
    std::ranges::fill(match.now_of_former, std::nullopt);
  const std::vector<double> same_place =
      ChancesOfSamePlace(former_, candidates, params_, OffsetInformation(split.frame), match);
  offset_ = match.offset;
  const std::vector<Pair> pairs = Decide(present, match, placed, same_place);
  prior_.reset();
  if (pairs.size() >= 2) {
    prior_ = PriorFrom(pairs, present, split.frame, split.own);
  }
  return true;
}

std::vector<FormerSessionTie::Pair> FormerSessionTie::Decide(
    const PresentLandmarks& present, const SessionMatch& match,
    const std::vector<std::size_t>& placed, const std::vector<double>& same_place) {
  const std::vector<FormerObject> former = WithPlaces(given_.objects, former_);
  identities_.assign(present.slots.size(), {});
  for (std::size_t j = 0; j < placed.size(); ++j)
    identities_[placed[j]].candidates = RivalCandidates(former, match, static_cast<int>(j));
  std::vector<Pair> pairs;
  std::vector<bool> is_taken(former.size(), false);
  for (std::size_t i = 0; i < former.size(); ++i) {
    if (!match.now_of_former[i]) continue;
    const std::size_t now = placed[static_cast<std::size_t>(*match.now_of_former[i])];
    is_taken[i] = true;
    if (same_place[i] <= 1.0 - kDecidedMatch) continue;  // moved, or gone and another one came
    FormerIdentity& identity = identities_[now];
    identity.id = former[i].id;
    identity.probability = same_place[i];
    if (!identity.candidates.empty()) continue;
    if (same_place[i] < kDecidedMatch) {
      identity.candidates = {{former[i].id, same_place[i]}};
    } else {
      pairs.push_back({i, now});
    }
  }
  for (std::size_t now = 0; now + present.others < present.slots.size(); ++now) {
    if (identities_[now].is_possible()) continue;
    identities_[now].candidates =
        NearbyCandidates(former, is_taken, present.objects[now], match, params_);
  }
  return pairs;
}

Eigen::Matrix4d FormerSessionTie::DatumCovariance() const {
  const FrameSearchParams anywhere;
  const double datum = is_elsewhere_ ? anywhere.radius_m : params_.datum_sigma.value();
  const double turn = (is_elsewhere_ ? anywhere.turn : params_.datum_turn_sigma).value();
  return Eigen::Vector4d(datum * datum, datum * datum, 0.0, turn * turn).asDiagonal();
}

Eigen::Matrix4d FormerSessionTie::OffsetInformation(const Eigen::Matrix4d& now_frame) const {
  if (is_elsewhere_) {
    return OffsetPrior(
        {.offset_sigma = kFoundShift, .down_sigma = params_.down_sigma, .turn_sigma = kFoundTurn});
  }
  // Never surer than the parameters are: a fix may be worse than it says.
  const Eigen::Vector4d least = OffsetPrior(params_).diagonal().cwiseInverse();
  Eigen::Matrix4d covariance = former_frame_ + now_frame + DatumCovariance();
  covariance.diagonal() = covariance.diagonal().cwiseMax(least);
  const Eigen::Vector4d spread(frame_spread_, frame_spread_, 1.0, 1.0);
  return (spread.asDiagonal() * covariance * spread.asDiagonal()).inverse();
}

JointPrior FormerSessionTie::PriorFrom(const std::vector<Pair>& pairs,
                                       const PresentLandmarks& present,
                                       const Eigen::Matrix4d& now_frame,
                                       const Eigen::MatrixXd& now_own) {
  const auto n = static_cast<Eigen::Index>(3 * pairs.size());
  Eigen::MatrixXd former_own(n, n), own(n, n), J(n, 4);
  Eigen::VectorXd moved(n), off(n);
  std::vector<int> slots;
  std::vector<Eigen::Index> former_rows, now_rows;
  for (const Pair& pair : pairs) {
    const auto row = static_cast<Eigen::Index>(3 * slots.size());
    const Eigen::Vector3d& place = former_[pair.former].p_W;
    slots.push_back(present.slots[pair.now]);
    J.middleRows<3>(row) = offset_.Jacobian(place);
    moved.segment<3>(row) = offset_.Apply(place);
    off.segment<3>(row) = present.objects[pair.now].p_W - moved.segment<3>(row);
    for (std::size_t k = 0; k < 3; ++k) {
      former_rows.push_back(static_cast<Eigen::Index>(3 * pair.former + k));
      now_rows.push_back(static_cast<Eigen::Index>(3 * pair.now + k));
    }
  }
  const double stays = std::pow(params_.position_floor.value(), 2);
  former_own = former_own_(former_rows, former_rows) + stays * Eigen::MatrixXd::Identity(n, n);
  own = former_own + now_own(now_rows, now_rows);
  // Where the frame lies by the matches alone, against what both sessions know of their frames.
  const Eigen::LLT<Eigen::MatrixXd> llt(own);
  const Eigen::Matrix4d information = J.transpose() * llt.solve(J);
  const Eigen::Matrix4d seen_covariance =
      (information + 1e-6 * Eigen::Matrix4d::Identity()).inverse();
  const Eigen::Vector4d seen =
      offset_.vector() + seen_covariance * (J.transpose() * llt.solve(off));
  const Eigen::Matrix4d frame = former_frame_ + DatumCovariance();
  const Eigen::Matrix4d expected = frame + now_frame + seen_covariance;
  const double distance = seen.dot(expected.inverse() * seen);
  const double doubt = std::pow(std::max(distance / kFrameGate, 1.0), 2);
  const Eigen::MatrixXd covariance = former_own + doubt * (J * frame * J.transpose());
  // The former frame's own error is nought at best knowledge: the mean is where the former session
  // put the objects, as far as the turn is linear.
  const Eigen::VectorXd mean = moved - J * offset_.vector();
  return {std::move(slots), mean, covariance};
}

}  // namespace limpet
