// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "limpet/tuning/tuning_report.hpp"

namespace limpet {
namespace {

using Json = nlohmann::ordered_json;

Json NumberOrNull(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json Values(const ParameterSpace& space, const SettingValues& values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i)
    json[space.parameters()[i].name] = values[i];
  return json;
}

void AddInterval(const std::optional<MeanInterval>& interval, Json& json) {
  json["mean"] = interval ? Json(interval->mean) : Json(nullptr);
  json["low"] = interval ? NumberOrNull(interval->low) : Json(nullptr);
  json["high"] = interval ? NumberOrNull(interval->high) : Json(nullptr);
}

Json SettingJson(const TuningTask& task, const ParameterSpace& space, const Contender& contender) {
  Json json{{"values", Values(space, contender.setting)}};
  AddInterval(ObjectiveOf(task, contender), json);
  json["runs"] = contender.outcomes.size();
  json["failed"] = contender.Failures();
  json["is_default"] = contender.is_default;
  json["eliminated"] = contender.is_in() ? Json(nullptr) : Json(contender.eliminated);
  return json;
}

Json Seeds(std::uint64_t first, std::size_t count) { return {{"first", first}, {"count", count}}; }

}  // namespace

std::string TuneJson(const TuningTask& task, const ParameterSpace& space,
                     const TuningOutcome& outcome) {
  Json json{{"format", "limpet-tuning-1"},
            {"mission", task.mission},
            {"objective", task.objective},
            {"maximise", task.maximises},
            {"constraints", task.constraints},
            {"share", task.rules.share},
            {"method", task.rules.method},
            {"interval", "95 %, Student's t"},
            {"search_seeds", Seeds(task.first_seed, task.rules.runs)},
            {"held_out_seeds", Seeds(task.first_seed + task.rules.runs, task.rules.runs)}};
  json["parameters"] = Json::array();
  for (const VariedParameter& parameter : space.parameters()) {
    json["parameters"].push_back({{"name", parameter.name},
                                  {"low", parameter.low},
                                  {"high", parameter.high},
                                  {"levels", parameter.levels}});
  }
  json["verdict"] = VerdictText(task, space, outcome);
  json["is_better"] = outcome.is_better;
  // On held-out seeds, if another setting was judged there.
  const Contender& by_default =
      outcome.held_out ? outcome.held_out->by_default : outcome.contenders.front();
  const Contender& best = outcome.is_better ? outcome.held_out->winner : by_default;
  json["best"] = SettingJson(task, space, best);
  json["default"] = SettingJson(task, space, by_default);
  json["best_other"] =
      outcome.held_out ? SettingJson(task, space, outcome.held_out->winner) : Json();
  json["difference"] = Json::object();
  AddInterval(ObjectiveDifference(task, outcome), json["difference"]);
  json["difference"]["runs"] = outcome.held_out ? outcome.held_out->differences.size() : 0;
  json["settings"] = Json::array();
  for (const Contender& contender : outcome.contenders)
    json["settings"].push_back(SettingJson(task, space, contender));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace limpet
