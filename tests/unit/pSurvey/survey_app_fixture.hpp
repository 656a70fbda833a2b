// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "limpet/survey/look.hpp"
#include "tests/unit/pSurvey/survey_app_parts.hpp"

namespace limpet {

/// pSurvey with the other apps' mail played to it.
class SurveyAppTest : public ::testing::Test {
 protected:
  /// Navigation goes on meanwhile.
  void Tick(double seconds) {
    link_.time += Seconds(seconds);
    if (nav_) {
      link_.Send(app_, topics::kNavState, *nav_);
    }
    app_.Tick(link_.time);
  }
  void TickWithoutNavigation(double seconds) {
    link_.time += Seconds(seconds);
    app_.Tick(link_.time);
  }
  void Nav(double north, double east, double down, std::optional<double> altitude) {
    nav_ = NavState{.north = north, .east = east, .down = down, .altitude = altitude};
    link_.Send(app_, topics::kNavState, *nav_);
  }
  std::string Phase() { return link_.Last(topics::kSurveyPhase).value_or("IDLE"); }
  void ReachSurvey(double north = -12.0) {
    Nav(north, -15.0, 0.0, 7.5);
    link_.Send(app_, topics::kDeploy, true);
    Tick(SurveyApp::Params{}.align.value() + 1.0);
    Nav(north, -15.0, 3.5, 4.0);
    Tick(1.0);
  }
  /// The map says that one sees so far.
  void Murk(double reach) {
    LookModel look;
    look.detection.visibility = Meters(reach / HalfRange({.visibility = Meters(1.0)}));
    link_.Send(app_, topics::kMapLook, ToMapLook(look));
  }
  void ReachTarget() { link_.Send(app_, topics::kMapCoverage, Coverage{0.99, 0.99, 0.99}); }

  TestLink link_;
  AppContext context_ = ContextOn(link_);
  SurveyApp app_{context_, OfTable()};
  std::optional<NavState> nav_;
};

}  // namespace limpet
