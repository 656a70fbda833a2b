// SPDX-License-Identifier: MIT
// What to say of behaviors by their names.
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// ``nearest known: `BHV_Loiter` ``: by what the name says behind BHV_ and before a version such as
/// V19; of a name under which missions ask for one that there is, or of one in other letters, that
/// this is its name. If none has a word in common and at most a third of the letters wrong, it says
/// so: a name that is far off misleads.
[[nodiscard]] std::string NearestBehaviorText(std::string_view name);

/// The known behavior that is meant by its name in other letters (`BHV_waypoint`) or without BHV_
/// (`Waypoint`), which no helm takes; "" if none is.
[[nodiscard]] std::string MisnamedBehavior(std::string_view name);

/// True if the name is that of a version (`BHV_LoiterV3`) or of somebody's variant (`BHV_LoiterX`,
/// `BHV_MyLoiter`) of a known behavior, and no slip of the pen.
[[nodiscard]] bool IsVariantOfBehavior(std::string_view name, std::string_view known);

/// True for the behaviors that MOOS-IvP's helm ends at once unless their block says a `duration`.
[[nodiscard]] bool IsAskedForDuration(std::string_view name);

}  // namespace limpet
