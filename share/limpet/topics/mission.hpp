// SPDX-License-Identifier: MIT
// What pSurvey, pHelm and pPilot tell each other and the operator.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/topics/bid.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// The area to survey, NED [m], the margin around it that the vehicle may use, and the band of
/// heights above the seabed in which objects may float. A rectangle, unless `outline` is there:
/// then the rectangle is the box around that. Lists of points are text of MOOS's coordinates, x
/// east and y north [m], as `{x,y:x,y:x,y}`.
struct SurveyArea {
  double north_min = 0.0, north_max = 0.0, east_min = 0.0, east_max = 0.0;
  double margin = 2.0;
  double object_height_max = 2.0;
  std::optional<std::string> outline{};
  std::optional<std::string> keep_out{};          ///< zones, one after the other: `{...}{...}`
  std::optional<std::string> operating_region{};  ///< absent: the area and its margin
  std::optional<std::string> transit{};           ///< way points from the start to the area
  template <class V>
  void Describe(V& visit) {
    visit("north_min", north_min), visit("north_max", north_max);
    visit("east_min", east_min), visit("east_max", east_max);
    visit("margin", margin), visit("object_height_max", object_height_max);
    visit("area", outline), visit("keep_out", keep_out);
    visit("operating_region", operating_region), visit("transit", transit);
  }
  bool operator==(const SurveyArea&) const = default;
};

struct HomePoint {
  double north = 0.0, east = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east);
  }
};

/// One arc or line of a Dubins path; curvature 1/m, positive turns to starboard.
struct PathSegment {
  double curvature = 0.0;
  double length = 0.0;
};

/// The path the helm chose: where it starts, its segments, and why it was chosen.
struct HelmPath {
  int id = 0;
  double north = 0.0, east = 0.0, yaw = 0.0;
  std::vector<PathSegment> segments;
  std::string purpose;  ///< e.g. cover, revisit, home
};
template <>
struct TopicCodec<HelmPath> : JsonCodec<HelmPath> {};

/// One option of a decision as each behavior valued it; metres of path (nats in paper mode).
struct BiddenOption {
  std::string source;  ///< generator: beam, view_tree, home, ...
  double length = 0.0;
  double total = 0.0;  ///< weighted sum of the bids
  double rate = 0.0;   ///< total per metre of its length, or of `rate_length`
  /// Options that lead to the same end are compared by their totals: they share one length [m].
  std::optional<double> rate_length{};
  std::array<double, 2> end{};  ///< north, east of its end [m]
  std::vector<WeightedBid> bids;
};
/// How options of different length are compared.
enum class OptionOrder {
  kPerMetre,  ///< by the sum of bids per metre of option: what follows a short one counts too
  kBySum      ///< by the sum alone
};
struct HelmBids {
  int path_id = 0;
  std::string cause;   ///< why the helm decided now
  int considered = 0;  ///< options valued
  OptionOrder order = OptionOrder::kPerMetre;
  /// All of them, best first, vetoed ones last; among equals in the order of their offers.
  std::vector<BiddenOption> options;
};
template <>
struct TopicCodec<HelmBids> : JsonCodec<HelmBids> {};

/// What one behavior would like of how to move now, as the helm weighs it.
struct MotionOpinion {
  std::string behavior;
  std::string variables;  ///< course, speed or depth; several, joined by +, are judged together
  double weight = 1.0;
  double value = 0.0;  ///< of what was chosen, 0 to 1
  /// Peak over one variable [deg, m/s, m]: what it likes best, how far around it anything is as
  /// good, and from where on it is worth nothing.
  std::optional<double> summit, flat_half_width, base_half_width;
};
/// How the helm moves now, and whose opinions that rests on.
struct HelmMotion {
  std::optional<double> course_deg, speed_mps, depth_m;
  std::vector<MotionOpinion> opinions;
};
template <>
struct TopicCodec<HelmMotion> : JsonCodec<HelmMotion> {};

/// What the helm still wants of one object, and why.
struct RevisitInterest {
  int id = 0;           ///< as OpiBelief::id
  std::string state{};  ///< open, settled, given_up, out_of_reach
  double worth = 0.0;   ///< of a look now [m of path], 0 unless open
  int fruitless = 0;    ///< looks planned and flown since its belief last changed
};
struct HelmRevisits {
  std::vector<RevisitInterest> objects;
};
template <>
struct TopicCodec<HelmRevisits> : JsonCodec<HelmRevisits> {};

/// Normalised thrust of each thruster, -1 to 1, in the order of the vehicle file; of up to six
/// those that the vehicle has not are zero, the seventh and eighth are said where it has them.
struct ThrusterCommand {
  static constexpr std::size_t kMost = 8;
  double t1 = 0.0, t2 = 0.0, t3 = 0.0, t4 = 0.0, t5 = 0.0, t6 = 0.0;
  std::optional<double> t7 = std::nullopt, t8 = std::nullopt;

  /// The command of as many shares as there are thrusters, at most kMost.
  [[nodiscard]] static ThrusterCommand Of(std::span<const double> shares) {
    const auto at = [&](std::size_t i) { return i < shares.size() ? shares[i] : 0.0; };
    const auto beyond = [&](std::size_t i) {
      return i < shares.size() ? std::optional(shares[i]) : std::nullopt;
    };
    return {at(0), at(1), at(2), at(3), at(4), at(5), beyond(6), beyond(7)};
  }
  [[nodiscard]] std::array<double, kMost> Shares() const {
    return {t1, t2, t3, t4, t5, t6, t7.value_or(0.0), t8.value_or(0.0)};
  }
  template <class V>
  void Describe(V& visit) {
    visit("t1", t1), visit("t2", t2), visit("t3", t3), visit("t4", t4), visit("t5", t5),
        visit("t6", t6), visit("t7", t7), visit("t8", t8);
  }
};

namespace topics {
inline const auto kSurveyArea = Declare<SurveyArea>(
    "SURVEY_AREA", "area to cover",
    {.unit = "m", .frame = "NED", .rate = "once", .writers = {"pSurvey"}, .is_command = true});
inline const auto kSurveyHome = Declare<HomePoint>(
    "SURVEY_HOME", "where the vehicle started and returns to",
    {.unit = "m", .frame = "NED", .rate = "once", .writers = {"pSurvey"}, .is_command = true});
inline const auto kSurveyPhase =
    Declare<std::string>("SURVEY_PHASE", "IDLE, ALIGN, DIVE, SURVEY, RETURN, ASCEND, FIX, DONE",
                         {.rate = "on change", .writers = {"pSurvey"}});
inline const auto kDeploy =
    Declare<bool>("DEPLOY", "start the mission",
                  {.rate = "on event", .writers = {"operator", "pHelm"}, .is_command = true});
inline const auto kReturn = Declare<bool>(
    "RETURN", "end the survey and go home",
    {.rate = "on event", .writers = {"operator", "pHelm", "pSafety"}, .is_command = true});
inline const auto kManualOverride = Declare<bool>(
    "MOOS_MANUAL_OVERRIDE", "true parks the helm",
    {.rate = "on event", .writers = {"operator", "pHelm", "pLaunch"}, .is_command = true});
inline const auto kManualOverrideMisspelt =
    Declare<bool>("MOOS_MANUAL_OVERIDE", "the same, as older MOOS programs spell it",
                  {.rate = "on event", .writers = {"operator"}, .is_command = true});
inline const auto kHelmState =
    Declare<std::string>("IVPHELM_STATE", "DRIVE or PARK; MALCONFIG: it cannot begin",
                         {.rate = "10 Hz", .writers = {"pHelm"}});
/// What IVPHELM_ALLSTOP says while nothing is stopped, a stock helm's word.
inline constexpr const char* kNoAllStop = "clear";
inline const auto kHelmAllStop = Declare<std::string>(
    "IVPHELM_ALLSTOP", "clear, or why all is stopped", {.rate = "on change", .writers = {"pHelm"}});
inline const auto kBehaviorError = Declare<std::string>(
    "BHV_ERROR", "behaviors whose bid could not be heard, and why: `name: text`",
    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmPath = Declare<HelmPath>(
    "HELM_PATH", "path being followed: Dubins arcs and lines",
    {.unit = "m, rad, 1/m", .frame = "NED", .rate = "on decision", .writers = {"pHelm"}});
inline const auto kHelmBids = Declare<HelmBids>(
    "HELM_BIDS", "last decision: options, bids, reasons",
    {.unit = "m of path", .frame = "NED", .rate = "on decision", .writers = {"pHelm"}});
inline const auto kHelmMotion = Declare<HelmMotion>(
    "HELM_MOTION", "how to move now: what was chosen, and what each behavior would like",
    {.unit = "deg, m/s, m", .rate = "1 Hz, and when others have a say", .writers = {"pHelm"}});
inline const auto kHelmGivesUp = Declare<bool>("HELM_GIVES_UP",
                                               "the plan of all that is left of the area shows "
                                               "next to nothing more and lacks its end: what is "
                                               "unseen is not worth its way",
                                               {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmRevisits = Declare<HelmRevisits>(
    "HELM_REVISITS", "which objects the helm still wants to look at, and why not the others",
    {.unit = "m of path", .rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmLead = Declare<std::string>(
    "HELM_LEAD",
    "of a helm that leads another one: way (it told way points), course (no way, but course and "
    "speed), hold (the vehicle is to stay) or none",
    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kDesiredHeading = Declare<double>(
    "DESIRED_HEADING", "course to steer",
    {.unit = "deg", .frame = "clockwise from north", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kDesiredSpeed =
    Declare<double>("DESIRED_SPEED", "speed to hold",
                    {.unit = "m/s", .frame = "over ground", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kDesiredDepth =
    Declare<double>("DESIRED_DEPTH", "depth to hold",
                    {.unit = "m", .frame = "down", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kDesiredTurnRate = Declare<double>(
    "DESIRED_TURN_RATE", "feed-forward of the course",
    {.unit = "rad/s", .frame = "starboard positive", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kThrusterCommand = Declare<ThrusterCommand>(
    "THRUSTER_COMMAND", "normalised thrust of each thruster, in the order of the vehicle file",
    {.unit = "-1 to 1", .frame = "body FRD", .rate = "10 Hz", .writers = {"pPilot", "pLaunch"}});
inline const auto kMissionEnd =
    Declare<std::string>("MISSION_END", "home, aborted, timeout or lost: the session is over",
                         {.rate = "once", .writers = {"pSurvey", "pLaunch"}});
}  // namespace topics

}  // namespace limpet
