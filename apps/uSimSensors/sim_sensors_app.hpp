// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/sensors/sample_clock.hpp"
#include "limpet/simulation/stamp_error.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {

/// The sensors of the vehicle's file, fed by the truth; where the scenario says how large an error
/// truly is, it is that. A sensor is one file with a model that has
/// `std::optional<T> Sample(const SimTruth&, Seconds)`, and one line in the constructor.
class SimSensorsApp final : public App {
 public:
  struct Params {
    std::string scenario = "scenario.yaml";
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("scenario", scenario, "Truth of the mission, relative to its folder");
    }
  };

  SimSensorsApp(const AppContext& context, const Params& params);
  /// The app with a scenario made in code, in place of the mission's file.
  SimSensorsApp(const AppContext& context, const Scenario& scenario);
  void Report(ReportLines& report) const override;

 private:
  /// `fault` makes of a sample what comes of it, or nothing.
  template <class T, class Model, class Fault>
  void Add(const Topic<T>& topic, Hertz rate, const StampErrorParams& stamps, Model model,
           Fault fault) {
    const std::size_t index = counts_.size();
    counts_.push_back({.variable = topic.name, .rate = rate});
    sensors_.push_back([this, &topic, index, clock = SampleClock(rate),
                        stamp = StampError(stamps, MakeRandom("stamps " + counts_[index].variable)),
                        held = std::deque<std::pair<Seconds, T>>(), model = std::move(model),
                        fault = std::move(fault)](const Stamped<SimTruth>& truth) mutable {
      if (clock.IsDue(truth.time)) {
        std::optional<T> sample = model.Sample(truth.value, truth.time);
        if (sample) sample = fault(*sample, faults_);
        if (sample) held.emplace_back(stamp.StampOf(truth.time), *sample);
      }
      // A driver stamps what it hands on: nothing comes before its stamp.
      while (!held.empty() && held.front().first <= truth.time) {
        ++counts_[index].samples;
        PublishMeasured(topic, held.front().second, held.front().first);
        held.pop_front();
      }
    });
  }
  void OnTruth(const Stamped<SimTruth>& truth);
  void AddAttitudeSensors(const Scenario& scenario, const SensorSheets& sheets);

  struct Count {
    std::string variable;
    Hertz rate;
    int samples = 0;
  };
  FaultSchedule faults_;
  Seconds longest_delay_;      ///< of the truth, in a community (MOOS time)
  std::vector<Count> counts_;  ///< for the report, by sensor
  std::vector<std::function<void(const Stamped<SimTruth>&)>> sensors_;
};

}  // namespace limpet
