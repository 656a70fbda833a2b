// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/pNodeReporter/node_reporter_params.hpp"
#include "apps/pNodeReporter/node_rider.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/geodesy.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

/// Says where the vehicle is and what its helm does: NODE_REPORT_LOCAL, which viewers and other
/// vehicles read. Silent until the position is known. Parameters are those of MOOS's app of this
/// name.
class NodeReporterApp final : public App {
 public:
  using Params = NodeReporterParams;

  /// Throws ConfigError if LatOrigin or LongOrigin is no number or lies off the earth, and for a
  /// rider or aspect that is none.
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
  void ReadExtras();
  void SubscribeToExtras();
  void OnAlternative(const std::string& what, double value, Seconds time);
  [[nodiscard]] std::string ModeAt(Seconds now) const;
  [[nodiscard]] NodeReport ReportAt(Seconds now) const;
  /// The second position, if it is known and fresh.
  [[nodiscard]] std::optional<NodeReport> AlternativeAt(Seconds now) const;
  [[nodiscard]] std::string ExtrasAt(Seconds now);
  void Post(const NodeReport& report, const std::string& extras);

  Params params_;
  std::optional<LocalGrid> grid_;
  std::optional<double> x_, y_, speed_, heading_, depth_, yaw_;
  std::optional<Stamped<double>> altitude_;
  std::optional<Seconds> last_nav_, last_helm_, last_report_;
  std::string helm_state_, allstop_, mode_;
  bool has_asked_for_mode_ = false;
  std::vector<NodeRider> riders_;
  NodeReport alternative_;
  bool has_alternative_x_ = false, has_alternative_y_ = false;
  std::optional<Seconds> last_alternative_;
  int reports_ = 0;
};

}  // namespace limpet
