// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// When an object is worth another look, and how much: the expected drop of the entropy of its
/// status. Objects that are known well enough are settled; looks that were flown and told nothing
/// make the next one worth less, until the object is given up.
class RevisitPolicy {
 public:
  struct Params {
    double metres_per_nat = 270.0;
    // Of a whole pass, which takes many frames. What one frame shows is DetectionModel's.
    double detection_probability = 0.95;
    double false_alarm_probability = 0.01;
    double settled_entropy = 0.25;
    int settled_looks = 4;
    double fruitless_decay = 0.5;
    int give_up_looks = 3;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("metres_per_nat", metres_per_nat, "Path worth flying to learn one nat of status",
            InRange(0.0, 10000.0));
      visit("detection_probability", detection_probability,
            "Chance that one pass over a present object detects it", InRange(0.5, 0.999));
      visit("false_alarm_probability", false_alarm_probability,
            "Chance that one pass over nothing detects something", InRange(0.0001, 0.5));
      visit("settled_entropy", settled_entropy, "Below this entropy [nats] an object is settled",
            InRange(0.0, 1.4));
      visit("settled_looks", settled_looks,
            "After this many looks an object is settled, whatever they said", InRange(1, 100));
      visit("fruitless_decay", fruitless_decay,
            "A look's worth is multiplied by this for each that was flown and told nothing",
            InRange(0.0, 1.0));
      visit("give_up_looks", give_up_looks,
            "After this many fruitless looks in a row an object is given up", InRange(1, 1000));
    }
  };
  explicit RevisitPolicy(const Params& params) : params_(params) {}

  [[nodiscard]] RevisitInterest InterestIn(const WatchedObject& object, const Situation& now) const;
  /// Interest in every object of `now`, in its order.
  [[nodiscard]] std::vector<RevisitInterest> Interests(const Situation& now) const;
  /// Objects that want a look, each worth `weight` times its interest.
  [[nodiscard]] std::vector<Target> OpenTargets(const Situation& now, double weight) const;

 private:
  Params params_;
};

/// Expected drop of the entropy of `posterior` [nats] from one look, which detects an object with
/// these chances.
[[nodiscard]] double ExpectedEntropyDrop(const StatusPosterior& posterior,
                                         const PresenceLikelihood& detection);

}  // namespace limpet
