// SPDX-License-Identifier: MIT
// What uSimVehicle warns of and reports, as a thruster driver does.
#pragma once

#include "limpet/topics/event.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet::warnings {

inline const WarningId kBatteryOff = DeclareWarning(
    "BATTERY_OFF",
    {.severity = Severity::kAlarm,
     .raised_by = {"uSimVehicle"},
     .meaning = "The simulated battery is empty, or was asked for more than it gives: its "
                "protection has switched it off, and no thruster turns any more.",
     .action = "Nothing helps this dive; what would have: `limpet check --dry-run`, the rules of "
               "the battery in docs/safety.md.",
     .clears = "It stands to the end of the run."});

inline const WarningId kCommandRefused = DeclareWarning(
    "COMMAND_REFUSED",
    {.severity = Severity::kWarning,
     .raised_by = {"uSimVehicle"},
     .meaning = "A THRUSTER_COMMAND is not finite, beyond full thrust or for a thruster that the "
                "vehicle has not; it was not obeyed.",
     .action = "See who writes THRUSTER_COMMAND.",
     .clears = "With the next command that can be obeyed."});

inline const WarningId kCommandStale = DeclareWarning(
    "COMMAND_STALE",
    {.severity = Severity::kWarning,
     .raised_by = {"uSimVehicle"},
     .meaning = "No THRUSTER_COMMAND has come for 1 s: all thrusters are stopped.",
     .action = "See whether pPilot runs; under MOOS_MANUAL_OVERRIDE this is as it should be.",
     .clears = "With the next command."});

inline const WarningId kFaultNotMade = DeclareWarning(
    "FAULT_NOT_MADE",
    {.severity = Severity::kWarning,
     .raised_by = {"uSimVehicle"},
     .meaning = "The scenario has faults that pLaunch and embedded sessions alone make: apps that "
                "hang, the disk, the wall clock. This community is sound in that.",
     .action = "Start the mission by `limpet launch` or pLaunch, run it embedded (`limpet survey`, "
               "`limpet safety test`), or take them out.",
     .clears = "It stands to the end of the run."});

inline const WarningId kIntegratorFailed = DeclareWarning(
    "INTEGRATOR_FAILED",
    {.severity = Severity::kWarning,
     .raised_by = {"uSimVehicle"},
     .meaning = "CVODE gave up a step of the simulation; fixed steps bridged it.",
     .action = "Take the motion at that time with care; report the scenario to the developers.",
     .clears = "It stands to the end of the run."});

}  // namespace limpet::warnings

namespace limpet::events {

inline const EventId kThrusters =
    DeclareEvent("THRUSTERS", {.severity = Severity::kNote,
                               .reported_by = {"uSimVehicle"},
                               .meaning = "The thrusters begin to work, or come to rest."});

inline const EventId kSimulatedEvent = DeclareEvent(
    "SIM_EVENT",
    {.severity = Severity::kNote,
     .reported_by = {"uSimVehicle"},
     .meaning = "The simulated vehicle meets the surface or the seabed, or leaves it."});

}  // namespace limpet::events
