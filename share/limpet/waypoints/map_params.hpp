// SPDX-License-Identifier: MIT
// Parameters of existing missions that are no plain numbers, declared alike by all behaviors.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/shapes/shape.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/lead_point.hpp"
#include "limpet/waypoints/waypoint_progress.hpp"

namespace limpet {

/// Lets existing missions give `1.5` for 1 of the parameter declared last.
void TakeWholePart(ParamCollector& visit);
/// Lets existing missions give the unit, too, of the number of metres declared last: `5 m`.
void TakeMetres(ParamCollector& visit);

/// The name of a variable without blanks; empty: not posted.
void DescribeVariable(ParamCollector& visit, const char* name, std::string& field,
                      const char* help);
/// `visual_hints`, one or more lines.
void DescribeHints(ParamCollector& visit, VisualHints& hints);
/// `post_suffix`: appended to status variables, after an underscore.
void DescribeSuffix(ParamCollector& visit, const char* name, std::string& suffix);
/// `summitdelta`: how far a preference falls within its peakwidth, of a hundred.
void DescribeSummitDelta(ParamCollector& visit, double& summit_delta);
/// What is left of the preference there, of one; Peak::edge_value.
[[nodiscard]] double EdgeValue(double summit_delta);
/// `patience`: of a weight over course and speed, what the course gets; of a hundred.
void DescribePatience(ParamCollector& visit, double& percent);

/// `capture_radius`, `slip_radius`, `capture_line`.
void DescribeCapture(ParamCollector& visit, CaptureRule& rule);
/// `lead`, `lead_damper`.
void DescribeLead(ParamCollector& visit, LeadRule& rule);
/// `repeat`: a number, or `forever`, which is nothing.
void DescribeRepeats(ParamCollector& visit, std::optional<int>& repeats);
/// A side: true for `port` or `left`, false for `star`, `starboard` or `right`.
[[nodiscard]] std::optional<bool> ParseIsPort(std::string_view text);

}  // namespace limpet
