// SPDX-License-Identifier: MIT
// What pSafety says, and what it hears that nobody else on board needs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// What a safety rule asks for, least first: of several the highest is done.
enum class SafetyAction {
  kNone,
  kWarn,     ///< say so
  kDegrade,  ///< go slowly
  kHold,     ///< stay at this depth without way on, and wait
  kReturn,   ///< end the survey and go home
  kSurface,  ///< no thrust but upwards; the mission ends at the surface
  kAbort     ///< as kSurface, whatever comes, until an operator lifts it
};

/// `none`, `warn`, `degrade`, `hold`, `return`, `surface`, `abort`.
[[nodiscard]] std::string_view NameOf(SafetyAction action);
/// Nothing for any other word.
[[nodiscard]] std::optional<SafetyAction> SafetyActionNamed(std::string_view name);

/// One rule as it is now.
struct SafetyRuleState {
  std::string rule;
  /// How far what it watches is from its limit, in the rule's unit; below 0: beyond. Absent while
  /// nothing is known.
  std::optional<double> margin;
  std::string stands;  ///< the action that it asks for; empty: none
};
/// Which action is in force and why.
struct SafetyState {
  std::string action = "none";
  std::string rule;    ///< the first that asked for it; empty: none did
  double since = 0.0;  ///< MOOS time; 0: from the start
  std::vector<SafetyRuleState> rules;
};
template <>
struct TopicCodec<SafetyState> : JsonCodec<SafetyState> {};

/// The battery as its gauge tells.
struct BatteryState {
  double charge = 1.0;  ///< share of what it holds when full
  std::optional<double> volts, amperes;
  template <class V>
  void Describe(V& visit) {
    visit("charge", charge), visit("volts", volts), visit("amperes", amperes);
  }
};

/// Whether the log takes what is to be in it.
struct LogState {
  bool is_written = true;
  int missing = 0;   ///< messages that it lacks
  int in_doubt = 0;  ///< messages that the disk may have lost
  template <class V>
  void Describe(V& visit) {
    visit("is_written", is_written), visit("missing", missing), visit("in_doubt", in_doubt);
  }
};

/// The process that is busiest.
struct ProcessorLoad {
  double percent = 0.0;  ///< of a core: 100 fills one, and each thread may fill one
  std::string app;
  template <class V>
  void Describe(V& visit) {
    visit("percent", percent), visit("app", app);
  }
};

namespace topics {
inline const auto kSafetyAction = Declare<std::string>(
    "SAFETY_ACTION", "none, warn, degrade, hold, return, surface or abort: what is to be done now",
    {.rate = "on change, and 1 Hz", .writers = {"pSafety"}, .is_command = true});
inline const auto kSafetyState = Declare<SafetyState>(
    "SAFETY_STATE", "the action, the rule that asks for it, since when, and every rule's margin",
    {.unit = "of each rule", .rate = "on change, and every 5 s", .writers = {"pSafety"}});
inline const auto kSafetyReset = Declare<bool>(
    "SAFETY_RESET", "true lifts what pSafety's rules ask for; what is still so asks again",
    {.rate = "on event", .writers = {"operator"}, .is_command = true});
inline const auto kLeak =
    Declare<bool>("LEAK", "water in the hull",
                  {.rate = "1 Hz", .writers = {"uSimVehicle", "a driver of the vehicle's"}});
inline const auto kBattery =
    Declare<BatteryState>("BATTERY", "charge, voltage and current of the battery",
                          {.unit = "share, V, A",
                           .rate = "1 Hz",
                           .writers = {"uSimVehicle", "a driver of the vehicle's"}});
inline const auto kShoreBeat =
    Declare<double>("SHORE_BEAT", "any number, again and again: the link to the shore is up",
                    {.rate = "1 Hz", .writers = {"another community, over pShare", "uSimVehicle"}});
inline const auto kLogState = Declare<LogState>(
    "LOG_STATE", "whether the log is written, and how many messages are missing in it",
    {.rate = "on change; in a community at the start, too", .writers = {"pLog"}});
inline const auto kLaunchStatus = Declare<std::string>(
    "PLAUNCH_STATUS", "what became of each process: `app=pNav,state=running,restarts=1,... # ...`",
    {.rate = "on change, and every 5 s", .writers = {"pLaunch"}});
inline const auto kLaunchMemory =
    Declare<double>("PLAUNCH_MEMORY",
                    "resident memory of all processes that pLaunch runs; embedded only as a fault",
                    {.unit = "MiB", .rate = "every 5 s", .writers = {"pLaunch"}});
inline const auto kLaunchProcessor =
    Declare<ProcessorLoad>("PLAUNCH_PROCESSOR",
                           "the busiest of the processes that pLaunch runs, and the share of a "
                           "core that it takes, mean of "
                           "about 20 s, per second of vehicle time; embedded only as a fault",
                           {.unit = "% of a core", .rate = "every 5 s", .writers = {"pLaunch"}});
inline const auto kPlanTime = Declare<double>(
    "HELM_PLAN_TIME",
    "how long the last decision on where next took, in real time; embedded only as a fault",
    {.unit = "s", .rate = "each decision", .writers = {"pHelm"}});
}  // namespace topics

}  // namespace limpet
