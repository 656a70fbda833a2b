// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_domain.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

const std::vector<std::string>& DecisionVariables() {
  static const std::vector<std::string> names{"course", "speed", "depth"};
  return names;
}

/// The complaint about one line, or nothing; its name goes to `seen`.
std::optional<std::string> ReadLine(const std::string& line, MotionDomain& domain,
                                    std::vector<std::string>& seen) {
  constexpr std::int64_t kFewestPoints = 2;
  const std::vector<std::string> parts = Split(line, ':');
  const std::string name(Trim(parts[0]));
  if (std::ranges::find(DecisionVariables(), name) == DecisionVariables().end()) {
    const std::string nearest = NearestWord(name, DecisionVariables());
    return fmt::format("no decision variable `{}`; known: course, speed, depth{}", name,
                       nearest.empty() ? "" : "; did you mean `" + nearest + "`?");
  }
  if (std::ranges::find(seen, name) != seen.end()) return "`" + name + "` is given twice";
  seen.push_back(name);
  const auto number = [&parts](std::size_t i) {
    return parts.size() > i ? ParseNumber(parts[i]) : std::nullopt;
  };
  const std::optional<double> low = number(1), high = number(2);
  if (!low || !high || !number(3) || *low >= *high) {
    return fmt::format("`{}` is not allowed; allowed: name:low:high:points, low below high", line);
  }
  const std::optional<std::int64_t> points = ParseInteger(parts[3]);
  if (!points || *points < kFewestPoints) {
    return fmt::format("`{}` has {} points; allowed: a whole number, at least {}", line,
                       Trim(parts[3]), kFewestPoints);
  }
  if (name == "speed") domain.speed_low = *low, domain.speed_high = *high;
  if (name == "depth") domain.depth_low = *low, domain.depth_high = *high;
  return std::nullopt;
}

}  // namespace

std::vector<ConfigProblem> ReadMotionDomain(std::span<const ConfigEntry> lines,
                                            const SourceLine& block, MotionDomain& domain) {
  std::vector<ConfigProblem> problems;
  std::vector<std::string> seen;
  for (const ConfigEntry& line : lines) {
    if (const auto complaint = ReadLine(line.value, domain, seen)) {
      problems.push_back({line.where, "domain", *complaint});
    }
  }
  const bool is_readable = problems.empty();  // else a name that is misspelt would be missed, too
  for (const std::string& name : DecisionVariables()) {
    if (is_readable && std::ranges::find(seen, name) == seen.end()) {
      problems.push_back(
          {block, "domain", fmt::format("`{}` is missing; the helm decides on all three", name)});
    }
  }
  return problems;
}

}  // namespace limpet
