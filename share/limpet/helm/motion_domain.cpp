// SPDX-License-Identifier: MIT
#include "limpet/helm/motion_domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "limpet/core/expected.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

constexpr std::int64_t kFewestPoints = 2;  ///< where the ends are two values
constexpr std::int64_t kMostPoints = 100000;

std::vector<std::string> VariableNames() {
  std::vector<std::string> names;
  for (const MotionVariable variable : kMotionVariables) {
    names.emplace_back(NameOf(variable));
  }
  return names;
}

/// Parts of one line, the blanks gone; `depth:0:100:101:optional` or `depth,0,100,101`.
std::vector<std::string> PartsOf(std::string line) {
  std::ranges::replace(line, ',', ':');
  std::vector<std::string> parts;
  for (const std::string& part : Split(line, ':')) {
    parts.emplace_back(Trim(part));
  }
  return parts;
}

/// The step of `delta=0.1`.
std::optional<double> DeltaOf(std::string text) {
  constexpr std::string_view kDelta = "delta=";
  std::erase(text, ' ');
  if (!EqualsIgnoringCase(std::string_view(text).substr(0, kDelta.size()), kDelta)) {
    return std::nullopt;
  }
  return ParseNumber(std::string_view(text).substr(kDelta.size()));
}

/// Number of points that fit; nothing if the text is neither a number of them nor a step.
std::optional<std::int64_t> PointsOf(const std::string& text, double low, double high) {
  if (text.find('=') == std::string::npos) return ParseInteger(text);
  constexpr double kRounding = 1e-9;
  const std::optional<double> delta = DeltaOf(text);
  if (!delta || !(*delta > 0.0)) return std::nullopt;
  const double steps = (high - low) / *delta;
  if (steps > static_cast<double>(kMostPoints)) return std::nullopt;
  return static_cast<std::int64_t>(std::floor(steps + kRounding)) + 1;
}

/// Whether the last part of a line says `optional`. MOOS-IvP takes any other word for its contrary;
/// a slip of the pen is refused.
Expected<bool> IsOptional(const std::vector<std::string>& parts) {
  if (parts.size() < 5) return false;
  if (EqualsIgnoringCase(parts[4], "optional")) return true;
  if (NearestWord(parts[4], {"optional"}).empty()) return false;
  return Error{fmt::format("`{}` is not allowed at the end; did you mean `optional`?", parts[4])};
}

/// How many points the range of a line has: one where its ends are the same.
Expected<int> PointCountOf(const std::string& line, const std::string& text, double low,
                           double high) {
  const std::int64_t fewest = low < high ? kFewestPoints : 1;
  const std::int64_t most = low < high ? kMostPoints : 1;
  const std::optional<std::int64_t> points = PointsOf(text, low, high);
  if (points && *points >= fewest && *points <= most) return static_cast<int>(*points);
  return Error{fmt::format("`{}` has {} points; allowed: {}", line, text,
                           low < high ? fmt::format("a whole number, at least {}", kFewestPoints)
                                      : "1, where low is high")};
}

/// The range of a line as it is written: courses in degrees.
Expected<MotionAxis> AxisOf(const std::string& line, const std::vector<std::string>& parts) {
  const auto number = [&parts](std::size_t i) {
    return parts.size() > i ? ParseNumber(parts[i]) : std::nullopt;
  };
  const std::optional<double> low = number(1), high = number(2);
  const bool has_form = parts.size() == 4 || parts.size() == 5;
  const bool has_points = has_form && (number(3) || DeltaOf(parts[3]));
  // Courses close in a circle, of which one point is none.
  const bool may_be_one = !EqualsIgnoringCase(parts[0], NameOf(MotionVariable::kCourse));
  if (!low || !high || !has_points || *low > *high || (*low == *high && !may_be_one)) {
    return Error{fmt::format(
        "`{}` is not allowed; allowed: name:low:high:points[:optional], low below high{}", line,
        may_be_one ? ", or the same with 1 point" : "")};
  }
  const Expected<bool> is_optional = IsOptional(parts);
  if (!is_optional) return is_optional.error();
  const Expected<int> points = PointCountOf(line, parts[3], *low, *high);
  if (!points) return points.error();
  MotionAxis axis{.low = *low, .high = *high, .points = *points, .is_optional = *is_optional};
  if (const std::optional<double> delta = DeltaOf(parts[3])) {
    axis.high = axis.low + (axis.points - 1) * *delta;  // the last point that fits
  }
  return axis;
}

MotionAxis InRadians(MotionAxis axis) {
  axis.low = RadiansFromDegrees(axis.low);
  axis.high = RadiansFromDegrees(axis.high);
  return axis;
}

/// The complaint about one line, or nothing.
std::optional<std::string> ReadLine(const std::string& line, MotionDomain& domain) {
  const std::vector<std::string> names = VariableNames();
  const std::vector<std::string> parts = PartsOf(line);
  const std::string& name = parts[0];
  const auto known = std::ranges::find_if(
      names, [&name](const std::string& other) { return EqualsIgnoringCase(other, name); });
  if (known == names.end()) {
    const std::string nearest = NearestWord(name, names);
    return fmt::format("no decision variable `{}`; known: course, speed, depth{}", name,
                       nearest.empty() ? "" : "; did you mean `" + nearest + "`?");
  }
  const std::array axes{&domain.course, &domain.speed, &domain.depth};
  const auto index = static_cast<std::size_t>(known - names.begin());
  std::optional<MotionAxis>& own = *axes.at(index);
  if (own) return "`" + *known + "` is given twice";
  const Expected<MotionAxis> axis = AxisOf(line, parts);
  if (!axis) return axis.error().text;
  own = index == IndexOf(MotionVariable::kCourse) ? InRadians(*axis) : *axis;
  return std::nullopt;
}

}  // namespace

const char* NameOf(MotionVariable variable) {
  static constexpr std::array kNames{"course", "speed", "depth"};
  return kNames.at(IndexOf(variable));
}

const std::optional<MotionAxis>& MotionDomain::axis(MotionVariable variable) const {
  return variable == MotionVariable::kCourse  ? course
         : variable == MotionVariable::kSpeed ? speed
                                              : depth;
}

int MotionDomain::points(MotionVariable variable) const {
  const std::optional<MotionAxis>& of = axis(variable);
  return of ? of->points : 1;
}

std::vector<ConfigProblem> ReadMotionDomain(std::span<const ConfigEntry> lines,
                                            const SourceLine& block, MotionDomain& domain) {
  std::vector<ConfigProblem> problems;
  MotionDomain read{.course = {}, .speed = {}, .depth = {}};
  for (const ConfigEntry& line : lines) {
    if (const auto complaint = ReadLine(line.value, read)) {
      problems.push_back({line.where, "domain", *complaint});
    }
  }
  const bool is_readable = problems.empty();  // else a name that is misspelt would be missed, too
  for (const MotionVariable variable : {MotionVariable::kCourse, MotionVariable::kSpeed}) {
    if (is_readable && !read.axis(variable)) {
      problems.push_back({block, "domain",
                          fmt::format("`{}` is missing; the helm decides on course and speed, and "
                                      "on depth if there is a line for it",
                                      NameOf(variable))});
    }
  }
  if (problems.empty()) domain = read;
  return problems;
}

std::string MotionDomainText(std::span<const std::string> lines) {
  std::string text;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    std::vector<std::string> parts = PartsOf(*line);
    const Expected<MotionAxis> axis = AxisOf(*line, parts);
    if (!axis) continue;  // refused where the domain is read
    text += fmt::format("{}{},{:g},{:g},{}", text.empty() ? "" : ":", parts[0], axis->low,
                        axis->high, axis->points);
  }
  return text;
}

}  // namespace limpet
