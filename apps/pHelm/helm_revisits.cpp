// SPDX-License-Identifier: MIT
// Which objects still want a look, for the mission manager and the operator.
#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "apps/pHelm/helm_app.hpp"
#include "apps/pHelm/helm_warnings.hpp"

namespace limpet {
namespace {

/// Ids of the objects in `state`, e.g. `3, 7`; "" if none is.
std::string IdsIn(const std::string& state, const HelmRevisits& revisits) {
  std::string ids;
  for (const RevisitInterest& object : revisits.objects) {
    if (object.state == state) {
      ids += fmt::format("{}{}", ids.empty() ? "" : ", ", object.id);
    }
  }
  return ids;
}

}  // namespace

void HelmApp::WarnOfObjects(const WarningId& id, const std::string& ids, const std::string& what) {
  if (ids.empty()) {
    ClearWarning(id);
  } else {
    Warn(id, fmt::format("object {}: {}", ids, what));
  }
}

void HelmApp::TellFruitless(const HelmRevisits& revisits) {
  for (const RevisitInterest& object : revisits.objects) {
    const auto before = std::ranges::find(revisits_.objects, object.id, &RevisitInterest::id);
    if (object.fruitless > (before == revisits_.objects.end() ? 0 : before->fruitless)) {
      ReportEvent(events::kFruitlessLook, fmt::format("looks at object {} that told nothing: {}",
                                                      object.id, object.fruitless));
    }
  }
}

std::string HelmApp::RevisitText() const {
  std::string text = fmt::format("{}", revisits_.objects.size());
  for (const auto& [state, words] :
       {std::pair{"open", "still want a look"}, std::pair{"given_up", "given up"},
        std::pair{"out_of_reach", "out of reach"}}) {
    if (const auto count = std::ranges::count(revisits_.objects, state, &RevisitInterest::state)) {
      text += fmt::format(", {} {}", count, words);
    }
  }
  return text;
}

void HelmApp::TellRevisits(Seconds now) {
  auto interests = planner_.InterestsIfDue(Bidders(), *nav_, now);
  if (!interests) {
    return;
  }
  HelmRevisits revisits{.objects = std::move(*interests)};
  if (TopicCodec<HelmRevisits>::Encode(revisits) == TopicCodec<HelmRevisits>::Encode(revisits_)) {
    return;
  }
  TellFruitless(revisits);
  revisits_ = std::move(revisits);
  Publish(topics::kHelmRevisits, revisits_);
  WarnOfObjects(warnings::kObjectsGivenUp, IdsIn("given_up", revisits_),
                "looks told nothing; no more");
  WarnOfObjects(warnings::kObjectsOutOfReach, IdsIn("out_of_reach", revisits_),
                "no pass inside the operating region at survey altitude would show it");
}

}  // namespace limpet
