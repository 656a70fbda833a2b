// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/change.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/session_input.hpp"
#include "limpet/comparison/object_histories.hpp"
#include "limpet/comparison/session_matches.hpp"
#include "limpet/console/arguments.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/map_files/change_files.hpp"
#include "limpet/map_files/object_files.hpp"

namespace limpet {
namespace {

constexpr char kFirstSession = 'a', kLastSession = 'h';

Command ChangeForm() {
  return {.name = "limpet change",
          .about =
              "What changed from session A to session B, from their saved frames and objects: "
              "the vehicle's own judgement, made again. Which objects of B are objects of A is "
              "what B's pNav decided when it flew with A as its former session, else what it "
              "would decide. DIR is a session's run folder or the session folder in it. Each "
              "session is judged with pMap's parameters of the mission that it kept. With more "
              "than two sessions `changes` are of the last one by the one before it alone, and "
              "`objects` tell each object's history, which csv and geojson do not have.",
          .options = {{.names = "--session-a",
                       .value = "DIR",
                       .meaning = "the earlier session",
                       .is_required = true},
                      {.names = "--session-b",
                       .value = "DIR",
                       .meaning = "the later session",
                       .is_required = true},
                      {.names = "--session-c", .value = "DIR", .meaning = "one later still"},
                      {.names = "--session-d", .value = "DIR", .meaning = "a fourth"},
                      {.names = "--session-e", .value = "DIR", .meaning = "a fifth"},
                      {.names = "--session-f", .value = "DIR", .meaning = "a sixth"},
                      {.names = "--session-g", .value = "DIR", .meaning = "a seventh"},
                      {.names = "--session-h", .value = "DIR", .meaning = "an eighth"},
                      {.names = "--mission",
                       .value = "FILE",
                       .meaning = "judge all with pMap's parameters of this .moos file instead"},
                      {.names = "--json", .meaning = "as JSON, as it is without --format"},
                      {.names = "--format",
                       .value = "FORMAT",
                       .meaning = "json; csv: a table; geojson: points on WGS84"},
                      {.names = "--out",
                       .value = "FILE",
                       .meaning = "where it goes; without: to the standard output"},
                      {.names = "--force", .meaning = "overwrites FILE"}},
          .takes = "--session-a DIR and --session-b DIR",
          .most_words = 0};
}

/// A, B, C, ... by its index in order of time.
std::string NameOfSession(std::size_t index) {
  return fmt::format("session {}", static_cast<char>('A' + static_cast<char>(index)));
}

/// The sessions in order of time. Throws UsageError if one is left out, ConfigError if one is
/// damaged.
std::vector<SavedSession> SessionsOf(const Arguments& given) {
  std::vector<SavedSession> sessions;
  std::optional<char> missing;
  for (char letter = kFirstSession; letter <= kLastSession; ++letter) {
    const std::optional<std::string> folder = given.Find(fmt::format("session-{}", letter));
    if (!folder) {
      missing = missing.value_or(letter);
      continue;
    }
    if (missing) {
      throw UsageError(fmt::format("--session-{} without --session-{}", letter, *missing));
    }
    sessions.push_back(OpenSession(*folder, NameOfSession(sessions.size())));
  }
  return sessions;
}

/// The same folder, or a copy of it.
bool AreOneSession(const SavedSession& a, const SavedSession& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a.folder, b.folder, ignored)) return true;
  return a.facts.mission == b.facts.mission && a.facts.session == b.facts.session &&
         a.facts.seed == b.facts.seed && a.facts.saved_at == b.facts.saved_at &&
         a.memory.frames.size() == b.memory.frames.size() && a.memory.map == b.memory.map &&
         a.memory.depths == b.memory.depths;
}

/// True if `later` was over before `earlier` began, or was the former session that `earlier` flew
/// with. Times alone do not tell it of simulated sessions, which all begin at one time.
bool AreInWrongOrder(const SavedSession& earlier, const SavedSession& later) {
  const std::vector<ObservedFrame>& frames = earlier.memory.frames;
  const bool is_over = !frames.empty() && Seconds(later.facts.saved_at) < frames.front().exposure;
  return is_over || WasFlownWith(earlier, later);
}

/// Throws Refusal if one was given twice. Says on stderr what is not in order of time.
void CheckOrder(const std::vector<SavedSession>& sessions) {
  for (std::size_t b = 1; b < sessions.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (AreOneSession(sessions[a], sessions[b])) {
        throw Refusal(fmt::format("{} and {} are one session: {} and {}", NameOfSession(a),
                                  NameOfSession(b), sessions[a].folder.string(),
                                  sessions[b].folder.string()));
      }
    }
    if (!AreInWrongOrder(sessions[b - 1], sessions[b])) continue;
    fmt::print(stderr,
               "note: {} was flown before {}: what changed is told from {} to {} all the same\n",
               NameOfSession(b), NameOfSession(b - 1), NameOfSession(b - 1), NameOfSession(b));
  }
}

std::string FormatOf(const Arguments& given) {
  std::string format = given.Find("format").value_or("json");
  if (format != "json" && format != "csv" && format != "geojson") {
    throw UsageError(
        fmt::format("--format: `{}` is no format; there are json, csv, geojson", format));
  }
  if (given.Has("json") && format != "json")
    throw UsageError(fmt::format("--json and --format {}: it is written in one of them", format));
  return format;
}

/// Throws Refusal where nobody knows where on earth the objects are.
std::string ComparisonText(const SessionComparison& comparison, const std::string& format) {
  if (format == "csv") return ChangesToCsv(comparison);
  const std::optional<GeoPoint> datum = DatumOf(comparison.b);
  if (!datum) {
    throw Refusal(
        "the later session's mission said no LatOrigin and LongOrigin: nobody knows "
        "where on earth its objects are; csv has them in metres");
  }
  return ChangesToGeoJson(comparison, *datum);
}

int PrintComparison(const Arguments& given) {
  const std::string format = FormatOf(given);
  const std::vector<SavedSession> sessions = SessionsOf(given);
  CheckOrder(sessions);
  const std::optional<std::string> mission = given.Find("mission");
  std::string text;
  if (sessions.size() > 2) {
    const SessionSeries series = CompareSeries(sessions, mission);
    if (format != "json") {
      fmt::print(stderr,
                 "note: {} has the last step alone, {} to {}; each object's history is in json\n",
                 format, NameOfSession(sessions.size() - 2), NameOfSession(sessions.size() - 1));
    }
    text = format == "json" ? Json(series) : ComparisonText(series.steps.back(), format);
  } else {
    const SessionComparison comparison = CompareSessions(sessions[0], sessions[1], mission);
    text = format == "json" ? Json(comparison) : ComparisonText(comparison, format);
  }
  CommandOutput output(given.Find("out"), given.Has("force"), *given.Find("session-b"));
  output.Write(text);
  output.Commit();
  return kOk;
}

}  // namespace

int RunChange(std::span<const std::string> args) {
  return RunCommand(ChangeForm(), args, PrintComparison);
}

}  // namespace limpet
