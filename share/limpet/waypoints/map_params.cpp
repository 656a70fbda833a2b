// SPDX-License-Identifier: MIT
#include "limpet/waypoints/map_params.hpp"

#include <cmath>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr double kHundred = 100.0;
constexpr double kMostRepeats = 1e6;  ///< of repeats and the like

bool HasBlank(std::string_view text) { return text.find_first_of(" \t") != std::string_view::npos; }

bool ReadRepeats(std::string_view text, std::optional<int>& repeats) {
  if (EqualsIgnoringCase(text, "forever")) {
    repeats.reset();
    return true;
  }
  const auto number = ParseNumber(text);  // `2.0` is a whole number, too
  if (!number || *number != std::floor(*number) || *number < 0.0 || *number > kMostRepeats)
    return false;
  repeats = static_cast<int>(*number);
  return true;
}

/// `absolute` is the line and nothing else.
bool ReadCaptureLine(std::string_view text, CaptureRule& rule) {
  const bool is_absolute = EqualsIgnoringCase(text, "absolute");
  const auto flag = ParseFlag(text);
  if (!is_absolute && !flag) return false;
  if (is_absolute) rule.capture_radius = rule.slip_radius = 0.0;
  rule.captures_at_line = is_absolute || *flag;
  return true;
}

}  // namespace

void TakeWholePart(ParamCollector& visit) {
  visit.TakenAs("else its whole part", [](std::string_view text) -> std::optional<std::string> {
    const auto number = ParseNumber(text);
    const bool is_cut =
        number && *number >= 0.0 && *number <= kMostRepeats && *number != std::floor(*number);
    return is_cut ? std::optional(TextOf(std::floor(*number))) : std::nullopt;
  });
}

void TakeMetres(ParamCollector& visit) {
  visit.TakenAs("also with a unit, m", [](std::string_view text) -> std::optional<std::string> {
    for (const std::string_view unit : {"meters", "metres", "m"}) {
      if (!text.ends_with(unit)) continue;
      const std::string_view number = Trim(text.substr(0, text.size() - unit.size()));
      return ParseNumber(number) ? std::optional<std::string>(number) : std::nullopt;
    }
    return std::nullopt;
  });
}

void DescribeVariable(ParamCollector& visit, const char* name, std::string& field,
                      const char* help) {
  const std::string usual = field;
  visit.Parsed(name, "text", help, usual.c_str(), [&field](std::string_view text) {
    if (HasBlank(text)) return false;
    field = text;
    return true;
  });
}

void DescribeHints(ParamCollector& visit, VisualHints& hints) {
  visit.ParsedLines("visual_hints", "name=value, ...", "Colors and sizes of what it draws",
                    [&hints](std::string_view text) { return hints.Add(text); });
}

void DescribeSuffix(ParamCollector& visit, const char* name, std::string& suffix) {
  visit.Parsed(name, "text", "Added to the names of status variables, after `_`", "",
               [&suffix](std::string_view text) {
                 if (HasBlank(text)) return false;
                 suffix = text.empty() || text.front() == '_' ? std::string(text)
                                                              : "_" + std::string(text);
                 return true;
               });
}

void DescribeSummitDelta(ParamCollector& visit, double& summit_delta) {
  visit("summitdelta", summit_delta, "How far preference falls within peakwidth, of a hundred",
        InRange(0.0, kHundred));
  visit.Clipped();
}

double EdgeValue(double summit_delta) { return 1.0 - summit_delta / kHundred; }

void DescribePatience(ParamCollector& visit, double& percent) {
  visit("patience", percent,
        "Of the weight, what the course gets, of a hundred; the speed the rest",
        InRange(1.0, kHundred - 1.0));
}

void DescribeCapture(ParamCollector& visit, CaptureRule& rule) {
  visit("capture_radius", rule.capture_radius, "A point this near is reached [m]",
        InRange(0.0, 10000.0));
  visit.Also({"radius"});
  TakeMetres(visit);
  visit("slip_radius", rule.slip_radius,
        "Reached, too, when the distance grows again within this [m]", InRange(0.0, 10000.0));
  visit.Also({"nm_radius"});
  TakeMetres(visit);
  visit.Parsed("capture_line", "true, false or absolute",
               "Reached, too, beyond the line across the leg's end; absolute: only so", "false",
               [&rule](std::string_view text) { return ReadCaptureLine(text, rule); });
}

void DescribeLead(ParamCollector& visit, LeadRule& rule) {
  visit("lead", rule.lead, "Steer for a point on the leg this far ahead [m]; 0: off",
        AtLeast(-1.0));
  visit.Clipped();
  visit("lead_damper", rule.damper, "Nearer to the leg than this, further ahead [m]; 0: off",
        AtLeast(-1.0));
}

void DescribeRepeats(ParamCollector& visit, std::optional<int>& repeats) {
  visit.Parsed("repeat", "a whole number or forever", "How often again", "0",
               [&repeats](std::string_view text) { return ReadRepeats(text, repeats); });
  TakeWholePart(visit);
}

std::optional<bool> ParseIsPort(std::string_view text) {
  if (EqualsIgnoringCase(text, "port") || EqualsIgnoringCase(text, "left")) return true;
  const bool is_starboard = EqualsIgnoringCase(text, "star") ||
                            EqualsIgnoringCase(text, "starboard") ||
                            EqualsIgnoringCase(text, "right");
  return is_starboard ? std::optional(false) : std::nullopt;
}

}  // namespace limpet
