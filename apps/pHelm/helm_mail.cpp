// SPDX-License-Identifier: MIT
// Which mail the helm hears.
#include <utility>
#include <variant>

#include "apps/pHelm/helm_app.hpp"
#include "apps/pHelm/helm_warnings.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

void HelmApp::SubscribeToOverride() {
  Subscribe(topics::kManualOverride, &HelmApp::OnOverride);
  Subscribe(topics::kManualOverrideMisspelt, &HelmApp::OnOverride);
  if (params_.other_override_var.empty()) return;
  SubscribeRaw(params_.other_override_var, [this](const MessagePtr& message) {
    const auto* text = std::get_if<std::string>(&message->value);
    if (text == nullptr) return;
    if (EqualsIgnoringCase(*text, "true")) Park(true);
    if (EqualsIgnoringCase(*text, "false")) Park(false);
  });
}

bool HelmApp::IsInTime(const std::string& variable, Seconds stamp) {
  const std::optional<std::string> complaint = mail_skew_.Refuse(variable, stamp, now());
  if (complaint) {
    Warn(warnings::kMailSkewed, *complaint);
    if (!lead_.leads()) Publish(topics::kHelmSkew, *complaint);
  } else if (!mail_skew_.is_refusing()) {
    ClearWarning(warnings::kMailSkewed);
  }
  return !complaint;
}

void HelmApp::SubscribeForBehaviors() {
  for (const std::string& variable : host_.Variables()) {
    if (heard_variables_.insert(variable).second) {
      mail_skew_.Begin(variable, now());
      SubscribeRaw(variable, [this](const MessagePtr& message) {
        // What behaviors of this helm have posted is right at any time.
        if (message->source != name() && !IsInTime(message->name, message->time)) return;
        host_.SetVariable(message->name, message->value, message->time);
        const std::vector<std::string> results = host_.TakeUpdateResults();
        is_updated_ = is_updated_ || !results.empty();  // it may ask for more, e.g. a condition
        journal_.PostUpdateResults(results);
      });
    }
  }
}

void HelmApp::PostRequests() {
  if (!app_wait_.is_over()) {
    Warn(warnings::kAppsAwaited, "not there yet: " + app_wait_.MissingText());
    return;
  }
  ClearWarning(warnings::kAppsAwaited);
  Post(std::exchange(requests_, {}));
}

}  // namespace limpet
