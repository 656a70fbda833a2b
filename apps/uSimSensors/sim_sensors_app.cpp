// SPDX-License-Identifier: MIT
#include "apps/uSimSensors/sim_sensors_app.hpp"

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/sensors/depth_model.hpp"
#include "limpet/sensors/dvl_model.hpp"
#include "limpet/sensors/faulty_sensor.hpp"
#include "limpet/sensors/fog_model.hpp"
#include "limpet/sensors/gps_model.hpp"
#include "limpet/sensors/imu_model.hpp"
#include "limpet/sensors/sonar_model.hpp"
#include "limpet/sensors/true_sheets.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr Seconds kLongestDelay(0.25);  ///< real time

SoundScene SceneOf(const Scenario& scenario, const std::string& session) {
  std::vector<SoundScene::Sphere> spheres;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto center_W = opi.Place(session)) spheres.push_back({*center_W, opi.radius_m});
  }
  return {
      [seabed = Seabed(scenario.seabed)](const Eigen::Vector2d& p_W) { return seabed.Depth(p_W); },
      std::move(spheres), BodiesOf(scenario)};
}

ImuModel::Params ImuOf(const ImuSheet& sheet, const Scenario::Sensors& truth,
                       const SimulatedErrors::Imu& errors) {
  ImuModel::Params params{.sheet = TrueSheet(sheet, errors.sheet)};
  params.compass = errors.compass;
  params.gyro = errors.gyro;
  if (truth.heading_sigma_deg) {
    params.sheet.heading_sigma = Radians::FromTextUnit(*truth.heading_sigma_deg);
  }
  return params;
}

FogSheet FogOf(const FogSheet& said, const Scenario::Sensors& truth,
               const SheetErrorParams& error) {
  FogSheet sheet = TrueSheet(said, error);
  sheet.bias_deg_per_h = truth.yaw_bias_deg_per_h.value_or(sheet.bias_deg_per_h);
  return sheet;
}

DvlModel::Params DvlOf(const DvlSheet& sheet, const Scenario::Sensors& truth,
                       const SimulatedErrors::Dvl& errors) {
  DvlModel::Params params{.sheet = sheet};
  params.dropout_per_min = truth.dvl_dropout_per_min;
  params.outlier_share = truth.dvl_outlier_share;
  params.error = errors;
  return params;
}

}  // namespace

SimSensorsApp::SimSensorsApp(const AppContext& context, const Params& params)
    : SimSensorsApp(context, LoadScenario(context.mission_folder / params.scenario)) {}

SimSensorsApp::SimSensorsApp(const AppContext& context, const Scenario& scenario)
    : App(context),
      faults_(scenario.faults),
      longest_delay_(kLongestDelay * ParseNumber(context.Global("MOOSTimeWarp")).value_or(1.0)) {
  const VehicleFile vehicle =
      LoadMissionVehicle(context.Global(kVehicleFileGlobal), context.mission_folder);
  const SensorSheets& sheets = vehicle.sensors;
  const Scenario::Sensors& truth = scenario.sensors;
  const SimulatedErrors& errors = scenario.errors;
  AddAttitudeSensors(scenario, sheets);
  Add(topics::kDepthSensor, sheets.depth.rate, errors.depth.stamps,
      DepthModel(TrueSheet(sheets.depth, errors.depth.sheet), MakeRandom("depth"),
                 errors.depth.pressure),
      [sensor = FaultySensor<double>("depth")](double depth, const FaultSchedule& faults) mutable {
        return sensor.Pass(WithDepthFault(depth, faults), faults);
      });
  Add(topics::kDvlData, sheets.dvl.rate, errors.dvl.stamps,
      DvlModel(DvlOf(sheets.dvl, truth, errors.dvl), SceneOf(scenario, context.session),
               MakeRandom("dvl"), MakeRandom("dvl errors")),
      [sensor = FaultyDvl(MakeRandom("dvl faults"))](const DvlSample& sample,
                                                     const FaultSchedule& faults) mutable {
        return sensor.Pass(sample, faults);
      });
  Add(topics::kGpsData, sheets.gps.rate, errors.gps.stamps,
      GpsModel({.sheet = sheets.gps,
                .true_sigma_m = truth.gps_sigma_m,
                .antenna_B = vehicle.params.antenna_B,
                .error = errors.gps.multipath},
               MakeRandom("gps"), MakeRandom("gps errors")),
      [sensor = FaultySensor<GpsFix>("gps")](const GpsFix& fix,
                                             const FaultSchedule& faults) mutable {
        return sensor.Pass(WithGpsFault(fix, faults), faults);
      });
  if (sheets.sonar.is_present) {
    Add(topics::kObstacleSonar, sheets.sonar.rate, {},
        SonarModel(sheets.sonar, SceneOf(scenario, context.session), MakeRandom("sonar")),
        [sensor = FaultySensor<SonarPing>("sonar")](const SonarPing& ping,
                                                    const FaultSchedule& faults) mutable {
          return sensor.Pass(ping, faults);
        });
  }
  for (const std::string& variable : faults_.Variables()) {
    SubscribeRaw(variable, [this](const MessagePtr& message) {
      faults_.Hear(message->name, message->value);
    });
  }
  Subscribe(topics::kSimTruth, &SimSensorsApp::OnTruth);
}

void SimSensorsApp::AddAttitudeSensors(const Scenario& scenario, const SensorSheets& sheets) {
  const Scenario::Sensors& truth = scenario.sensors;
  const SimulatedErrors& errors = scenario.errors;
  if (sheets.imu.is_present) {
    Add(topics::kImuData, sheets.imu.rate, errors.imu.stamps,
        ImuModel(ImuOf(sheets.imu, truth, errors.imu), MakeRandom("imu"), MakeRandom("imu errors")),
        [sensor = FaultyImu(MakeRandom("imu faults"))](const ImuSample& sample,
                                                       const FaultSchedule& faults) mutable {
          return sensor.Pass(sample, faults);
        });
  }
  if (sheets.fog.is_present) {
    Add(topics::kFogYawRate, sheets.fog.rate, errors.fog.stamps,
        FogModel(FogOf(sheets.fog, truth, errors.fog.sheet), MakeRandom("fog"), errors.fog.gyro),
        [sensor = FaultySensor<double>("fog")](double rate, const FaultSchedule& faults) mutable {
          return sensor.Pass(rate, faults);
        });
  }
}

void SimSensorsApp::OnTruth(const Stamped<SimTruth>& truth) {
  // A sensor measures now: what was held up while there was no database is nobody's measurement.
  if (context().runs_live && now() - truth.time > longest_delay_) {
    return;
  }
  faults_.Update(truth.time);
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
