// SPDX-License-Identifier: MIT
#include "limpet/app/app.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "limpet/app/warning_text.hpp"

namespace limpet {

std::string AppContext::Global(std::string_view key) const {
  const auto found = std::ranges::find_if(
      globals, [key](const ConfigEntry& entry) { return EqualsIgnoringCase(entry.key, key); });
  return found == globals.end() ? "" : found->value;
}

App::App(const AppContext& context)
    : context_(context), created_(context.link != nullptr ? context.link->Now() : Seconds(0.0)) {}

void App::StartReporting(CastSettings settings) {
  settings.process = context_.name;
  settings.node = context_.Global("Community");
  settings.casts_unasked = context_.runs_live;
  if (context_.runs_live && settings.node.empty()) {
    WarnOfConfig("Community is not set: reports name no vehicle");
  }
  caster_.Configure(std::move(settings));
  SubscribeRaw("APPCAST_REQ", [this](const MessagePtr& message) {
    if (const auto* text = std::get_if<std::string>(&message->value)) {
      caster_.OnRequest(*text, now());
    }
  });
}

void App::Iterate(Seconds now) {
  ++iteration_;
  Tick(now);
  if (caster_.IsDue(now)) {
    Cast(now);
  }
}

void App::End(Seconds now) {
  Finish(now);
  if (!context_.runs_live) {
    Cast(now);
  }
}

void App::Cast(Seconds now) {
  ReportLines body;
  Report(body);
  PublishRaw("APPCAST", EncodeAppCast(caster_.Cast(body.lines(), iteration_, now)));
}

void App::ReportEvent(std::string_view text) { caster_.AddEvent(now() - created_, text); }

void App::Deliver(const MessagePtr& message) {
  const auto found = handlers_.find(message->name);
  if (found != handlers_.end()) {
    for (const Handler& handler : found->second) {
      handler(message);
    }
  }
  for (const auto& [filter, handler] : wildcard_handlers_) {
    if (MatchesWildcard(filter.variable_pattern, message->name)) {
      handler(message);
    }
  }
}

void App::AddHandler(const std::string& name, Seconds interval, Handler handler) {
  handlers_[name].push_back(std::move(handler));
  context_.link->Subscribe(name, interval);
}

void App::SubscribeRaw(const WildcardFilter& filter,
                       std::function<void(const MessagePtr&)> handler) {
  wildcard_handlers_.emplace_back(filter, std::move(handler));
  context_.link->SubscribeWildcard(filter);
}

void App::SubscribeRaw(const std::string& name, std::function<void(const MessagePtr&)> handler) {
  AddHandler(name, Seconds(0.0), std::move(handler));
}

void App::PublishRaw(std::string name, Value value, std::string source_aux) {
  context_.link->Publish(std::move(name), std::move(value), std::move(source_aux));
}

void App::Warn(const std::string& id, const std::string& text) {
  const auto [position, is_new] = warnings_.try_emplace(id, text);
  if (is_new) {
    caster_.RaiseWarning(id, text);
    ReportEvent(fmt::format("warning {}: {}", id, text));
    PublishWarnings();
  }
}

void App::ClearWarning(const std::string& id) {
  if (warnings_.erase(id) > 0) {
    caster_.ClearWarning(id);
    ReportEvent(fmt::format("cleared {}", id));
    PublishWarnings();
  }
}

void App::PublishWarnings() {
  std::string variable = context_.name + "_WARNINGS";
  std::ranges::transform(variable, variable.begin(), [](char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  });
  PublishRaw(variable, EncodeWarnings(warnings_));
}

Random App::MakeRandom(std::string_view part) const {
  return Random(MixSeed(context_.seed, context_.name + "/" + context_.session), part);
}

}  // namespace limpet
