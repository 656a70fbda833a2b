// SPDX-License-Identifier: MIT
#include "limpet/comparison/session_matches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "estimation/matching/own_covariance.hpp"
#include "estimation/navigation/former_session_tie.hpp"
#include "limpet/core/params.hpp"
#include "limpet/session/landmark_rows.hpp"

namespace limpet {
namespace {

/// Objects of a session that kept no landmarks, as landmarks.
std::vector<Landmark> LandmarksOf(const OpiBeliefs& objects) {
  std::vector<Landmark> landmarks;
  for (const OpiBelief& opi : objects.opis) {
    if (!opi.landmark) continue;
    landmarks.push_back({.id = *opi.landmark, .object = opi.object, .detections = opi.looks});
  }
  return landmarks;
}

/// What pNav's block says of matching; its other lines are not judged here.
MatchingParams ParamsOf(const SavedSession& session) {
  MatchingParams params;
  std::optional<ConfigBlock> block = BlockOf(session, "pNav");
  if (!block) return params;
  const std::vector<ParamSpec> specs = DescribeParams(params);
  std::erase_if(block->entries, [&specs](const ConfigEntry& entry) {
    return std::ranges::none_of(specs, [&entry](const ParamSpec& spec) {
      return EqualsIgnoringCase(spec.name, entry.key);
    });
  });
  const std::vector<ConfigProblem> problems = ApplyBlock(*block, specs);
  if (!problems.empty()) throw ConfigError(problems);
  return params;
}

}  // namespace

bool WasFlownWith(const SavedSession& b, const SavedSession& a) {
  constexpr double kSameTime = 1e-3;  // [s]
  const std::optional<FormerFacts>& former = b.memory.former;
  const FormerFacts facts = FormerFactsOf(a.facts);
  return former && b.memory.known_landmarks && former->mission == facts.mission &&
         former->session == facts.session && former->seed == facts.seed &&
         std::abs(former->saved_at - facts.saved_at) < kSameTime;
}

std::vector<Landmark> MatchedLandmarks(const SavedSession& a, const SavedSession& b,
                                       const SessionPrior& prior) {
  std::vector<Landmark> landmarks = b.memory.known_landmarks ? b.memory.known_landmarks->landmarks
                                                             : LandmarksOf(b.memory.objects);
  if (WasFlownWith(b, a)) {
    return landmarks;
  }
  PresentLandmarks present{.slots = {}, .objects = {}, .covariance = {}};
  for (const Landmark& landmark : landmarks) {
    present.slots.push_back(landmark.id);
    present.objects.push_back(landmark.object);
  }
  // A session that did not keep the covariance of all together has those of each.
  const std::optional<Eigen::MatrixXd> kept = CovarianceOf(present.slots, b.memory.landmarks);
  present.covariance = kept ? *kept : JointOfSingles(present.objects);
  FormerSessionTie tie(ParamsOf(b));
  tie.SetFormer(prior.former);
  const bool is_matched = tie.Match(present, std::nullopt);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    landmarks[i].former = is_matched ? tie.identities()[i] : FormerIdentity();
  }
  return landmarks;
}

}  // namespace limpet
