// SPDX-License-Identifier: MIT
#include "limpet/comparison/comparison_json.hpp"

#include <nlohmann/json.hpp>

#include "limpet/core/units.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson PlaceJson(const std::optional<Eigen::Vector3d>& p_W) {
  return p_W ? OrderedJson{p_W->x(), p_W->y(), p_W->z()} : OrderedJson(nullptr);
}

OrderedJson ObjectJson(const OpiBelief& object, const SessionComparison& comparison) {
  return {{"decided", NameOf(object.decided)},
          {"color", object.object.color},
          {"ned_m", PlaceJson(object.object.p_W)},
          {"moved_from_ned_m", PlaceJson(comparison.MovedFrom_W(object))},
          {"moved_probability", object.moved_probability ? OrderedJson(*object.moved_probability)
                                                         : OrderedJson(nullptr)},
          {"id_a", object.former_id ? OrderedJson(*object.former_id) : OrderedJson(nullptr)},
          {"landmark_b", object.landmark ? OrderedJson(*object.landmark) : OrderedJson(nullptr)},
          {"posterior", JsonOf(object.posterior)},
          {"looks_b", object.looks},
          {"looks_with_box_b", object.looks_with_box},
          {"log_likelihood_ratio_b", object.log_likelihood_ratio}};
}

}  // namespace

OrderedJson JsonOf(const StatusPosterior& posterior) {
  OrderedJson out = OrderedJson::object();
  for (const auto& [status, probability] : posterior.shares())
    out[NameOf(status)] = probability;
  return out;
}

OrderedJson JsonOf(const SessionFacts& facts) {
  return {{"mission", facts.mission},
          {"session", facts.session},
          {"seed", facts.seed},
          {"saved_at_s", facts.saved_at}};
}

OrderedJson JsonOf(const SessionComparison& comparison) {
  OrderedJson objects = OrderedJson::array();
  for (const OpiBelief& object : comparison.objects)
    objects.push_back(ObjectJson(object, comparison));
  const FrameOffset& offset = comparison.offset;
  return {{"session_a", JsonOf(comparison.a)},
          {"session_b", JsonOf(comparison.b)},
          {"offset",
           {{"north_m", offset.shift_W.x()},
            {"east_m", offset.shift_W.y()},
            {"turn_deg", DegreesFromRadians(offset.turn)}}},
          {"changes", std::move(objects)}};
}

std::string Json(const SessionComparison& comparison) { return JsonOf(comparison).dump(1) + "\n"; }

}  // namespace limpet
