// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/helm/view_params.hpp"

namespace limpet {

/// The helm's own block; behaviors have their .bhv file.
struct HelmParams {
  std::vector<std::string> behaviors{"mission.bhv"};
  std::vector<std::string> behavior_setting;
  std::vector<std::string> behavior_path;
  std::vector<std::string> domain{"course:0:359:360", "speed:0:1:21", "depth:0:100:1001"};
  bool start_in_drive = true;
  bool at_points = false;
  bool allow_park = true;
  Seconds nav_grace{5.0};
  std::vector<std::string> hold_on_app;
  std::optional<Seconds> ok_skew;  ///< absent: any
  std::string other_override_var{};
  bool park_on_allstop = false;
  bool goals_mandatory = false;
  std::string helm_prefix{}, helm_alias{};
  bool post_ipf = false;
  std::string lead{};
  std::string lead_depth{}, lead_course{}, lead_speed{};
  ViewParams views;

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit.Required("behaviors", behaviors, "Behavior files, relative to the mission folder");
    visit("behavior_setting", behavior_setting, "Overrides of behavior files: name.key=value");
    visit(
        "behavior_path", behavior_path,
        "Folders with behaviors of your own, libBHV_Name.so, several separated by `:`; relative to "
        "the mission folder. Those of the environment's LIMPET_BEHAVIOR_PATH come on top");
    visit.Required("domain", domain,
                   "Decision variables, name:low:high:points[:optional]; without depth none is "
                   "decided");
    visit(
        "at_points", at_points,
        "true: speeds, depths and courses are those of the domain's points, as pHelmIvP has them; "
        "so in a block of pHelmIvP that says nothing");
    visit("start_in_drive", start_in_drive,
          "false: parked until MOOS_MANUAL_OVERRIDE = false; so is a block of pHelmIvP that says "
          "nothing");
    visit.Also({"start_indrive", "start_engaged", "active_start"});
    visit("allow_park", allow_park, "false: MOOS_MANUAL_OVERRIDE = true does not park it");
    visit("nav_grace", nav_grace,
          "Without NAV_STATE: NAV_X and its kin may be so old; with a time warp a second of real "
          "time at least",
          InRange(Seconds(0.1), Seconds(3600.0)));
    // To pHelmIvP it is how long it waits before it says so, and NAV_X and its kin never grow old.
    visit.TakenAs(
        "0 and below: the default",
        [text = TextOf(nav_grace.value())](std::string_view given) -> std::optional<std::string> {
          const std::optional<double> seconds = ParseNumber(given);
          return seconds && *seconds <= 0.0 ? std::optional(text) : std::nullopt;
        });
    visit("post_ipf", post_ipf,
          "BHV_IPF: each bid on the motion as pieces, for uFunctionVis and alogview; some 5 kB of "
          "log a second in a survey");
    visit("lead", lead,
          "Steer by way of another helm: the variable in which its BHV_Waypoint takes updates. "
          "This helm then writes no DESIRED_*, IVPHELM_* and modes");
    visit("lead_depth", lead_depth,
          "With lead: the variable in which the other helm's BHV_ConstantDepth takes updates");
    visit("lead_course", lead_course,
          "With lead and lead_speed: the variable in which the other helm's BHV_ConstantHeading "
          "takes "
          "updates, told a course while there is no way");
    visit(
        "lead_speed", lead_speed,
        "With lead and lead_course: the variable in which the other helm's BHV_ConstantSpeed takes "
        "updates");
    DescribeMail(visit);
    visit.WithoutEffect({"node_skew", "verbose", "standby", "contact_max_age", "pmgen",
                         "seed_random", "ivp_behavior_dir", "ivp_behavior_dirs",
                         "bhv_dir_not_found_ok", "bhv_dirs_not_found_ok"});
    views.Describe(visit);
  }

  template <class Visitor>
  void DescribeMail(Visitor& visit) {
    visit("hold_on_app", hold_on_app,
          "What behaviors ask of apps as the helm begins (OBM_ALERT_REQUEST) waits until these are "
          "there, several separated by commas; embedded runs wait for nobody");
    visit.Also({"hold_on_apps"});
    visit.Parsed("ok_skew", "seconds, from 0, or any",
                 "Mail for behaviors whose stamp is further from now is left out (IVPHELM_SKEW)",
                 "any", [this](std::string_view text) {
                   const auto seconds = ParseNumber(text);
                   ok_skew.reset();
                   if (seconds && *seconds >= 0.0) ok_skew = Seconds(*seconds);
                   return ok_skew || EqualsIgnoringCase(text, "any");
                 });
    visit("other_override_var", other_override_var,
          "Another variable that parks the helm, or lets it drive, as MOOS_MANUAL_OVERRIDE does");
    visit("park_on_allstop", park_on_allstop,
          "With the first iteration that stops all it is parked, if it may be (allow_park)");
    visit("goals_mandatory", goals_mandatory,
          "Stand still where only constraints bid: BHV_AvoidObstacle, MaxDepth, MinAltitudeX");
    visit("helm_prefix", helm_prefix,
          "Before the names DESIRED_HEADING, _SPEED and the like; to stop all, both are written");
    visit("helm_alias", helm_alias, "What the helm is called: IVPHELM_ALIAS");
  }
};

}  // namespace limpet
