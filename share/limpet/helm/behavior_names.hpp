// SPDX-License-Identifier: MIT
// What to say of behaviors by their names.
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// ``nearest known: `BHV_Loiter` ``: by what the name says behind BHV_ and before a version such as
/// V19; of a name under which missions ask for one that there is, that this is its name. If none
/// has a word in common and at most a third of the letters wrong, it says so: a name that is far
/// off misleads.
[[nodiscard]] std::string NearestBehaviorText(std::string_view name);

/// True for the behaviors that MOOS-IvP's helm ends at once unless their block says a `duration`.
[[nodiscard]] bool IsAskedForDuration(std::string_view name);

}  // namespace limpet
