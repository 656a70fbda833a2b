// SPDX-License-Identifier: MIT
#include "limpet/mission/expectations.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/source_text.hpp"
#include "limpet/mission/yaml_reader.hpp"

namespace limpet {
namespace {

constexpr const char* kName = "expect";

using internal::YamlReader;

/// `{min: a, max: b}`, one of them or both.
ExpectedBound ReadBound(YamlReader& in, const YAML::Node& node, const std::string& path,
                        const std::string& key, const std::string& file) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kLargest = 1e9;
  double low = kNone, high = kNone;
  in.ReadMap(node, path,
             {in.Number(path, "min", low, InRange(-kLargest, kLargest)),
              in.Number(path, "max", high, InRange(-kLargest, kLargest))});
  if (node.IsMap() && node.size() == 0) {
    in.Complain(node, path, "needs a min or a max");
  }
  if (low > high) {
    in.Complain(node, path, fmt::format("min {} is above max {}", low, high));
  }
  const auto given = [](double value) {
    return value == value ? std::optional<double>(value) : std::nullopt;
  };
  return {.key = key,
          .min = given(low),
          .max = given(high),
          .where = {.file = file, .line = node.Mark().line + 1}};
}

SessionExpectation ReadSession(YamlReader& in, const YAML::Node& node, const std::string& session,
                               const std::string& file) {
  SessionExpectation expected{.session = session, .ended = {}, .bounds = {}};
  std::string ended;
  std::vector<YamlReader::Field> fields{
      in.Choice(session, "ended", ended, {"home", "aborted", "timeout", "lost"})};
  for (const std::string& key : ExpectableNumbers()) {
    fields.push_back({key, [&in, &expected, &session, &file, key](const YAML::Node& bound) {
                        expected.bounds.push_back(
                            ReadBound(in, bound, fmt::format("{}.{}", session, key), key, file));
                      }});
  }
  in.ReadMap(node, session, fields);
  if (!ended.empty()) expected.ended = ended;
  return expected;
}

Expectations ReadExpectations(YamlReader& in, const YAML::Node& root, const std::string& file,
                              const std::vector<std::string>& sessions) {
  Expectations expected;
  std::vector<YamlReader::Field> fields{
      in.Number("", "share_of_runs", expected.share_of_runs, InRange(0.0, 1.0)),
      in.Choice("", "planner", expected.planner, {"limpet", "lawnmower", "paper"})};
  const auto add = [&](const std::string& session) {
    fields.push_back({session, [&in, &expected, &file, session](const YAML::Node& node) {
                        expected.sessions.push_back(ReadSession(in, node, session, file));
                      }});
  };
  add("each");
  std::ranges::for_each(sessions, add);
  in.ReadMap(root, "", fields);
  return expected;
}

}  // namespace

const std::vector<std::string>& ExpectableNumbers() {
  static const std::vector<std::string> keys{"covered",
                                             "detected_band",
                                             "coverage_90_path_m",
                                             "coverage_95_path_m",
                                             "detectable_95_path_m",
                                             "detectable_99_path_m",
                                             "prior_opis_seen_path_m",
                                             "path_m",
                                             "duration_s",
                                             "realtime_factor",
                                             "home_error_m",
                                             "outside_region_m",
                                             "inside_zone_m",
                                             "obstacle_distance_m",
                                             "missed",
                                             "invented",
                                             "wrong_statuses",
                                             "wrong_when_sure",
                                             "error_m",
                                             "aligned_error_m",
                                             "position_rmse_m",
                                             "aligned_rmse_m",
                                             "final_error_m",
                                             "nees_mean"};
  return keys;
}

Expectations ParseExpectations(const std::string& text, const std::string& file,
                               const std::vector<std::string>& sessions) {
  YamlReader in(file);
  Expectations expected;
  in.ReadDocument(
      text, [&](const YAML::Node& root) { expected = ReadExpectations(in, root, file, sessions); });
  return expected;
}

std::optional<Expectations> LoadExpectations(const std::filesystem::path& folder,
                                             const Scenario& scenario, const std::string& vehicle) {
  const std::string kind = std::filesystem::path(vehicle).stem().string();
  std::filesystem::path file = folder / fmt::format("{}.{}.yaml", kName, kind);
  if (kind.empty() || !std::filesystem::exists(file)) file = folder / fmt::format("{}.yaml", kName);
  if (!std::filesystem::exists(file)) return std::nullopt;
  std::set<std::string> sessions{"discovery", "change"};
  for (const std::string& session : SessionsOf(scenario)) {
    sessions.insert(session);
  }
  Expectations expected =
      ParseExpectations(ReadTextFile(file), file.string(), {sessions.begin(), sessions.end()});
  expected.file = file.filename().string();
  return expected;
}

bool IsExpectationsFile(const std::filesystem::path& name) {
  return name.extension() == ".yaml" &&
         (name.stem() == kName || name.string().starts_with(fmt::format("{}.", kName)));
}

}  // namespace limpet
