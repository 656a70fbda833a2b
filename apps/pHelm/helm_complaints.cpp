// SPDX-License-Identifier: MIT
// What the helm says of behaviors that fail, are late or warn, and of a helm that it leads.
#include <algorithm>
#include <iterator>
#include <utility>

#include "apps/pHelm/helm_app.hpp"
#include "apps/pHelm/helm_warnings.hpp"
#include "limpet/helm/behavior_failure_warnings.hpp"

namespace limpet {

void HelmApp::GatherFailures() {
  std::vector<BehaviorFailure> failures = view_failures_;
  std::ranges::move(std::exchange(call_failures_, {}), std::back_inserter(failures));
  std::ranges::move(host_.TakeFailures(), std::back_inserter(failures));
  for (BehaviorFailure& failure : failures) {
    const bool is_known = std::ranges::find(motion_.failures, failure) != motion_.failures.end();
    if (is_known) continue;
    motion_.warnings.push_back(
        {.owner = failure.owner,
         .warning = {warnings::kBehaviorFailed.Of(failure.owner), failure.text}});
    motion_.failures.push_back(std::move(failure));
  }
  std::ranges::copy(view_late_, std::back_inserter(motion_.warnings));
  std::ranges::move(std::exchange(call_late_, {}), std::back_inserter(motion_.warnings));
  std::ranges::move(host_.TakeLateCalls(), std::back_inserter(motion_.warnings));
}

void HelmApp::TellFailures() {
  std::string text;
  for (const BehaviorFailure& failure : motion_.failures) {
    text += (text.empty() ? "" : "; ") + failure.owner + ": " + failure.text;
  }
  if (!text.empty() && text != told_failures_) Publish(topics::kBehaviorError, text);
  told_failures_ = std::move(text);
}

void HelmApp::TellBehaviorWarnings() {
  std::vector<OwnedWarning> raised = motion_.warnings;
  const std::vector<OwnedWarning> of_host = host_.warnings();
  raised.insert(raised.end(), of_host.begin(), of_host.end());
  const WarningBook::Change change = warning_book_.Update(raised);
  for (const WarningId& id : change.cleared) {
    ClearWarning(id);
  }
  for (const BehaviorWarning& warning : change.standing) {
    Warn(warning.id, warning.text);
  }
}

void HelmApp::JudgeLedHelm(Seconds now) {
  if (const std::optional<std::string> complaint = led_answers_.Complaint(now)) {
    Warn(warnings::kLedHelmDeaf, *complaint);
  } else {
    ClearWarning(warnings::kLedHelmDeaf);
  }
}

}  // namespace limpet
