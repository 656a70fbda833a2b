// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Values what another look would tell about each object's status: the expected drop of the
/// posterior's entropy, earlier looks more (`paper.md` section 5). Former objects that nobody has
/// looked at yet come first in a change session, because their status is the least known. The worth
/// falls to zero by itself once an object has been looked at; a look is what the map counts as one
/// (`survey/look.hpp`). Looks that were flown and told nothing halve it, until the object is given
/// up.
class BHV_RevisitOpi final : public Behavior {
 public:
  struct Params {
    double metres_per_nat = 60.0;
    double detection_probability = 0.95;
    double false_alarm_probability = 0.01;
    Meters decay{100.0};
    double settled_entropy = 0.25;
    int settled_looks = 2;
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
      visit("decay_m", decay, "Path after which a look is worth nothing more",
            InRange(Meters(10.0), Meters(10000.0)));
      visit("settled_entropy", settled_entropy, "Below this entropy [nats] an object is settled",
            InRange(0.0, 1.4));
      visit("settled_looks", settled_looks, "... and after this many looks, whatever they said",
            InRange(1, 100));
      visit("fruitless_decay", fruitless_decay,
            "A look's worth is multiplied by this for each that was flown and told nothing",
            InRange(0.0, 1.0));
      visit("give_up_looks", give_up_looks,
            "After this many fruitless looks in a row an object is given up", InRange(1, 1000));
    }
  };
  explicit BHV_RevisitOpi(const Params& params) : params_(params) {}
  [[nodiscard]] bool IsAboutObjects() const override { return true; }
  [[nodiscard]] bool WantsView() const override { return true; }
  void Shape(const Situation& now, double weight, SearchObjective& objective) const override;
  void Offer(const Situation& now, std::vector<Option>& options) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;
  [[nodiscard]] std::vector<RevisitInterest> Interests(const Situation& now) const override;

 private:
  [[nodiscard]] RevisitInterest InterestIn(const WatchedObject& object, const Situation& now) const;
  [[nodiscard]] SearchObjective Targets(const Situation& now, double weight) const;
  Params params_;
};

/// Expected drop of the entropy of `posterior` [nats] from one look with the given rates.
[[nodiscard]] double ExpectedEntropyDrop(const ChangePosterior& posterior, double detection,
                                         double false_alarm);

}  // namespace limpet
