// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune_form.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "apps/limpet/verbs/survey_options.hpp"
#include "limpet/console/community.hpp"
#include "limpet/sweeps/task_runner.hpp"

namespace limpet {
namespace {

std::vector<CommandOption> SearchOptions() {
  return {
      {.names = "--vary",
       .value = "OWNER.KEY=LO:HI[:N]",
       .meaning = "a parameter of a behavior, by its name, or of an app, and its range; N: only "
                  "that many even steps",
       .is_repeatable = true},
      {.names = "--objective",
       .value = "EXPRESSION",
       .meaning = "what is to be least, in keys of report.json: "
                  "\"sessions.discovery.path_m\"; + - * / ^, min, max, abs, sqrt"},
      {.names = "--maximise", .meaning = "what is to be greatest"},
      {.names = "--constraint",
       .value = "EXPRESSION",
       .meaning = "must hold: \"sessions.discovery.covered >= 0.95\"; < <= > >= == != and or "
                  "not",
       .is_repeatable = true},
      {.names = "--share",
       .value = "S",
       .meaning = "share of a setting's runs in which every constraint must hold",
       .fallback = "0.9",
       .rule = NumberBetween(0.0, 1.0)},
      {.names = "--method",
       .value = "M",
       .meaning = "grid: every combination; random: a Latin hypercube; bayes: where a Gaussian "
                  "process expects most",
       .fallback = "grid",
       .rule = OneOf({"grid", "random", "bayes"})},
      {.names = "--settings",
       .value = "K",
       .meaning = "how many settings random and bayes try",
       .fallback = "20",
       .rule = WholeNumber(1, 10000)},
      {.names = "--runs",
       .value = "N",
       .meaning = "seeds of each setting; as many others judge the best one",
       .fallback = "10",
       .rule = WholeNumber(2, 100000)},
      {.names = "--seed",
       .value = "N",
       .meaning = "first seed",
       .fallback = "1",
       .rule = WholeNumber(0)},
      {.names = "--out",
       .value = "DIR",
       .meaning = "folder of the search (default runs/tune-<mission>)",
       .rule = NotEmpty("a folder")},
      {.names = "--resume",
       .value = "DIR",
       .meaning = "go on with the search of that folder, as it was asked for",
       .rule = NotEmpty("a folder")},
      {.names = "--keep-runs", .meaning = "keep logs and maps of every run (some 400 MB each)"},
      {.names = "--json", .meaning = "print tune.json instead of the table"},
      {.names = "--live",
       .meaning = "set one parameter of a behavior in a running community: limpet tune --live "
                  "<mission.moos> behavior.key=value"},
      {.names = "--undo", .meaning = "with --live: take back what --live set last"}};
}

}  // namespace

Command TuneForm() {
  Command form{
      .name = "limpet tune",
      .words = "<mission folder>",
      .about =
          "Looks for the setting of a mission that makes the objective least. All settings, the "
          "mission as it stands (the default) among them, fly the same seeds; after every block "
          "of seeds those that are surely worse than the leader are eliminated (one-sided paired "
          "t-test, 5 % shared out over the settings). The default, and the best beside it, then "
          "fly "
          "seeds that the search has not seen; their paired difference is what counts. Means come "
          "with "
          "95 % intervals by Student's t.\n\nLeaves <out>/tune.json, tune.txt, tune.svg and "
          "best.bhv.diff, for `patch`. A run is never done twice: after an interruption --resume, "
          "or the same command, goes on.",
      .options = SearchOptions(),
      .more = R"(  limpet tune missions/table1 --vary cover.frontier_weight=0:1.5:4 \
    --set uSimCamera.camera=boxes --objective sessions.discovery.path_m \
    --constraint "sessions.discovery.missed.count == 0")",
      .takes = "one mission folder, e.g. missions/table1",
      .most_words = 2};
  std::ranges::move(RunnerCommandOptions(), std::back_inserter(form.options));
  std::ranges::move(SurveyMethodOptions(), std::back_inserter(form.options));
  form.options = WithAddressOptions(std::move(form.options));
  return form;
}

}  // namespace limpet
