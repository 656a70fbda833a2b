// SPDX-License-Identifier: MIT
#include "limpet/map_files/map_diff_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/comparison/session_comparison.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/map_files/map_diff.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct MapDiff {
  SessionComparison objects;
  DepthDifference depth;
};

Expected<DepthGrid> DepthsOf(const SavedSession& session) {
  Expected<DepthGrid> depths = DepthGridOf(session.memory);
  if (!depths) return Error{session.folder.string() + ": " + depths.error().text};
  return depths;
}

Expected<MapDiff> DiffOf(const SavedSession& a, const SavedSession& b) {
  const Expected<DepthGrid> depths_a = DepthsOf(a), depths_b = DepthsOf(b);
  if (!depths_a) return depths_a.error();
  if (!depths_b) return depths_b.error();
  MapDiff diff{.objects = CompareSessions(a, b), .depth = {}};
  diff.depth = Difference(*depths_a, *depths_b, diff.objects.offset);
  return diff;
}

OrderedJson DepthJson(const DepthDifference& depth) {
  OrderedJson changes = OrderedJson::array();
  for (const DepthChange& change : depth.changes) {
    changes.push_back({{"north_m", change.north},
                       {"east_m", change.east},
                       {"area_m2", change.area_m2},
                       {"mean_m", change.mean_m},
                       {"z", change.z}});
  }
  const auto if_compared = [&depth](double value) {
    return depth.cells > 0 ? OrderedJson(value) : OrderedJson(nullptr);
  };
  return {{"cells", depth.cells},
          {"cells_a", depth.cells_a},
          {"cells_b", depth.cells_b},
          {"significant_cells", depth.significant_cells},
          {"offset_m", if_compared(depth.offset_m)},
          {"offset_sd_m", if_compared(depth.offset_sd_m)},
          {"rms_m", if_compared(depth.rms_m)},
          {"sigma_scale", if_compared(depth.sigma_scale)},
          {"changes", std::move(changes)}};
}

/// How much of the smaller map could be compared, where that is little.
std::string ComparedText(const DepthDifference& depth) {
  const std::size_t smaller = std::min(depth.cells_a, depth.cells_b);
  if (2 * depth.cells >= smaller) return "";
  return fmt::format("; only {:.0f} % of the smaller map could be compared",
                     100.0 * static_cast<double>(depth.cells) / static_cast<double>(smaller));
}

std::string ChangesText(const DepthDifference& depth) {
  constexpr std::size_t kMost = 10;
  if (depth.changes.empty()) {
    return fmt::format("  no part of the seabed is significantly deeper or shallower{}\n",
                       ComparedText(depth));
  }
  std::string text = fmt::format("  {:>8} {:>8} {:>9} {:>9} {:>6}\n", "north", "east", "area m2",
                                 "deeper m", "sigmas");
  for (std::size_t i = 0; i < std::min(kMost, depth.changes.size()); ++i) {
    const DepthChange& change = depth.changes[i];
    text += fmt::format("  {:>8.2f} {:>8.2f} {:>9.2f} {:>9.2f} {:>6.1f}\n", change.north,
                        change.east, change.area_m2, change.mean_m, change.z);
  }
  if (depth.changes.size() > kMost) {
    text += fmt::format("  and {} smaller; --json has all\n", depth.changes.size() - kMost);
  }
  return text;
}

std::string DepthText(const DepthDifference& depth) {
  if (depth.cells == 0) {
    return fmt::format(
        "no column of the seabed is in both ({} in A, {} in B): no depth could be compared\n",
        depth.cells_a, depth.cells_b);
  }
  return fmt::format(
             "{} columns of the seabed in both; all differ by {:.2f} m (sd {:.2f} m), left {:.2f} "
             "m "
             "rms; {} by more than {:g} sigmas\n",
             depth.cells, depth.offset_m, depth.offset_sd_m, depth.rms_m, depth.significant_cells,
             DepthDifference::kSignificant) +
         ChangesText(depth);
}

}  // namespace

Expected<std::string> MapDiffJson(const SavedSession& a, const SavedSession& b) {
  const Expected<MapDiff> diff = DiffOf(a, b);
  if (!diff) return diff.error();
  OrderedJson out = OrderedJson::parse(Json(diff->objects));
  out["depth"] = DepthJson(diff->depth);
  return out.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Expected<std::string> MapDiffText(const SavedSession& a, const SavedSession& b) {
  const Expected<MapDiff> diff = DiffOf(a, b);
  if (!diff) return diff.error();
  std::string text = DepthText(diff->depth);
  text += fmt::format("{} objects in either\n", diff->objects.objects.size());
  for (const OpiBelief& object : diff->objects.objects) {
    const Eigen::Vector3d& p_W = object.object.p_W;
    text += fmt::format("  {:<14} {:<10} {:>8.2f} {:>8.2f} {:>7.2f}\n", NameOf(object.decided),
                        OneLine(object.object.color, 10), p_W.x(), p_W.y(), p_W.z());
  }
  return text;
}

}  // namespace limpet
