// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "limpet/topics/mission.hpp"

namespace limpet {

/// ` deg`, ` m/s`, ` m` of course, speed, depth.
[[nodiscard]] const char* UnitOf(std::string_view variable);

/// True of the second peak over the course of one behavior, which prefers the present course to
/// turning.
[[nodiscard]] bool IsPresentCourse(const HelmMotion& motion, std::size_t opinion);

/// In words what is another: who wants something, whose wish counts most on course, speed or depth
/// (of those who want one value, by a tenth more than who did), or what was chosen. Empty if
/// nothing is; a weight that drifts is none, nor is a course of up to 5 deg, 0.05 m/s or 0.1 m.
[[nodiscard]] std::string DifferenceBetween(const HelmMotion& before, const HelmMotion& now);

}  // namespace limpet
