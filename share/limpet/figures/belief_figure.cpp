// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_symbols.hpp"
#include "limpet/figures/plot_axes.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr double kBeliefLeft = 92.0, kBeliefWidth = 798.0, kBeliefRow = 44.0, kBeliefTop = 92.0;

struct Shares {
  std::vector<double> path, confirmed, appeared, removed;
};

/// A change too small to be seen in the figure.
bool IsNearlyTheSame(const StatusPosterior& a, const StatusPosterior& b) {
  constexpr double kVisible = 0.01;
  return std::abs(a.confirmed - b.confirmed) < kVisible &&
         std::abs(a.removed - b.removed) < kVisible && std::abs(a.appeared - b.appeared) < kVisible;
}

/// Posteriors of each object over the way, as steps: each holds until the next.
std::map<int, Shares> SharesOf(const SessionRecord& record, const PoseTrack& way, double start_path,
                               double far) {
  std::map<int, Shares> shares;
  const auto add = [](Shares& to, double path, const StatusPosterior& p) {
    to.path.push_back(path);
    to.confirmed.push_back(p.confirmed);
    to.appeared.push_back(p.confirmed + p.appeared);
    to.removed.push_back(p.confirmed + p.appeared + p.removed);
  };
  std::map<int, StatusPosterior> last;
  for (const BeliefRecord& belief : record.beliefs) {
    const double path = std::clamp(way.PathAt(belief.time.value()) - start_path, 0.0, far);
    Shares& to = shares[belief.opi];
    const auto before = last.find(belief.opi);
    if (before != last.end()) {
      if (IsNearlyTheSame(before->second, belief.posterior)) continue;
      add(to, path, before->second);
    }
    add(to, path, belief.posterior);
    last[belief.opi] = belief.posterior;
  }
  for (auto& [opi, to] : shares)
    add(to, far, last[opi]);
  return shares;
}

/// Name of the true object that the belief ended on.
std::string NameOf(const FigureSource& source, int id) {
  const auto& opis = source.record.opis;
  const auto opi =
      std::find_if(opis.begin(), opis.end(), [&](const OpiBelief& o) { return o.id == id; });
  if (opi == opis.end()) return fmt::format("id {}", id);
  std::string name = fmt::format("id {}", id);
  if (!source.score.has_truth) return name;
  double nearest = 2.5;
  for (const ScenarioOpi& truth : source.scenario.opis) {
    for (const auto& [session, place] : truth.places) {
      if (!place) continue;
      const double distance = (*place - opi->object.p_W).norm();
      if (distance < nearest) nearest = distance, name = truth.name;
    }
  }
  return name;
}

void DrawRow(SvgCanvas& canvas, double top, double far, const std::string& name,
             const Shares& shares) {
  const auto at = [&](double path, double share) {
    return Point(kBeliefLeft + kBeliefWidth * path / far,
                 top + (kBeliefRow - 10.0) * (1.0 - share));
  };
  const auto fill = [&](const std::vector<double>& low, const std::vector<double>& high,
                        std::string_view color) {
    std::vector<Point> outline;
    for (std::size_t i = 0; i < shares.path.size(); ++i)
      outline.push_back(at(shares.path[i], high[i]));
    for (std::size_t i = shares.path.size(); i-- > 0;)
      outline.push_back(at(shares.path[i], low[i]));
    canvas.Polygon(outline, {.fill = color, .opacity = 0.85});
  };
  canvas.Rect(at(0.0, 1.0), {kBeliefWidth, kBeliefRow - 10.0}, {.fill = palette::kUnseen});
  const std::vector<double> zero(shares.path.size(), 0.0);
  fill(zero, shares.confirmed, palette::kGreen);
  fill(shares.confirmed, shares.appeared, palette::kBlue);
  fill(shares.appeared, shares.removed, palette::kVermillion);
  canvas.Text({kBeliefLeft - 12.0, top + 0.5 * (kBeliefRow - 10.0) + 4.0}, name,
              {.size = 12.5, .anchor = Anchor::kEnd, .is_bold = true});
}

}  // namespace

Figure BeliefFigure(const FigureSource& source) {
  const PoseTrack& way = WayOf(source);
  const double start_path = way.PathAt(SurveyStartOf(source));
  const std::vector<double>& surveyed = source.score.coverage.curve.path_m;
  const double far =
      std::max(surveyed.empty() ? way.path(way.size() - 1) - start_path : surveyed.back(), 1.0);
  const std::map<int, Shares> shares = SharesOf(source.record, way, start_path, far);
  const double height = kBeliefRow * static_cast<double>(shares.size());
  SvgCanvas canvas({kBeliefLeft + kBeliefWidth + 24.0, kBeliefTop + height + 48.0},
                   "Belief about each object");
  canvas.Text({kBeliefLeft - 26.0, 24.0}, "How sure it was about each object as it went",
              {.size = 17.0, .is_bold = true});
  canvas.Text({kBeliefLeft - 26.0, 44.0},
              RunName(source) + " \u00b7 the posterior, stacked: full height is 1",
              {.size = 12.5, .fill = palette::kMuted});
  const bool is_change = !source.score.former.empty();
  double x = kBeliefLeft;
  const auto key = [&](std::string_view color, const std::string& text, double width) {
    canvas.Rect({x, 62.0}, {14.0, 14.0}, {.fill = color, .opacity = 0.85});
    canvas.Text({x + 20.0, 73.0}, text);
    x += width;
  };
  if (is_change) key(palette::kGreen, "confirmed", 110.0);
  key(palette::kBlue, is_change ? "new" : "is there", is_change ? 80.0 : 100.0);
  if (is_change) key(palette::kVermillion, "removed", 100.0);
  key(palette::kUnseen, is_change ? "never anything" : "nothing there, or not yet met", 180.0);
  PlotAxes axes(canvas, {.corner = {kBeliefLeft, kBeliefTop},
                         .size = {kBeliefWidth, height},
                         .x = {0.0, far},
                         .y = {0.0, 1.0},
                         .x_label = "way since the survey began [m]",
                         .y_label = "",
                         .y_ticks = 0});
  double top = kBeliefTop + 4.0;
  for (const auto& [id, share] : shares) {
    DrawRow(canvas, top, far, NameOf(source, id), share);
    top += kBeliefRow;
  }
  return {source.record.name + "_belief.svg",
          "One row per object the vehicle ever considered. A row that ends in one full colour "
          "ended in a sure decision.",
          canvas.Finish()};
}

}  // namespace limpet
