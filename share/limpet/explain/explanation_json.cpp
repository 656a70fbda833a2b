// SPDX-License-Identifier: MIT
#include "limpet/explain/explanation_json.hpp"

#include <nlohmann/json.hpp>

#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json OrNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json Built(const WeightedBid& weighted) {
  const Bid& bid = weighted.bid;
  Json why = Json::object();
  for (const Reason& reason : bid.why) {
    why[reason.name] = reason.value;
  }
  return {{"behavior", weighted.behavior},
          {"value", bid.value},
          {"weight", weighted.weight},
          {"veto", OrNull(bid.veto)},
          {"why", why}};
}

Json Built(const ExplainedOption& explained) {
  const BiddenOption& option = explained.bidden;
  const WeightedBid* veto = VetoOn(option);
  Json bids = Json::array();
  for (const WeightedBid& bid : option.bids) {
    bids.push_back(Built(bid));
  }
  return {{"source", option.source},
          {"length_m", option.length},
          {"end_ned_m", option.end},
          {"total", option.total},
          {"rate", option.rate},
          {"rate_length_m", RateLengthOf(option)},
          {"vetoed_by", veto == nullptr ? Json(nullptr) : Json(veto->behavior)},
          {"lost_because", explained.lost_because},
          {"bids", bids}};
}

Json Built(const LoggedMotion& logged) {
  Json bids = Json::array();
  for (const MotionOpinion& opinion : logged.motion.opinions) {
    bids.push_back({{"behavior", opinion.behavior},
                    {"variables", opinion.variables},
                    {"weight", opinion.weight},
                    {"value", opinion.value},
                    {"summit", OrNull(opinion.summit)},
                    {"flat_half_width", OrNull(opinion.flat_half_width)},
                    {"base_half_width", OrNull(opinion.base_half_width)}});
  }
  return {{"t", logged.time},
          {"course_deg", OrNull(logged.motion.course_deg)},
          {"speed_mps", OrNull(logged.motion.speed_mps)},
          {"depth_m", OrNull(logged.motion.depth_m)},
          {"stopped", OrNull(logged.stopped)},
          {"bids", bids}};
}

Json Built(const Explanation& explanation, const std::string& session) {
  Json out;
  if (!session.empty()) {
    out["session"] = session;
  }
  out["t"] = explanation.time;
  out["path_id"] = explanation.path_id;
  out["cause"] = explanation.cause;
  out["ranked_by"] = explanation.order == OptionOrder::kPerMetre ? "rate" : "total";
  out["chosen"] = OrNull(explanation.chosen);
  out["options"] = Json::array();
  for (const ExplainedOption& option : explanation.options) {
    out["options"].push_back(Built(option));
  }
  out["flips"] = Json::array();
  for (const Flip& flip : explanation.flips) {
    out["flips"].push_back(
        {{"behavior", flip.behavior}, {"weight", flip.new_weight}, {"to", flip.to}});
  }
  out["motion"] = explanation.motion ? Built(*explanation.motion) : Json(nullptr);
  out["waiting"] = Json::array();
  for (const WaitingBehavior& waiting : explanation.waiting) {
    out["waiting"].push_back({{"behavior", waiting.name},
                              {"state", waiting.is_done ? "completed" : "idle"},
                              {"because", waiting.what},
                              {"since", waiting.since}});
  }
  return out;
}

/// Names come from other people's files: broken UTF-8 must not throw here.
std::string Text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string JsonOf(const Explanation& explanation, const std::string& session) {
  return Text(Built(explanation, session));
}

std::string JsonOf(std::span<const Explanation> explanations, const std::string& session) {
  Json list = Json::array();
  for (const Explanation& explanation : explanations) {
    list.push_back(Built(explanation, session));
  }
  return Text(list);
}

}  // namespace limpet
