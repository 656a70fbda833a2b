// SPDX-License-Identifier: MIT
// A log of MOOS, made up: what the own navigation of a vehicle that goes round a square says.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace limpet {

struct MadeLog {
  double seconds = 160.0;
  double speed = 1.0;       ///< [m/s]
  double course_off = 0.0;  ///< of the way to the heading, clockwise [deg]
  double side = 40.0;       ///< of the square [m]
  bool has_heading = true;
};

/// NAV_* five times a second, as MOOS's logger writes them.
inline std::string MoosText(const MadeLog& log) {
  std::string text =
      "%%%%%%%%%%%%%%\n%% LOG FILE: ./made.alog\n%% FILE OPENED ON  Sat Nov 21 07:20:00 2026\n"
      "%% LOGSTART 1795245600.0\n%%%%%%%%%%%%%%\n";
  double east = 100.0, north = -50.0;
  const double step = 0.2;
  for (int i = 0; i < static_cast<int>(log.seconds / step); ++i) {
    const double t = step * i;
    const double heading = 90.0 * std::floor(t * log.speed / log.side);
    const auto line = [&text, t](const char* name, double value) {
      text += fmt::format("{:<12.4f} {:<20} pNavOfOthers   {:.5f}\n", t, name, value);
    };
    line("NAV_X", east);
    line("NAV_Y", north);
    if (log.has_heading) line("NAV_HEADING", std::fmod(heading, 360.0));
    line("NAV_SPEED", log.speed);
    line("NAV_DEPTH", 2.0 + 0.01 * t);
    const double course = (heading + log.course_off) * 3.14159265358979323846 / 180.0;
    east += step * log.speed * std::sin(course);
    north += step * log.speed * std::cos(course);
  }
  return text;
}

}  // namespace limpet
