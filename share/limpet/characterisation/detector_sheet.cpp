// SPDX-License-Identifier: MIT
#include "limpet/characterisation/detector_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "limpet/mission/detector_settings.hpp"

namespace limpet {
namespace {

/// Looks at things, and those of them in which the thing was found.
struct Count {
  int all = 0;
  int found = 0;

  /// Too few looks say nothing of a share.
  [[nodiscard]] bool is_few() const { return all < 5; }
};

template <class Keep>
Count CountOf(const TrialResult& trial, const Keep& keep) {
  Count count;
  for (const TrialLook& look : trial.looks) {
    if (!keep(look)) continue;
    ++count.all;
    count.found += look.found ? 1 : 0;
  }
  return count;
}

/// Found of all, as "0.97 of 123"; "-" where too few were there.
std::string ShareText(const Count& count) {
  if (count.is_few()) return "-";
  return fmt::format("{:.2f} of {}", static_cast<double>(count.found) / count.all, count.all);
}

template <class Keep>
std::string ShareText(const TrialResult& trial, const Keep& keep) {
  return ShareText(CountOf(trial, keep));
}

bool IsBall(const TrialLook& look) { return look.kind == SolidKind::kSphere; }
bool IsShown(const TrialLook& look) { return look.visible_fraction > 0.6; }

constexpr std::array kShares{0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5};  ///< range over visibility
constexpr std::array kSizes{0.0, 14.0, 20.0, 30.0, 60.0, 1000.0};    ///< in the image [px]

/// Balls that were shown, from index `r` of kShares and `s` of kSizes on to the next.
Count BallsIn(const TrialResult& trial, std::size_t r, std::size_t s) {
  return CountOf(trial, [r, s](const TrialLook& look) {
    return IsBall(look) && IsShown(look) && look.range_share() >= kShares[r] &&
           look.range_share() < kShares[r + 1] && look.size_px >= kSizes[s] &&
           look.size_px < kSizes[s + 1];
  });
}

/// Rows: range over visibility; columns: diameter in the image.
std::string ByRangeAndSize(const TrialResult& trial) {
  std::string text = "# found, by range over visibility (down) and diameter in the image [px]\n#";
  text += fmt::format("{:>12}", "");
  for (std::size_t s = 0; s + 1 < kSizes.size(); ++s)
    text += fmt::format("{:>14}", fmt::format("{:g} to {:g}", kSizes[s], kSizes[s + 1]));
  for (std::size_t r = 0; r + 1 < kShares.size(); ++r) {
    text += fmt::format("\n#{:>12}", fmt::format("{:g} to {:g}", kShares[r], kShares[r + 1]));
    for (std::size_t s = 0; s + 1 < kSizes.size(); ++s)
      text += fmt::format("{:>14}", ShareText(BallsIn(trial, r, s)));
  }
  return text + "\n";
}

std::string ByColorAndKind(const TrialResult& trial) {
  std::set<std::string> colors;
  for (const TrialLook& look : trial.looks)
    colors.insert(look.color);
  const auto is_clear = [](const TrialLook& look) {
    return IsShown(look) && look.range_share() < 0.75 && look.size_px > 30.0;
  };
  std::string text = "# found of clear balls, by colour:";
  for (const std::string& color : colors) {
    text += fmt::format(" {} {};", color, ShareText(trial, [&](const TrialLook& look) {
                          return IsBall(look) && is_clear(look) && look.color == color;
                        }));
  }
  text += "\n# taken for a ball, of clear things of other forms:";
  for (const std::string& name : SolidKindNames()) {
    const SolidKind kind = *SolidKindOf(name);
    if (kind == SolidKind::kSphere) continue;
    text += fmt::format(" {} {};", name, ShareText(trial, [&](const TrialLook& look) {
                          return look.kind == kind && is_clear(look);
                        }));
  }
  return text + "\n";
}

/// `key: value  # meaning` under the file's key for the parameter `name` of `app`; nothing for a
/// parameter that such a file does not say, as the visibility.
std::string Line(std::string_view app, std::string_view name, double value,
                 std::string_view meaning) {
  const FactSource source = FactFor(app, name);
  if (source.kind != &DetectorFacts()) return "";
  const std::string_view key = source.fact.substr(source.fact.find('.') + 1);
  return fmt::format("  {}: {:.4g}  # {}\n", key, value, meaning);
}

/// A line for each parameter that a Describe declares to `app`.
class ParameterLines {
 public:
  explicit ParameterLines(std::string_view app) : app_(app) {}
  void operator()(const char* name, double& field, const char* help, const Range<double>&) {
    text += Line(app_, name, field, help);
  }
  void operator()(const char* name, Meters& field, const char* help, const Range<Meters>&) {
    text += Line(app_, name, field.value(), help);
  }
  std::string text;

 private:
  std::string_view app_;
};

template <class Described>
std::string LinesOf(std::string_view app, Described described) {
  ParameterLines lines(app);
  described.Describe(lines);
  return lines.text;
}

std::string Believed(const DetectionSheet& sheet) {
  return LinesOf("pMap", sheet.detection) +
         Line("pNav", "wrong_color_share", sheet.wrong_color,
              "Share of boxes with a colour not the object's") +
         Line("pNav", "match_color_penalty", sheet.color_penalty,
              "Squared sigmas that another colour costs between sessions");
}

}  // namespace

std::optional<std::string> TooFewBalls(const TrialResult& trial) {
  constexpr int kLeastBalls = 30;
  constexpr std::size_t kCells = (kShares.size() - 1) * (kSizes.size() - 1);
  std::size_t filled = 0;
  int found = 0;
  for (std::size_t r = 0; r + 1 < kShares.size(); ++r) {
    for (std::size_t s = 0; s + 1 < kSizes.size(); ++s) {
      const Count balls = BallsIn(trial, r, s);
      filled += balls.is_few() ? 0U : 1U;
      found += balls.found;
    }
  }
  if (found >= kLeastBalls && 3 * filled >= kCells) return std::nullopt;
  return fmt::format(
      "{} balls were found, and {} of {} cells of range and size had five or more to find: there "
      "is no model of the detector in less than {} balls and a third of the cells; use more "
      "--worlds\n{}",
      found, filled, kCells, kLeastBalls, ByRangeAndSize(trial));
}

std::string DetectorSheetText(const SheetOrigin& origin, const TrialResult& trial) {
  const BoxModelConstants boxes = FitBoxModel(trial);
  const double false_boxes = static_cast<double>(trial.false_boxes) / std::max(1, trial.pictures);
  return fmt::format(
      "# What the detector `{0}` finds, measured on {1} rendered pictures of balls among other\n"
      "# things (docs/detectors.md). A mission names this file: DetectorFile = {8}\n"
      "# Made by: {2}\n"
      "#\n{3}{4}# boxes at nothing that was put there: {5:.4f} per picture\n\n"
      "detector:\n  name: {0}\n\n"
      "# What the vehicle believes: as measured, with a margin.\n"
      "believed:\n{6}\n"
      "# What a simulated camera that makes boxes draws from.\n"
      "boxes:\n{7}",
      origin.detector, trial.pictures, origin.made_with, ByRangeAndSize(trial),
      ByColorAndKind(trial), false_boxes, Believed(SheetOf(boxes, trial)),
      LinesOf("uSimCamera", boxes), origin.file);
}

}  // namespace limpet
