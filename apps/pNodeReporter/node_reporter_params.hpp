// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

/// Keys of MOOS-IvP's app of this name that are read, so that its blocks work, and do nothing here.
struct UnusedReporterKeys {
  std::string blackout_variance{}, nav_grace_period{}, cross_fill_policy{}, coord_policy_global{};
  std::string plat_report_input{}, plat_report_output{};
  std::string extrap_enabled{}, extrap_pos_thresh{}, extrap_hdg_thresh{}, extrap_max_gap{};
  std::string report_cog{}, hdg_error{};

  template <class Visitor>
  void Describe(Visitor& visit) {
    constexpr const char* kUnused = "Accepted, without effect";
    visit("blackout_variance", blackout_variance, kUnused);
    visit("nav_grace_period", nav_grace_period, kUnused);
    visit("cross_fill_policy", cross_fill_policy, kUnused);
    visit("crossfill_policy", cross_fill_policy, kUnused);
    visit("coord_policy_global", coord_policy_global, kUnused);
    visit("plat_report_input", plat_report_input, kUnused);
    visit("plat_report_var", plat_report_input, kUnused);
    visit("platform_variable", plat_report_input, kUnused);
    visit("plat_report_output", plat_report_output, kUnused);
    visit("extrap_enabled", extrap_enabled, kUnused);
    visit("extrap_pos_thresh", extrap_pos_thresh, kUnused);
    visit("extrap_hdg_thresh", extrap_hdg_thresh, kUnused);
    visit("extrap_max_gap", extrap_max_gap, kUnused);
    visit("report_cog", report_cog, kUnused);
    visit("hdg_error", hdg_error, kUnused);
  }
  /// Those that were set to something that MOOS's app would act on.
  [[nodiscard]] std::vector<std::string> Set() const;
};

/// pNodeReporter's block, with the names of MOOS-IvP's, the older ones too.
struct NodeReporterParams {
  std::string platform_type = "uuv";
  Meters platform_length{0.0};
  Meters platform_beam{0.0};
  std::string platform_color{};
  std::string group{};
  Seconds blackout_interval{0.0};
  Seconds nohelm_threshold{5.0};
  std::string node_report_output = topics::kNodeReportLocal.name;
  bool terse_reports = false;
  double platform_transparency = 0.0;
  std::vector<std::string> platform_aspects{};
  std::string vsource{};
  std::vector<std::string> riders{};
  bool allows_color_change = false;
  bool is_paused = false;
  std::string json_report{};
  std::string alt_nav_prefix{}, alt_nav_name = "_GT", alt_nav_group{};
  UnusedReporterKeys unused{};

  template <class Visitor>
  void Describe(Visitor& visit) {
    DescribePlatform(visit);
    using namespace literals;
    visit("blackout_interval", blackout_interval, "Least time between two reports",
          InRange(0.0_s, 86400.0_s));
    visit("nohelm_threshold", nohelm_threshold, "A helm silent for longer is reported as NOHELM",
          InRange(0.001_s, 86400.0_s));
    visit("node_report_output", node_report_output, "Variable of the report");
    visit("node_report_summary", node_report_output, "Older name of node_report_output");
    visit("node_report_var", node_report_output, "Older name of node_report_output");
    visit("terse_reports", terse_reports, "Leave out depth, latitude, longitude and yaw");
    visit("rider", riders, "`var=X, policy=always, rfld=field, prec=4`: X rides along");
    visit("allow_color_change", allows_color_change, "NODE_COLOR_CHANGE changes the color");
    visit("paused", is_paused, "Say nothing until PNR_PAUSE = false");
    visit("json_report", json_report, "true: report as JSON; a variable: as JSON there too");
    visit("alt_nav_prefix", alt_nav_prefix, "Report a second position, <prefix>_X and so on");
    visit("alt_nav_name", alt_nav_name, "Name of that second vehicle; _GT: behind the first's");
    visit("alt_nav_group", alt_nav_group, "Group of that second vehicle");
    unused.Describe(visit);
  }

 private:
  template <class Visitor>
  void DescribePlatform(Visitor& visit) {
    using namespace literals;
    visit("platform_type", platform_type,
          "Body that viewers draw: uuv, kayak, glider, ship, heron, wamv, ...");
    visit("vessel_type", platform_type, "Older name of platform_type");
    visit("platform_length", platform_length, "Length of the vehicle; 0: not reported",
          InRange(0.0_m, 500.0_m));
    visit("vessel_length", platform_length, "Older name of platform_length",
          InRange(0.0_m, 500.0_m));
    visit("platform_beam", platform_beam, "Beam of the vehicle; 0: not reported",
          InRange(0.0_m, 500.0_m));
    visit("platform_color", platform_color, "Color that viewers draw; empty: theirs");
    visit("platform_transparency", platform_transparency, "How faint viewers draw it",
          InRange(0.0, 1.0));
    visit("platform_aspect", platform_aspects, "`FIELD=value`: one more field of the report");
    visit("group", group, "Group of vehicles that this one belongs to");
    visit("platform_group", group, "The same as group");
    visit("vsource", vsource, "Where what is known of the vehicle comes from");
    visit("platform_vsource", vsource, "The same as vsource");
  }
};

}  // namespace limpet
