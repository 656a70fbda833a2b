// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/planning/lane_tours.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/tour_path.hpp"
#include "limpet/planning/tour_search.hpp"

namespace limpet {

struct MissionPlanParams {
  LaneParams lanes{};
  int seeds = 6;           ///< lane tours that a new plan is sought from
  int first_edits = 8000;  ///< tried for a new plan; 0: the best lanes are the plan
  int edits = 1200;        ///< tried at each later decision
  int rest_edits = 50;     ///< tried for what follows an option, if it is among the best
  Meters warmth{8.0};      ///< of the search
};

/// The plan of all that is left of a survey, kept from decision to decision: sought from lanes,
/// improved by random edits of the whole, and followed, or left for another option and taken up
/// again behind it.
class MissionPlan {
 public:
  MissionPlan(const MissionPlanParams& params, const Random& random)
      : params_(params), search_(params.warmth, random) {}

  /// What is to be planned, from where.
  struct Task {
    Pose2 pose;
    const Ground* ground = nullptr;  ///< not null; outlives the decision, and so does `region`
    const Region* region = nullptr;
    Meters turn_radius{3.0};
    TourGoal goal;
    double travelled = 0.0;  ///< path flown since some fixed moment [m]
  };

  /// Brings the plan up to date and appends it as an option, if there is anything left to do; and
  /// the rest of the path in force, if it is one of those completed; and plans about as good
  /// that begin otherwise.
  void Offer(const Task& now, const char* source, std::vector<Option>& options);
  /// Lengthens those of `options` that are not whole by what is left of the plan behind them.
  /// REQUIRES: Offer of the same decision.
  void Complete(std::vector<Option>& options);
  /// `option` is flown from now on.
  void OnChoice(const Option& option);

 private:
  [[nodiscard]] bool IsTheSameSurvey() const;
  /// An obstacle that has been found since stands where the plan leads.
  [[nodiscard]] bool IsInTheWay() const;
  [[nodiscard]] SurveyTour Rest() const;
  void Renew(TourJudge& judge);
  /// What a new plan is sought from.
  [[nodiscard]] std::vector<SurveyTour> Seeds(TourJudge& judge) const;
  /// True if a plan that lacks so much useful track [m] should be sought anew.
  [[nodiscard]] bool IsStale(double lacking) const;
  [[nodiscard]] bool SeesOtherwise() const;
  /// What looks at all targets now would be worth beyond those that it has [m].
  [[nodiscard]] double LeftOutBy(const SurveyTour& tour) const;
  void Replan(TourJudge& judge);
  [[nodiscard]] FlownTour FromHere(const SurveyTour& tour) const;
  [[nodiscard]] TourCost CostOf(TourJudge& judge, const DubinsPath& path) const;
  void OfferPlan(TourJudge& judge, const SurveyTour& plan, std::vector<Option>& options);
  void OfferRivals(TourJudge& judge, std::vector<Option>& options);
  void OfferOtherBeginnings(TourJudge& judge, std::vector<Option>& options);
  void Improve(TourJudge& judge, SurveyTour& tour, int edits);
  [[nodiscard]] bool BeginsOtherwise(const FlownTour& tour) const;
  void OfferRest(TourJudge& judge, std::vector<Option>& options);
  struct Completion;
  [[nodiscard]] Completion CompletionOf(TourJudge& judge, Option& option) const;
  void Complete(TourJudge& judge, Completion& completion, bool is_among_the_best);
  [[nodiscard]] double SinceChoice() const { return now_.travelled - chosen_at_; }

  MissionPlanParams params_;
  TourSearch search_;
  Task now_;
  std::string source_;
  bool is_planned_ = false;  ///< there is a plan now
  SurveyTour plan_;
  std::vector<SurveyTour> rivals_;  ///< of a new plan: others that begin otherwise
  GridFrame frame_;                 ///< of the ground that the plan is for
  std::size_t cells_of_area_ = 0;
  std::size_t obstacle_mark_ = 0;     ///< of the region that the plan keeps to
  double planned_swath_ = 0.0;        ///< of the ground when the plan was last sought anew [m]
  double lacking_when_sought_ = 0.0;  ///< useful track that the plan lacked then, or less since [m]
  double sought_at_ = 0.0;            ///< [m travelled] when it was last sought anew
  double left_out_m_ = 0.0;           ///< LeftOutBy of the plan at the last decision
  std::vector<FlownTour> completed_;  ///< the options of this decision
  FlownTour chosen_;                  ///< what is flown, with its path
  double chosen_at_ = 0.0;            ///< [m travelled]
};

}  // namespace limpet
