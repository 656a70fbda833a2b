// SPDX-License-Identifier: MIT
// What MOOS-IvP's pNodeReporter does besides: riders, aspects, a second position, JSON.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "apps/pNodeReporter/node_reporter_app.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr Seconds kAlternativeLasts(5.0);

std::string TextOf(const Message& message) {
  const auto* text = std::get_if<std::string>(&message.value);
  return text != nullptr ? *text : "";
}

}  // namespace

std::vector<std::string> UnusedReporterKeys::Set() const {
  const std::array<std::pair<const char*, const std::string*>, 12> keys{
      {{"blackout_variance", &blackout_variance},
       {"nav_grace_period", &nav_grace_period},
       {"cross_fill_policy", &cross_fill_policy},
       {"coord_policy_global", &coord_policy_global},
       {"plat_report_input", &plat_report_input},
       {"plat_report_output", &plat_report_output},
       {"extrap_enabled", &extrap_enabled},
       {"extrap_pos_thresh", &extrap_pos_thresh},
       {"extrap_hdg_thresh", &extrap_hdg_thresh},
       {"extrap_max_gap", &extrap_max_gap},
       {"report_cog", &report_cog},
       {"hdg_error", &hdg_error}}};
  std::vector<std::string> set;
  for (const auto& [name, value] : keys) {
    const bool has_no_effect_there = value->empty() || EqualsIgnoringCase(*value, "false") ||
                                     EqualsIgnoringCase(*value, "literal") ||
                                     ParseNumber(*value) == 0.0;
    if (!has_no_effect_there) {
      set.push_back(fmt::format("{} = {}", name, *value));
    }
  }
  return set;
}

void NodeReporterApp::ReadExtras() {
  std::vector<ConfigProblem> problems;
  for (const std::string& line : params_.riders) {
    Expected<NodeRider> rider = NodeRider::Parse(line);
    if (rider) {
      riders_.push_back(*std::move(rider));
    } else {
      problems.push_back({{}, "rider", rider.error().text});
    }
  }
  for (const std::string& aspect : params_.platform_aspects) {
    const std::size_t equals = aspect.find('=');
    if (equals == 0 || equals == std::string::npos || aspect.find(',') != std::string::npos) {
      problems.push_back({{}, "platform_aspect", fmt::format("`{}` is not FIELD=value", aspect)});
    }
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  for (const std::string& line : params_.unused.Set()) {
    WarnOfConfig(line + ": accepted, without effect");
  }
}

void NodeReporterApp::SubscribeToExtras() {
  for (NodeRider& rider : riders_) {
    SubscribeRaw(rider.variable(),
                 [&rider](const MessagePtr& message) { rider.Hear(message->value); });
  }
  SubscribeRaw("PNR_PAUSE", [this](const MessagePtr& message) {
    params_.is_paused = ParseFlag(TextOf(*message)).value_or(params_.is_paused);
  });
  if (params_.allows_color_change) {
    SubscribeRaw("NODE_COLOR_CHANGE", [this](const MessagePtr& message) {
      const std::string color = TextOf(*message);
      params_.platform_color = color.empty() ? params_.platform_color : color;
    });
  }
  if (params_.alt_nav_prefix.empty()) {
    return;
  }
  const std::string prefix =
      params_.alt_nav_prefix + (params_.alt_nav_prefix.ends_with('_') ? "" : "_");
  for (const char* what : {"X", "Y", "SPEED", "HEADING", "DEPTH", "YAW"}) {
    SubscribeRaw(prefix + what, [this, what](const MessagePtr& message) {
      if (const auto* value = std::get_if<double>(&message->value);
          value && std::isfinite(*value)) {
        OnAlternative(what, *value, message->time);
      }
    });
  }
}

void NodeReporterApp::OnAlternative(const std::string& what, double value, Seconds time) {
  if (what == "X") {
    alternative_.x = value;
    has_alternative_x_ = true;
  } else if (what == "Y") {
    alternative_.y = value;
    has_alternative_y_ = true;
  } else if (what == "SPEED") {
    alternative_.speed = value;
  } else if (what == "HEADING") {
    alternative_.heading_deg = value;
  } else if (what == "DEPTH") {
    alternative_.depth = value;
  } else {
    alternative_.yaw = value;
  }
  last_alternative_ = time;
}

std::optional<NodeReport> NodeReporterApp::AlternativeAt(Seconds now) const {
  const bool is_known = has_alternative_x_ && has_alternative_y_;
  if (!is_known || now - *last_alternative_ > kAlternativeLasts) {
    return std::nullopt;
  }
  NodeReport report = ReportAt(now);
  const std::string& name = params_.alt_nav_name;
  report.name = name.starts_with('_') ? report.name + name : name;
  report.group = params_.alt_nav_group.empty() ? report.group : params_.alt_nav_group;
  report.x = alternative_.x;
  report.y = alternative_.y;
  report.speed = alternative_.speed;
  report.heading_deg = alternative_.heading_deg;
  report.time = last_alternative_->value();
  report.altitude.reset();
  report.depth = params_.terse_reports ? std::nullopt : alternative_.depth;
  report.yaw = params_.terse_reports ? std::nullopt : alternative_.yaw;
  if (grid_ && !params_.terse_reports) {
    const GeoPoint place = grid_->At({report.y, report.x});
    report.latitude_deg = place.latitude_deg;
    report.longitude_deg = place.longitude_deg;
  }
  return report;
}

std::string NodeReporterApp::ExtrasAt(Seconds now) {
  std::string extras;
  for (const std::string& aspect : params_.platform_aspects) {
    extras += "," + aspect;
  }
  for (NodeRider& rider : riders_) {
    if (const auto field = rider.Take(now)) {
      extras += "," + *field;
    }
  }
  return extras;
}

void NodeReporterApp::Post(const NodeReport& report, const std::string& extras) {
  const Value encoded = TopicCodec<NodeReport>::Encode(report);
  const std::string text = std::get<std::string>(encoded) + extras;
  const bool is_json_alone = EqualsIgnoringCase(params_.json_report, "true");
  const bool has_json =
      !params_.json_report.empty() && !EqualsIgnoringCase(params_.json_report, "false");
  if (has_json) {
    PublishRaw(is_json_alone ? params_.node_report_output : params_.json_report,
               JsonOfReport(text));
  }
  if (!is_json_alone) {
    PublishRaw(params_.node_report_output, text);
  }
}

}  // namespace limpet
