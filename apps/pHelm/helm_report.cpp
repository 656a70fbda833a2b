// SPDX-License-Identifier: MIT
// What an operator sees of the helm.
#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/decision/merit.hpp"

namespace limpet {
namespace {

std::string TextOr(const std::optional<double>& value, int decimals, const char* unit) {
  return value ? DecimalText(*value, decimals) + unit : "nobody has an opinion";
}

void AddOptions(const HelmBids& bids, ReportLines& report) {
  constexpr std::size_t kShown = 5;
  ReportTable options({"option", ">length", ">worth", ">per metre", ">north", ">east"});
  for (const BiddenOption& option :
       std::span(bids.options).first(std::min(bids.options.size(), kShown))) {
    const bool is_vetoed = VetoOn(option) != nullptr;
    options.AddRow({option.source, fmt::format("{:.1f}", option.length),
                    is_vetoed ? "vetoed" : fmt::format("{:.2f}", option.total),
                    fmt::format("{:.3f}", option.rate), fmt::format("{:.1f}", option.end[0]),
                    fmt::format("{:.1f}", option.end[1])});
  }
  report.Add(options);
  if (bids.options.empty() || bids.options.front().bids.empty()) {
    return;
  }
  report.Blank();
  ReportTable reasons({"bids on the first", ">pwt", ">value", "why"});
  for (const WeightedBid& weighted : bids.options.front().bids) {
    reasons.AddRow({weighted.behavior, DecimalText(weighted.weight, 2),
                    fmt::format("{:.2f}", weighted.bid.value), WhyText(weighted.bid)});
  }
  report.Add(reasons);
}

}  // namespace

void HelmApp::Report(ReportLines& report) const {
  report.Pair("State", fmt::format("{}, all-stop {}", StateText(), allstop_text_));
  report.Pair("Mode", host_.modes().empty() ? "none" : host_.modes());
  if (!nav_) {
    report.Pair("Navigation", "not heard yet");
  }
  report.Pair("Course", TextOr(last_course_deg(), 1, " deg"));
  report.Pair("Speed", TextOr(motion_.speed, 2, " m/s"));
  report.Pair("Depth", TextOr(motion_.depth, 2, " m"));
  if (!revisits_.objects.empty()) {
    report.Pair("Objects", RevisitText());
  }
  report.Blank();
  ReportTable behaviors({"behavior", "type", ">pwt", "state", ">for [s]", ">updates", "waits for"});
  for (const HelmJournal::Entry& entry : journal_.entries()) {
    const BehaviorStatus& behavior = entry.behavior;
    behaviors.AddRow(
        {behavior.name, behavior.type, DecimalText(behavior.weight, 2),
         HelmJournal::NameOf(entry.state), fmt::format("{:.0f}", (now() - entry.since).value()),
         fmt::format("{}/{}", behavior.good_updates, behavior.updates), behavior.held_back_by});
  }
  report.Add(behaviors);
  if (bids_) {
    report.Blank();
    report.Add(fmt::format("Last path: {}, {:.0f} s ago, of {} options, because: {}",
                           bids_->value.path_id, (now() - bids_->time).value(),
                           bids_->value.considered, bids_->value.cause));
    AddOptions(bids_->value, report);
  }
}

}  // namespace limpet
