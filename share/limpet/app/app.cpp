// SPDX-License-Identifier: MIT
#include "limpet/app/app.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/core/config_entries.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

std::string AppContext::Global(std::string_view key) const {
  const ConfigEntry* global = FindEntry(globals, key);
  return global == nullptr ? "" : global->value;
}

App::App(const AppContext& context)
    : context_(context),
      warnings_(context.warp),
      stamps_(context.warp),
      created_(context.link != nullptr ? context.link->Now() : Seconds(0.0)) {}

void App::StartReporting(CastSettings settings) {
  settings.process = context_.name;
  settings.node = context_.Global("Community");
  settings.casts_unasked = context_.runs_live;
  if (context_.runs_live && settings.node.empty()) {
    WarnOfConfig("Community is not set: reports name no vehicle");
  }
  caster_.Configure(std::move(settings));
  SubscribeRaw(topics::kAppCastRequest.name, [this](const MessagePtr& message) {
    if (const auto* text = std::get_if<std::string>(&message->value)) {
      caster_.OnRequest(*text, now());
    }
  });
}

void App::Iterate(Seconds now) {
  ++iteration_;
  WatchClock();
  Tick(now);
  PublishWarnings();
  if (caster_.IsDue(now)) {
    Cast(now);
  }
}

void App::NoteJournalLost(const std::string& why) {
  Warn(warnings::kJournalLost, "a successor would begin anew: " + why);
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
  ReportRefusedStamps(body);
  PublishRaw(topics::kAppCast.name, EncodeAppCast(caster_.Cast(body.lines(), iteration_, now)));
}

bool App::HasUsableStamp(const std::string& variable, Seconds stamp, const std::string& source) {
  const Seconds at = now();
  const StampGuard::Verdict verdict = stamps_.Judge(variable, stamp, at);
  if (verdict == StampGuard::Verdict::kRefused) {
    Warn(warnings::kStampFromFuture.Of(variable),
         fmt::format("refused: {} stamped it {:.1f} s ahead of vehicle time", source,
                     (stamp - at).value()));
  } else if (verdict == StampGuard::Verdict::kGoodAgain) {
    ClearWarning(warnings::kStampFromFuture, variable);
  }
  return verdict != StampGuard::Verdict::kRefused;
}

void App::ReportRefusedStamps(ReportLines& report) const {
  for (const auto& [variable, refused] : stamps_.refused()) {
    report.Pair("Refused", fmt::format("{} of {} stamped in the future, up to {:.1f} s",
                                       refused.count, variable, refused.farthest.value()));
  }
}

/// Ours is the time of the community that this process entered first.
void App::WatchClock() {
  constexpr double kNoticed = 0.5;  // [s]
  const double ahead = context_.link->ClockDisagreement().value();
  if (std::abs(ahead) <= kNoticed) {
    ClearWarning(warnings::kClockDiffers);
  } else {
    Warn(warnings::kClockDiffers,
         fmt::format("the database's clock is {:+.1f} s off vehicle time; not followed", ahead));
  }
}

void App::ReportEvent(const EventId& event, std::string_view text) {
  caster_.AddEvent(now() - created_, fmt::format("{}: {}", event.name(), text));
}

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

void App::Warn(const WarningId& id, const std::string& text) {
  const Seconds at = now();
  const WarningBoard::Change change = warnings_.Raise(id, text, at);
  if (change == WarningBoard::Change::kNone) {
    return;
  }
  caster_.RaiseWarning(id, text, at - created_);
  if (change == WarningBoard::Change::kRaised) {
    caster_.AddEvent(at - created_,
                     fmt::format("{} {}: {}", NameOf(id.severity()), id.name(), text));
    PublishWarnings();
  }
}

void App::ClearWarning(const WarningId& id) {
  if (warnings_.Clear(id)) {
    caster_.ClearWarning(id);
    caster_.AddEvent(now() - created_, fmt::format("cleared {}", id.name()));
    PublishWarnings();
  }
}

void App::PublishWarnings() {
  if (std::optional<std::string> news = warnings_.TakeNews(now())) {
    PublishRaw(WarningsVariable(context_.name), *std::move(news));
  }
}

Random App::MakeRandom(std::string_view part) const {
  return Random(MixSeed(context_.seed, context_.name + "/" + context_.session), part);
}

}  // namespace limpet
