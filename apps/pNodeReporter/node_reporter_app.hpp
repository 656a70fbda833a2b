// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/app/app.hpp"
#include "limpet/core/geodesy.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

/// Says where the vehicle is and what its helm does: NODE_REPORT_LOCAL, which viewers and other
/// vehicles read. Silent until the position is known. Parameters are those of MOOS's app of this
/// name.
class NodeReporterApp final : public App {
 public:
  struct Params {
    std::string platform_type = "uuv";
    Meters platform_length{1.3};
    Meters platform_beam{0.0};
    std::string platform_color{};
    std::string group{};
    Seconds blackout_interval{0.0};
    Seconds nohelm_threshold{5.0};
    std::string node_report_output = topics::kNodeReportLocal.name;
    bool terse_reports = false;
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("platform_type", platform_type,
            "Body that viewers draw: uuv, kayak, glider, ship, heron, wamv, ...");
      visit("platform_length", platform_length, "Length of the vehicle; 0: not reported",
            InRange(0.0_m, 500.0_m));
      visit("platform_beam", platform_beam, "Beam of the vehicle; 0: not reported",
            InRange(0.0_m, 500.0_m));
      visit("platform_color", platform_color, "Color that viewers draw; empty: theirs");
      visit("group", group, "Group of vehicles that this one belongs to");
      visit("blackout_interval", blackout_interval, "Least time between two reports",
            InRange(0.0_s, 3600.0_s));
      visit("nohelm_threshold", nohelm_threshold, "A helm silent for longer is reported as NOHELM",
            InRange(0.5_s, 600.0_s));
      visit("node_report_output", node_report_output, "Variable of the report");
      visit("terse_reports", terse_reports, "Leave out depth, latitude, longitude and yaw");
    }
  };

  /// Throws ConfigError if LatOrigin or LongOrigin is no number or lies off the earth.
  NodeReporterApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  void OnX(const Stamped<double>& x) { x_ = x.value, last_nav_ = x.time; }
  void OnY(const Stamped<double>& y) { y_ = y.value; }
  void OnSpeed(const Stamped<double>& speed) { speed_ = speed.value; }
  void OnHeading(const Stamped<double>& heading) { heading_ = heading.value; }
  void OnDepth(const Stamped<double>& depth) { depth_ = depth.value; }
  void OnAltitude(const Stamped<double>& altitude) { altitude_ = altitude; }
  void OnYaw(const Stamped<double>& yaw) { yaw_ = yaw.value; }
  void OnHelmState(const Stamped<std::string>& state);
  void OnAllStop(const Stamped<std::string>& allstop) { allstop_ = allstop.value; }
  void OnSummary(const Stamped<std::string>& summary);
  void ReadDatum();
  [[nodiscard]] std::string ModeAt(Seconds now) const;
  [[nodiscard]] NodeReport ReportAt(Seconds now) const;

  Params params_;
  std::optional<LocalGrid> grid_;
  std::optional<double> x_, y_, speed_, heading_, depth_, yaw_;
  std::optional<Stamped<double>> altitude_;
  std::optional<Seconds> last_nav_, last_helm_, last_report_;
  std::string helm_state_, allstop_, mode_;
  bool has_asked_for_mode_ = false;
  int reports_ = 0;
};

}  // namespace limpet
