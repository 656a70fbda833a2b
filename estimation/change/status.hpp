// SPDX-License-Identifier: MIT
// How a place's 4-way posterior follows from its looks, and what is decided from it.
// docs/references.md, "Change posterior".
#pragma once

#include "estimation/change/place_evidence.hpp"
#include "limpet/core/params.hpp"
#include "limpet/objects/status_posterior.hpp"
#include "limpet/survey/visibility_belief.hpp"

namespace limpet {

/// What is taken for granted before any look.
struct StatusPriors {
  double presence = 0.02;    ///< pi: an object at a given place in the former session
  double survival = 0.5;     ///< s: it is still there
  double appearance = 0.02;  ///< a: one has come to a place that had none
  double lookalike = 5e-5;   ///< l: something lasting is at a given place that looks like an object
  double lookalike_survival = 0.9;  ///< it is still there in the next session
  double decide_at = 0.9;           ///< a status is decided from this probability on

  template <class V>
  void Describe(V& visit) {
    visit("presence_prior", presence, "Chance of an object at a given place", InRange(1e-5, 0.5));
    visit("survival_prior", survival, "Chance that a former object is still there",
          InRange(0.01, 0.99));
    visit("appearance_prior", appearance, "Chance that an object came to an empty place",
          InRange(1e-5, 0.5));
    visit("lookalike_prior", lookalike,
          "Chance that something lasting looks like an object at a given place",
          InRange(1e-7, 0.5));
    visit("lookalike_survival", lookalike_survival,
          "Chance that such a thing is still there in the next session", InRange(0.0, 1.0));
    visit("decide_at", decide_at, "Probability from which a status is decided",
          InRange(0.5, 0.999));
  }
};

/// Lambda of a place in both sessions.
struct SessionLambdas {
  double former = 0.0, now = 0.0;
};

/// Change session: weights C: pi s e^(Ld+Lc), R: pi (1-s) e^Ld, N: (1-pi) a e^Lc,
/// nothing: (1-pi)(1-a); Ld, Lc: `lambda` of the former and of this session, where nothing here
/// looks like an object.
[[nodiscard]] StatusPosterior ChangeStatus(const SessionLambdas& lambda,
                                           const StatusPriors& priors);
/// Discovery session: an object is there (appeared) or not (nothing).
[[nodiscard]] StatusPosterior DiscoveryStatus(double lambda_now, const StatusPriors& priors);

/// Both where this session's evidence is known for each visibility of the water: a place that was
/// not seen in water where it could not be seen says nothing. The water is the same for all places,
/// so `water` is to hold what all of them say of it. What the former session saw may have been a
/// lookalike that is still there: boxes of both sessions do not make it an object.
[[nodiscard]] StatusPosterior ChangeStatus(double lambda_former, const PlaceEvidence& now,
                                           const VisibilityBelief& water,
                                           const StatusPriors& priors);
[[nodiscard]] StatusPosterior DiscoveryStatus(const PlaceEvidence& now,
                                              const VisibilityBelief& water,
                                              const StatusPriors& priors);
/// The one Lambda that leads to the same chance of an object.
[[nodiscard]] double LambdaIn(const VisibilityBelief& water, const PerVisibility& lambda,
                              const StatusPriors& priors);

/// The status that reaches decide_at, else uncertain; without a look it is not inspected.
[[nodiscard]] Status Decide(const StatusPosterior& posterior, int looks,
                            const StatusPriors& priors);

}  // namespace limpet
