// SPDX-License-Identifier: MIT
#include "apps/pNodeReporter/node_reporter_app.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr Seconds kAltitudeLasts(5.0);

std::optional<double> DegreesOf(const AppContext& context, const char* key, double most) {
  const std::string text = context.Global(key);
  if (text.empty()) {
    return std::nullopt;
  }
  const std::optional<double> degrees = ParseNumber(text);
  if (!degrees || std::abs(*degrees) > most) {
    throw ConfigError(
        {{},
         key,
         fmt::format("`{}` is not allowed; allowed: -{:g} to {:g} deg", text, most, most)});
  }
  return degrees;
}

std::optional<double> IfPositive(Meters length) {
  return length.value() > 0.0 ? std::optional<double>(length.value()) : std::nullopt;
}

}  // namespace

NodeReporterApp::NodeReporterApp(const AppContext& context, const Params& params)
    : App(context), params_(params) {
  ReadDatum();
  ReadExtras();
  Subscribe(topics::kNavX, &NodeReporterApp::OnX);
  Subscribe(topics::kNavY, &NodeReporterApp::OnY);
  Subscribe(topics::kNavSpeed, &NodeReporterApp::OnSpeed);
  Subscribe(topics::kNavHeading, &NodeReporterApp::OnHeading);
  Subscribe(topics::kNavDepth, &NodeReporterApp::OnDepth);
  Subscribe(topics::kNavAltitude, &NodeReporterApp::OnAltitude);
  Subscribe(topics::kNavYaw, &NodeReporterApp::OnYaw);
  Subscribe(topics::kHelmState, &NodeReporterApp::OnHelmState);
  Subscribe(topics::kHelmAllStop, &NodeReporterApp::OnAllStop);
  Subscribe(topics::kHelmSummary, &NodeReporterApp::OnSummary);
  SubscribeToExtras();
}

void NodeReporterApp::ReadDatum() {
  const auto latitude = DegreesOf(context(), "LatOrigin", 90.0);
  const auto longitude = DegreesOf(context(), "LongOrigin", 180.0);
  if (latitude && longitude) {
    grid_.emplace(GeoPoint{.latitude_deg = *latitude, .longitude_deg = *longitude});
  } else {
    WarnOfConfig("LatOrigin or LongOrigin is not set: reports have no LAT and LON");
  }
}

void NodeReporterApp::OnHelmState(const Stamped<std::string>& state) {
  helm_state_ = state.value;
  last_helm_ = state.time;
}

/// The modes stand in the first summary and in those after a change.
void NodeReporterApp::OnSummary(const Stamped<std::string>& summary) {
  constexpr std::string_view kModes = ",modes=";
  if (const std::size_t at = summary.value.find(kModes); at != std::string::npos) {
    const std::size_t begin = at + kModes.size();
    mode_ = summary.value.substr(begin, summary.value.find(',', begin) - begin);
  } else if (mode_.empty() && !has_asked_for_mode_) {
    has_asked_for_mode_ = true;
    Publish(topics::kHelmRejournal, 1.0);  // as uHelmScope: a variable keeps its type
  }
}

std::string NodeReporterApp::ModeAt(Seconds now) const {
  if (!last_helm_) {
    return "NOHELM-EVER";
  }
  if (const Seconds silence = now - *last_helm_; silence > params_.nohelm_threshold) {
    return fmt::format("NOHELM-{:.0f}", silence.value());
  }
  const bool has_mode = !mode_.empty() && mode_ != "none";
  return helm_state_ == "DRIVE" && has_mode ? mode_ : helm_state_;
}

NodeReport NodeReporterApp::ReportAt(Seconds now) const {
  NodeReport report{.name = context().Global("Community"),
                    .x = *x_,
                    .y = *y_,
                    .speed = *speed_,
                    .heading_deg = *heading_,
                    .depth = {},
                    .latitude_deg = {},
                    .longitude_deg = {},
                    .type = params_.platform_type,
                    .color = params_.platform_color,
                    .group = params_.group,
                    .mode = ModeAt(now),
                    .allstop = allstop_,
                    .altitude = {},
                    .yaw = {},
                    .time = last_nav_->value(),
                    .length = IfPositive(params_.platform_length),
                    .beam = IfPositive(params_.platform_beam)};
  report.vsource = params_.vsource;
  report.transparency = params_.platform_transparency > 0.0
                            ? std::optional(params_.platform_transparency)
                            : std::nullopt;
  if (altitude_ && now - altitude_->time <= kAltitudeLasts) {
    report.altitude = altitude_->value;
  }
  if (params_.terse_reports) {
    return report;
  }
  report.depth = depth_;
  report.yaw = yaw_;
  if (grid_) {
    const GeoPoint place = grid_->At({*y_, *x_});
    report.latitude_deg = place.latitude_deg;
    report.longitude_deg = place.longitude_deg;
  }
  return report;
}

void NodeReporterApp::Tick(Seconds now) {
  if (params_.is_paused || !x_ || !y_ || !speed_ || !heading_) {
    return;
  }
  if (last_report_ && now - *last_report_ < params_.blackout_interval) {
    return;
  }
  last_report_ = now;
  ++reports_;
  Post(ReportAt(now), ExtrasAt(now));
  if (const auto alternative = AlternativeAt(now)) {
    Post(*alternative, "");
  }
}

void NodeReporterApp::Report(ReportLines& report) const {
  report.Pair("Vehicle",
              fmt::format("{} ({})", context().Global("Community"), params_.platform_type));
  report.Pair("Datum",
              fmt::format("{}, {}", context().Global("LatOrigin"), context().Global("LongOrigin")));
  report.Pair("Reports", fmt::format("{} on {}{}", reports_, params_.node_report_output,
                                     params_.is_paused ? ", paused" : ""));
  if (!last_report_) {
    report.Pair("Position", "not known yet");
    return;
  }
  const NodeReport last = ReportAt(*last_report_);
  report.Pair("Position", fmt::format("x {:.2f} m, y {:.2f} m, depth {:.2f} m", last.x, last.y,
                                      depth_.value_or(0.0)));
  report.Pair("Motion",
              fmt::format("{:.2f} m/s, heading {:.0f} deg", last.speed, last.heading_deg));
  report.Pair("Mode", last.mode);
  report.Pair("All-stop", last.allstop);
}

LIMPET_REGISTER_APP(NodeReporterApp, "pNodeReporter", 2.0);

}  // namespace limpet
