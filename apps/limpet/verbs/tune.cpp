// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/tune_command.hpp"
#include "apps/limpet/verbs/tune_form.hpp"
#include "apps/limpet/verbs/tune_live.hpp"
#include "apps/limpet/verbs/tune_resume.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/progress_line.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/runs/mission_check.hpp"
#include "limpet/sweeps/sweep.hpp"
#include "limpet/tuning/setting_diff.hpp"
#include "limpet/tuning/tuning_report.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommandFile = "command.json";
constexpr std::size_t kRowsShown = 25;

class TuneRun {
 public:
  explicit TuneRun(TuneCommand command)
      : command_(std::move(command)), default_(DefaultOf(command_)), sweep_([this] {
          command_.plan.on_progress = [this](std::size_t done, std::size_t all) {
            Progress(done, all);
          };
          return command_.plan;
        }()) {}

  void Remember(const std::vector<std::string>& words) {
    sweep_.folder().Write({{kCommandFile, nlohmann::json(words).dump(1) + "\n"}});
  }

  int Run(bool prints_json) {
    std::optional<TuningOutcome> outcome;
    if (KeysAreKnown()) {
      outcome = RunTuning(
          command_.space, default_, command_.task.rules,
          [this](const auto& contenders, const auto& flights) { return Fly(contenders, flights); });
    }
    if (!outcome) {
      fmt::print(stderr, "interrupted: `limpet tune --resume {}` goes on where it stopped\n",
                 OneLine(command_.plan.out.string()));
      return kFailed;
    }
    Tell(*outcome, prints_json);
    return kOk;
  }

 private:
  void Progress(std::size_t done, std::size_t all) {
    const std::size_t so_far = sweep_.run() + sweep_.found();
    const std::size_t most =
        std::max<std::size_t>(so_far + 1, (contenders_ + 2) * command_.task.rules.runs);
    progress_.Update(static_cast<double>(so_far) / static_cast<double>(most),
                     fmt::format("{} runs done here, {} left of this block, {} settings",
                                 sweep_.run(), all - done, contenders_));
  }

  /// Flies the default once: a slip in a key must not cost a search. False if interrupted.
  bool KeysAreKnown() {
    const auto results = sweep_.Results({{.settings = {}, .seed = command_.task.first_seed}});
    if (!results) return false;
    const ReportValues report = *ReportValues::FromJson(results->front());
    if (report.Has("failed")) {
      throw std::runtime_error("the mission as it stands leaves no report: see its run's log");
    }
    const auto check = [&report](const std::string& option, const ReportExpression& expression) {
      if (const auto problem = expression.UnknownKey(report)) {
        throw UsageError(fmt::format("{} {}", option, *problem));
      }
    };
    check("--objective", command_.objective);
    for (const ReportExpression& constraint : command_.constraints)
      check("--constraint", constraint);
    return true;
  }

  /// Whether a setting passes the checks that every survey makes before it starts; says why not.
  bool CanBeFlown(const SettingValues& values) {
    const auto known = can_be_flown_.find(values);
    if (known != can_be_flown_.end()) return known->second;
    const MissionFile mission = MissionWith(command_, command_.space.TextsOf(values));
    std::vector<ConfigProblem> problems = CheckConfiguration(mission, command_.plan.mission_folder);
    if (problems.empty()) problems = CheckGeometry(mission, command_.plan.mission_folder);
    if (!problems.empty()) {
      progress_.Note(fmt::format("{} cannot be flown: {}", ValuesText(command_.space, values),
                                 OneLine(problems.front().Format())));
    }
    return can_be_flown_[values] = problems.empty();
  }

  std::vector<RunOutcome> Fly(const std::vector<Contender>& contenders,
                              const std::vector<Flight>& flights) {
    contenders_ = std::max(contenders_, contenders.size());
    std::vector<SweepTask> tasks;
    std::vector<std::size_t> of_flight;
    for (std::size_t i = 0; i < flights.size(); ++i) {
      const Contender& contender = contenders[flights[i].contender];
      if (!contender.is_default && !CanBeFlown(contender.setting)) continue;
      tasks.push_back({.settings = contender.is_default ? std::vector<std::string>{}
                                                        : command_.space.TextsOf(contender.setting),
                       .seed = command_.task.first_seed + flights[i].seed_index});
      of_flight.push_back(i);
    }
    const auto results = sweep_.Results(tasks);
    if (!results) return {};
    std::vector<RunOutcome> outcomes(flights.size(),
                                     RunOutcome{.cost = std::nullopt, .keeps_constraints = false});
    for (std::size_t i = 0; i < results->size(); ++i)
      outcomes[of_flight[i]] = Judge((*results)[i]);
    return outcomes;
  }

  [[nodiscard]] RunOutcome Judge(const std::string& result) const {
    const Expected<ReportValues> report = ReportValues::FromJson(result);
    if (!report) throw std::runtime_error("a result on disk is damaged: " + report.error().text);
    RunOutcome outcome;
    if (const auto value = command_.objective.Evaluate(*report)) {
      outcome.cost = command_.task.maximises ? -*value : *value;
    }
    outcome.keeps_constraints =
        std::ranges::all_of(command_.constraints, [&](const ReportExpression& constraint) {
          return constraint.Evaluate(*report).value_or(0.0) != 0.0;
        });
    return outcome;
  }

  /// The settings from best to worst; eliminated ones behind the others.
  [[nodiscard]] Frame Table(const TuningOutcome& outcome) const {
    std::vector<const Contender*> order;
    for (const Contender& contender : outcome.contenders)
      order.push_back(&contender);
    const auto cost_of = [](const Contender* contender) {
      const std::vector<double> costs = contender->Costs();
      return costs.empty() ? std::numeric_limits<double>::infinity() : IntervalOf(costs).mean;
    };
    std::ranges::stable_sort(order, [&](const Contender* a, const Contender* b) {
      return a->is_in() != b->is_in() ? a->is_in() : cost_of(a) < cost_of(b);
    });
    TextTable table({"SETTING", "MEAN [95 %]", "RUNS", "FAILED", ""});
    for (std::size_t i = 0; i < std::min(order.size(), kRowsShown); ++i) {
      const Contender& each = *order[i];
      table.Add({{ValuesText(command_.space, each.setting)},
                 {IntervalText(ObjectiveOf(command_.task, each))},
                 {std::to_string(each.outcomes.size())},
                 {std::to_string(each.Failures())},
                 {each.is_default ? "the default" : each.eliminated}});
    }
    Frame lines = table.Lines();
    if (order.size() > kRowsShown) {
      lines.emplace_back().Add(
          fmt::format("... and {} more in tune.json", order.size() - kRowsShown));
    }
    return lines;
  }

  void Tell(const TuningOutcome& outcome, bool prints_json) {
    const std::string json = TuneJson(command_.task, command_.space, outcome);
    std::string text = fmt::format("{}\n", PlainText(Table(outcome)));
    if (outcome.held_out) {
      text += fmt::format("held out: default {}, {} {}\n",
                          IntervalText(ObjectiveOf(command_.task, outcome.held_out->by_default)),
                          ValuesText(command_.space, outcome.held_out->winner.setting),
                          IntervalText(ObjectiveOf(command_.task, outcome.held_out->winner)));
    }
    text += VerdictText(command_.task, command_.space, outcome) + "\n";
    SettingDiff diff;
    if (outcome.is_better) {
      const MissionFile mission = LoadMission(command_.plan.mission_folder / "mission.moos");
      diff = DiffOf(MissionReading(mission, command_.plan.mission_folder), command_.space,
                    outcome.contenders[*outcome.winner].setting);
    }
    sweep_.folder().Write({{"tune.json", json},
                           {"tune.txt", text},
                           {"tune.svg", TuneFigure(command_.task, command_.space, outcome)},
                           {"best.bhv.diff", diff.text}});
    fmt::print("{}", prints_json ? json : text);
    if (prints_json) return;
    fmt::print("\n{}: tune.json, tune.svg; {}\n", OneLine(command_.plan.out.string()),
               diff.text.empty()
                   ? std::string("best.bhv.diff is empty: the default stays")
                   : fmt::format("patch -d {} -p1 < {}", OneLine(fs::relative(diff.root).string()),
                                 OneLine((command_.plan.out / "best.bhv.diff").string())));
  }

  TuneCommand command_;
  SettingValues default_;
  std::size_t contenders_ = 1;
  ProgressLine progress_{"tune"};
  std::map<SettingValues, bool> can_be_flown_;
  Sweep sweep_;
};

/// The words that a search was asked for with, less its folder.
std::vector<std::string> Remembered(const fs::path& out) {
  const Expected<std::string> text = ReadWhole(out / kCommandFile);
  const auto words = nlohmann::json::parse(text ? *text : "", nullptr, false);
  if (!words.is_array()) {
    throw Refusal(
        fmt::format("{} holds no search that --resume can go on with", OneLine(out.string())));
  }
  return words.get<std::vector<std::string>>();
}

/// `words` without an option and its value.
std::vector<std::string> Without(const std::string& option, std::span<const std::string> words) {
  std::vector<std::string> rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option) {
      ++i;
    } else if (!words[i].starts_with(option + "=")) {
      rest.push_back(words[i]);
    }
  }
  return rest;
}

int Search(std::vector<std::string> words, const Arguments& given) {
  if (!given.Has("resume")) {
    TuneRun run(ReadTuneCommand(given));
    run.Remember(Without("--out", words));
    return run.Run(given.Has("json"));
  }
  const std::string out = *given.Find("resume");
  const std::vector<std::string> all = ResumedWords(Remembered(out), given);
  const Arguments again = ReadArguments(TuneForm(), all);
  return TuneRun(ReadTuneCommand(again)).Run(again.Has("json"));
}

}  // namespace

int RunTune(std::span<const std::string> args) {
  return RunCommand(TuneForm(), args, [&](const Arguments& given) {
    if (given.Has("live") || given.Has("undo")) return TuneLive(given);
    return Search({args.begin(), args.end()}, given);
  });
}

}  // namespace limpet
