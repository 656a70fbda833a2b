// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/why.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/why_source.hpp"
#include "limpet/console/community.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/explain/decision_log.hpp"
#include "limpet/explain/explanation_json.hpp"
#include "limpet/explain/explanation_text.hpp"
#include "limpet/explain/motion_explanation.hpp"

namespace limpet {
namespace {

Command WhyForm() {
  const ValueRule kTime = AnyNumber("seconds since the start of the log");
  return {
      .name = "limpet why",
      .words = "<run | log.alog | mission.moos>",
      .about = R"(Why the helm goes where it goes: the decision in force, with every option
that was offered, what each behavior bid on it, why it lost, and for each behavior the smallest
change of its weight that would have led elsewhere.

  limpet why runs/table1-1 --changes    every decision, in a line
  limpet why runs/table1-1 --at 545     what was in force then
  limpet why missions/table1            of the community that flies it now)",
      .options = WithAddressOptions(
          {{.names = "--at", .value = "T", .meaning = "the decision in force then", .rule = kTime},
           {.names = "--last", .meaning = "the last decision (the default)"},
           {.names = "--from",
            .value = "A",
            .meaning = "every decision from then on",
            .rule = kTime},
           {.names = "--to", .value = "B", .meaning = "every decision until then", .rule = kTime},
           {.names = "--changes", .meaning = "a line for each decision"},
           {.names = "--session",
            .value = "NAME",
            .meaning = "of a run of several sessions (default: the last)",
            .rule = NotEmpty("a session's name")},
           {.names = "--json", .meaning = "as JSON; a list with --from, --to or --changes"}}),
      .more = R"(Times are seconds since the start of the log; of a live community, MOOS time. The
worth of an option is the sum of bids times weights, in metres of path (nats with the paper's
planner); the best per metre wins. Of a vehicle without a survey it says who wants which course,
speed and depth, and with --from, --to or --changes each time that changes, and why. While the helm
is parked or has stopped all, it says since when and for what. Exit code 1 if there is no such
decision.)",
      .takes = "one run folder, one log, or one mission",
      .least_words = 1,
      .most_words = 1};
}

/// Those of `timed` at which --from and --to let look.
template <class Timed>
std::vector<Timed> Between(const std::vector<Timed>& timed, const Arguments& given) {
  std::vector<Timed> chosen;
  std::ranges::copy_if(timed, std::back_inserter(chosen), [&](const Timed& one) {
    return one.time >= given.Number("from").value_or(one.time) &&
           one.time <= given.Number("to").value_or(one.time);
  });
  return chosen;
}

/// Decisions, and where the helm stopped and went on, in order of time.
std::vector<Explanation> ExplainAll(const std::vector<LoggedDecision>& decisions,
                                    const std::vector<MotionChange>& stops,
                                    const DecisionLog& log) {
  std::vector<Explanation> explanations;
  std::ranges::transform(stops, std::back_inserter(explanations), ExplainChange);
  std::ranges::transform(decisions, std::back_inserter(explanations), [&log](const auto& decision) {
    return Explain(decision, log.MotionAt(decision.time));
  });
  std::ranges::stable_sort(explanations, {}, &Explanation::time);
  for (Explanation& explanation : explanations)
    explanation.waiting = log.WaitingAt(explanation.time);
  return explanations;
}

/// Without a table of options there is how it moved.
Frame ShownFrame(const Explanation& explanation) {
  const bool is_motion_only = explanation.options.empty() && explanation.path_id == 0;
  return is_motion_only ? FrameOfMotion(explanation) : FrameOf(explanation);
}

int Complain(const std::string& text) {
  fmt::print(stderr, "limpet why: {}\n", OneLine(text));
  return kFailed;
}

int PrintMany(const WhySource& source, const Arguments& given) {
  const std::vector<LoggedDecision> decisions = Between(source.log.decisions(), given);
  const std::vector<MotionChange> stops = Between(StopsOf(source.log), given);
  if (decisions.empty() && stops.empty()) {
    return Complain(source.place + ": no decision in that time");
  }
  if (given.Has("json")) {
    fmt::print("{}", JsonOf(ExplainAll(decisions, stops, source.log), source.session));
  } else if (given.Has("changes")) {
    PrintFrame(ChangesOf(decisions, stops));
  } else {
    for (const Explanation& explanation : ExplainAll(decisions, stops, source.log)) {
      PrintFrame(ShownFrame(explanation));
      fmt::print("\n");
    }
  }
  return kOk;
}

int PrintOne(const WhySource& source, const Arguments& given) {
  const auto& decisions = source.log.decisions();
  const std::optional<double> time = given.Number("at");
  const LoggedDecision* decision = time ? source.log.InForceAt(*time) : &decisions.back();
  if (decision == nullptr) {
    return Complain(fmt::format("{}: no decision yet at {:g} s; the first was at {:.1f} s",
                                source.place, *time, decisions.front().time));
  }
  const double asked = time.value_or(std::numeric_limits<double>::infinity());
  Explanation explanation = Explain(*decision, source.log.MotionAt(asked));
  explanation.waiting = source.log.WaitingAt(asked);
  if (given.Has("json")) {
    fmt::print("{}", JsonOf(explanation, source.session));
  } else {
    PrintFrame(FrameOf(explanation));
  }
  return kOk;
}

/// Changes of the time asked for, and what was in force as that began.
std::vector<MotionChange> ChangesAskedFor(const DecisionLog& log, const Arguments& given) {
  const std::vector<MotionChange> all = ChangesOfMotion(log);
  std::vector<MotionChange> chosen = Between(all, given);
  const std::optional<double> from = given.Number("from");
  if (!from) return chosen;
  const auto later = std::ranges::upper_bound(all, *from, {}, &MotionChange::time);
  std::optional<LoggedMotion> motion = log.MotionAt(*from);
  if (later == all.begin() || !motion || (!chosen.empty() && chosen.front().time == *from)) {
    return chosen;
  }
  const MotionChange& last = *std::prev(later);
  chosen.insert(chosen.begin(),
                {.time = *from,
                 .cause = fmt::format("as since {:.1f} s: {}", last.time, last.cause),
                 .motion = *std::move(motion)});
  return chosen;
}

int PrintMotions(const WhySource& source, const Arguments& given) {
  const std::vector<MotionChange> changes = ChangesAskedFor(source.log, given);
  if (changes.empty()) return Complain(source.place + ": the helm says nothing in that time");
  if (given.Has("json")) {
    std::vector<Explanation> explanations;
    std::ranges::transform(changes, std::back_inserter(explanations), [&](const auto& change) {
      Explanation explanation = ExplainChange(change);
      explanation.waiting = source.log.WaitingAt(change.time);
      return explanation;
    });
    fmt::print("{}", JsonOf(explanations, source.session));
  } else {
    PrintFrame(FrameOfMotions(changes));
  }
  return kOk;
}

/// Where no behavior decides where next, how it moves is all there is to say.
int PrintMotion(const WhySource& source, const Arguments& given) {
  const std::optional<double> time = given.Number("at");
  const std::optional<LoggedMotion> motion =
      source.log.MotionAt(time.value_or(std::numeric_limits<double>::infinity()));
  if (!motion) {
    return Complain(fmt::format("{}: the helm says nothing yet at {:g} s; first at {:.1f} s",
                                source.place, *time, source.log.motions().front().time));
  }
  Explanation explanation = ExplainMotion(*motion);
  explanation.waiting =
      source.log.WaitingAt(time.value_or(std::numeric_limits<double>::infinity()));
  if (given.Has("json")) {
    fmt::print("{}", JsonOf(explanation, source.session));
  } else {
    PrintFrame(FrameOfMotion(explanation));
  }
  return kOk;
}

void CheckTimes(const Arguments& given) {
  const bool has_range = given.Has("from") || given.Has("to") || given.Has("changes");
  if (given.Has("at") && (has_range || given.Has("last"))) {
    throw UsageError("--at is one decision: it goes with none of --last, --from, --to, --changes");
  }
  if (given.Has("last") && has_range) {
    throw UsageError("--last is one decision: it goes with none of --from, --to, --changes");
  }
  const std::optional<double> from = given.Number("from"), to = given.Number("to");
  if (from && to && *from > *to) {
    throw UsageError(fmt::format("--from {:g} is after --to {:g}", *from, *to));
  }
}

int PrintWhy(const Arguments& given) {
  CheckTimes(given);
  const WhySource source = WhySourceOf(given);
  if (source.log.unreadable() > 0) {
    fmt::print(stderr,
               "limpet why: {}: {} HELM_BIDS or HELM_MOTION cannot be read and are left out\n",
               OneLine(source.place), source.log.unreadable());
  }
  const bool is_survey = !source.log.decisions().empty();
  if (!is_survey && source.log.motions().empty()) {
    std::string text = source.place + ": no decision of the helm: no HELM_BIDS, no HELM_MOTION";
    if (!source.log.stops().empty() && !source.log.stops().back().end) {
      const HelmStop& stop = source.log.stops().back();
      text += fmt::format("; it is stopped since {:.1f} s: {}", stop.begin, stop.why);
    }
    return Complain(text);
  }
  if (!source.session.empty() && !given.Has("json")) {
    fmt::print("session {}\n\n", OneLine(source.session));
  }
  const bool wants_many = given.Has("from") || given.Has("to") || given.Has("changes");
  if (is_survey) return wants_many ? PrintMany(source, given) : PrintOne(source, given);
  return wants_many ? PrintMotions(source, given) : PrintMotion(source, given);
}

}  // namespace

int RunWhy(std::span<const std::string> args) { return RunCommand(WhyForm(), args, PrintWhy); }

}  // namespace limpet
