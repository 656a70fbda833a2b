// SPDX-License-Identifier: MIT
// What operator displays of the MOOS world read: pMarineViewer, uMAC, uHelmScope, alogview.
#pragma once

#include <optional>
#include <string>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// Where a vehicle is and what it does, as one line of `KEY=value`.
struct NodeReport {
  std::string name;
  double x = 0.0, y = 0.0;  ///< east, north of the datum [m]
  double speed = 0.0;       ///< [m/s]
  double heading_deg = 0.0;
  std::optional<double> depth{}, latitude_deg{}, longitude_deg{};
  std::string type{}, color{}, group{};
  std::string mode{};     ///< `MODE@ACTIVE:SURVEYING`, PARK, NOHELM-12, ...
  std::string allstop{};  ///< clear, ManualOverride, ...
  std::optional<double> altitude{};
  std::optional<double> yaw{};  ///< counter-clockwise from east [rad]
  double time = 0.0;            ///< UTC in MOOS time [s]
  std::optional<double> length{}, beam{};
  std::string vsource{};                 ///< where what is known of the vehicle comes from
  std::optional<double> transparency{};  ///< 0 to 1
  template <class V>
  void Describe(V& visit) {
    visit("NAME", name), visit("X", x), visit("Y", y), visit("SPD", speed);
    visit("HDG", heading_deg), visit("DEP", depth), visit("LAT", latitude_deg);
    visit("LON", longitude_deg), visit("TYPE", type), visit("COLOR", color);
    visit("GROUP", group), visit("VSOURCE", vsource), visit("MODE", mode),
        visit("ALLSTOP", allstop);
    visit("ALTITUDE", altitude), visit("YAW", yaw), visit("TIME", time);
    visit("TRANSPARENCY", transparency), visit("LENGTH", length), visit("BEAM", beam);
  }
  bool operator==(const NodeReport&) const = default;
};

/// Two decimals without trailing zeros, eight for LAT and LON, seven for YAW; keys of either case
/// and MOOS's aliases (SPEED, HEADING, DEPTH, LEN, ALT, UTC_TIME) are read.
template <>
struct TopicCodec<NodeReport> {
  [[nodiscard]] static Value Encode(const NodeReport& report);
  [[nodiscard]] static std::optional<NodeReport> Decode(const Value& value);
};

namespace topics {
inline const auto kAppCast =
    Declare<std::string>("APPCAST", "an app's report for operators; embedded, only at the end",
                         {.rate = "on APPCAST_REQ", .writers = {"every app"}});
inline const auto kAppCastRequest =
    Declare<std::string>("APPCAST_REQ", "asks for reports: node=,app=,duration=,key=,thresh=",
                         {.rate = "1 Hz while somebody looks", .writers = {"uMAC", "viewers"}});
inline const auto kNodeReportLocal =
    Declare<NodeReport>("NODE_REPORT_LOCAL", "where this vehicle is and what it does",
                        {.unit = "m, m/s, deg",
                         .frame = "x east, y north",
                         .rate = "2 Hz",
                         .writers = {"pNodeReporter"}});
inline const auto kViewPoint = Declare<std::string>(
    "VIEW_POINT", "home; where the next options end",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pHelm"}});
inline const auto kViewSeglist = Declare<std::string>(
    "VIEW_SEGLIST", "the path in force",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pHelm"}});
inline const auto kViewPolygon = Declare<std::string>(
    "VIEW_POLYGON", "area and operating region",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pHelm"}});
inline const auto kViewCircle = Declare<std::string>(
    "VIEW_CIRCLE", "1-sigma of each object",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pMap"}});
inline const auto kViewMarker = Declare<std::string>(
    "VIEW_MARKER", "objects, colored by status",
    {.unit = "m", .frame = "x east, y north", .rate = "on change", .writers = {"pMap"}});

inline const auto kHelmSummary = Declare<std::string>(
    "IVPHELM_SUMMARY", "the helm's decision and its behaviors; after the first what changed",
    {.rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kBehaviorFunction = Declare<std::string>(
    "BHV_IPF",
    "with post_ipf: a behavior's bid on the motion, as uFunctionVis and alogview read it",
    {.rate = "each iteration and behavior", .writers = {"pHelm"}});
inline const auto kHelmRejournal = Declare<double>(
    "IVPHELM_REJOURNAL", "asks for a whole IVPHELM_SUMMARY",
    {.rate = "on event", .writers = {"pNodeReporter", "uHelmScope"}, .is_command = true});
inline const auto kHelmMapClear = Declare<std::string>(
    "HELM_MAP_CLEAR", "asks behaviors to post once more what has not changed, e.g. shapes",
    {.rate = "on event", .writers = {"viewers"}, .is_command = true});
inline const auto kHelmRestart = Declare<std::string>(
    "RESTART_HELM",
    "type1: read the behavior files anew and make all behaviors from them; type2: post their "
    "initial values, too",
    {.rate = "on event", .writers = {"operator"}, .is_command = true});
inline const auto kHelmAlias =
    Declare<std::string>("IVPHELM_ALIAS", "what the helm is called (helm_alias)",
                         {.rate = "once", .writers = {"pHelm"}});
inline const auto kBehaviorStatus = Declare<std::string>(
    "BHV_STATUS",
    "name=, pc=the condition or input that it waits for, or why it completed, pwt=, state=active, "
    "running, idle or completed, updates=applied whole/all",
    {.rate = "of each behavior, on change", .writers = {"pHelm"}});
inline const auto kHelmIteration = Declare<double>("IVPHELM_ITER", "iterations of the helm",
                                                   {.rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kHelmDomain =
    Declare<std::string>("IVPHELM_DOMAIN", "decision variables: name,low,high,points joined by `:`",
                         {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmModeSet =
    Declare<std::string>("IVPHELM_MODESET", "mode variables and their parent,child pairs",
                         {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmBehaviorCount = Declare<double>("IVPHELM_BHV_CNT", "behaviors that exist",
                                                       {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmBehaviorCountEver =
    Declare<double>("IVPHELM_BHV_CNT_EVER", "behaviors that have been made",
                    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmFunctionCount =
    Declare<double>("IVPHELM_IPF_CNT", "bids on the motion that went into the decision",
                    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmCreateTime = Declare<double>(
    "IVPHELM_CREATE_CPU", "real time that the behaviors took to bid on the motion; not embedded",
    {.unit = "s", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kHelmLoopTime =
    Declare<double>("IVPHELM_LOOP_CPU", "real time that the iteration took; not embedded",
                    {.unit = "s", .rate = "10 Hz", .writers = {"pHelm"}});
inline const auto kLoggerCommand =
    Declare<std::string>("PLOGGER_CMD", "COPY_FILE_REQUEST = a behavior file: keep a copy of it",
                         {.rate = "once each", .writers = {"pHelm"}, .is_command = true});
inline const auto kHelmCpu =
    Declare<double>("IVPHELM_CPU", "share of a core that the helm's process took; not embedded",
                    {.unit = "%", .rate = "1 Hz", .writers = {"pHelm"}});
inline const auto kHelmPiecesFormed = Declare<double>(
    "IVPHELM_TOTAL_PCS_FORMED", "pieces of the functions in BHV_IPF; 0 without post_ipf",
    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmPiecesCached = Declare<double>(
    "IVPHELM_TOTAL_PCS_CACHED", "0: no bid is used twice", {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmRestarted = Declare<std::string>(
    "IVPHELM_RESTARTED",
    "true: the helm decides again, after its process was replaced or RESTART_HELM",
    {.rate = "on event", .writers = {"pHelm"}});
inline const auto kHelmUpdateVars = Declare<std::string>(
    "IVPHELM_UPDATEVARS", "behavior=variable, ...: where behaviors take updates",
    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmUpdateResult = Declare<std::string>(
    "IVPHELM_UPDATE_RESULT",
    "bhv=, var=, time=, result=success, param_error, name_mismatch or duplicate, val=",
    {.rate = "on event", .writers = {"pHelm"}});
inline const auto kHelmSkew =
    Declare<std::string>("IVPHELM_SKEW", "mail that was left out for its stamp (ok_skew)",
                         {.rate = "each", .writers = {"pHelm"}});
inline const auto kHelmLifeEvent =
    Declare<std::string>("IVPHELM_LIFE_EVENT", "a behavior was made, or ended",
                         {.rate = "on event", .writers = {"pHelm"}});
inline const auto kHelmRegister = Declare<std::string>(
    "IVPHELM_REGISTER", "a variable that the behavior files make the helm hear",
    {.rate = "once each", .writers = {"pHelm"}});
inline const auto kHelmStateVars =
    Declare<std::string>("IVPHELM_STATEVARS", "variables of conditions, modes, updates and flags",
                         {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmActive =
    Declare<std::string>("IVPHELM_BHV_ACTIVE", "behaviors that run and bid",
                         {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmRunning =
    Declare<std::string>("IVPHELM_BHV_RUNNING", "behaviors that run without a bid",
                         {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmIdle =
    Declare<std::string>("IVPHELM_BHV_IDLE", "behaviors whose conditions do not hold",
                         {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmDisabled =
    Declare<std::string>("IVPHELM_BHV_DISABLED", "behaviors that are switched off: none ever is",
                         {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmActiveCount = Declare<double>("IVPHELM_BHV_ACTIVE_CNT", "names in it",
                                                     {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmRunningCount = Declare<double>("IVPHELM_BHV_RUNNING_CNT", "names in it",
                                                      {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmIdleCount = Declare<double>("IVPHELM_BHV_IDLE_CNT", "names in it",
                                                   {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmDisabledCount = Declare<double>("IVPHELM_BHV_DISABLED_CNT", "names in it",
                                                       {.rate = "once", .writers = {"pHelm"}});
inline const auto kHelmCompletedCount =
    Declare<double>("IVPHELM_COMPLETED_COUNT", "behaviors that completed in this iteration",
                    {.rate = "on change", .writers = {"pHelm"}});
inline const auto kHelmCompletedPending = Declare<std::string>(
    "IVPHELM_COMPLETED_PENDING", "true if behaviors completed in this iteration",
    {.rate = "on change", .writers = {"pHelm"}});
}  // namespace topics

}  // namespace limpet
