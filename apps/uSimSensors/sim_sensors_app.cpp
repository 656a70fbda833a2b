// SPDX-License-Identifier: MIT
#include "apps/uSimSensors/sim_sensors_app.hpp"

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/sensors/depth_model.hpp"
#include "limpet/sensors/dvl_model.hpp"
#include "limpet/sensors/fog_model.hpp"
#include "limpet/sensors/gps_model.hpp"
#include "limpet/sensors/imu_model.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr Seconds kLongestDelay(0.25);  ///< real time

SoundScene SceneOf(const Scenario& scenario, const std::string& session) {
  std::vector<SoundScene::Sphere> spheres;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto center_W = opi.Place(session)) spheres.push_back({*center_W, opi.radius_m});
  }
  return {[seabed = Seabed(scenario.seabed)](double north, double east) {
            return seabed.Depth(north, east);
          },
          std::move(spheres)};
}

ImuModel::Params ImuOf(const Scenario::Sensors& sensors) {
  ImuModel::Params params;
  params.heading_sigma_rad = RadiansFromDegrees(sensors.heading_sigma_deg);
  return params;
}

FogModel::Params FogOf(const Scenario::Sensors& sensors) {
  FogModel::Params params;
  params.bias_sigma_radps = RadiansFromDegrees(sensors.yaw_bias_deg_per_h) / 3600.0;
  return params;
}

DvlModel::Params DvlOf(const Scenario::Sensors& sensors) {
  DvlModel::Params params;
  params.dropout_per_min = sensors.dvl_dropout_per_min;
  params.outlier_share = sensors.dvl_outlier_share;
  return params;
}

GpsModel::Params GpsOf(const Scenario::Sensors& sensors, const VehicleParams& vehicle) {
  GpsModel::Params params;
  params.sigma_m = sensors.gps_sigma_m;
  params.antenna_B = vehicle.antenna_B;
  return params;
}

}  // namespace

SimSensorsApp::SimSensorsApp(const AppContext& context, const Params& params)
    : SimSensorsApp(context, LoadScenario(context.mission_folder / params.scenario)) {}

SimSensorsApp::SimSensorsApp(const AppContext& context, const Scenario& scenario)
    : App(context),
      longest_delay_(kLongestDelay * ParseNumber(context.Global("MOOSTimeWarp")).value_or(1.0)) {
  const Scenario::Sensors& sensors = scenario.sensors;
  Add(topics::kImuData, Hertz(50.0), ImuModel(ImuOf(sensors), MakeRandom("imu")));
  Add(topics::kFogYawRate, Hertz(50.0), FogModel(FogOf(sensors), MakeRandom("fog")));
  Add(topics::kDepthSensor, Hertz(20.0), DepthModel({}, MakeRandom("depth")));
  Add(topics::kDvlData, Hertz(5.0),
      DvlModel(DvlOf(sensors), SceneOf(scenario, context.session), MakeRandom("dvl")));
  const VehicleFile vehicle =
      LoadMissionVehicle(context.Global(kVehicleFileGlobal), context.mission_folder);
  Add(topics::kGpsData, Hertz(1.0), GpsModel(GpsOf(sensors, vehicle.params), MakeRandom("gps")));
  Subscribe(topics::kSimTruth, &SimSensorsApp::OnTruth);
}

void SimSensorsApp::OnTruth(const Stamped<SimTruth>& truth) {
  // A sensor measures now: what was held up while there was no database is nobody's measurement.
  if (context().runs_live && now() - truth.time > longest_delay_) {
    return;
  }
  for (const auto& sensor : sensors_)
    sensor(truth);
}

void SimSensorsApp::Report(ReportLines& report) const {
  ReportTable table({"sensor", ">rate [Hz]", ">samples"});
  for (const Count& count : counts_) {
    table.AddRow(
        {count.variable, fmt::format("{:g}", count.rate.value()), std::to_string(count.samples)});
  }
  report.Add(table);
}

LIMPET_REGISTER_APP(SimSensorsApp, "uSimSensors", 1.0);

}  // namespace limpet
