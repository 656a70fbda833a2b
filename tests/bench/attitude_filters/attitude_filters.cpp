// SPDX-License-Identifier: MIT
// attitude_filters <run.alog> ...: our attitude filter beside the same model on MRPT's
// CKalmanFilterCapable, over the samples of simulated runs: error of roll and pitch against
// SIM_TRUTH from 10 s on, and CPU time per sample (least of 5 rounds).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "estimation/navigation/sensor_beliefs.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "tests/bench/attitude_filters/kalman_capable_attitude.hpp"

namespace limpet {
namespace {

/// An inertial sample, with what else was known and true by then.
struct Sample {
  InertialInput input;
  double fog_rate = 0.0;
  Eigen::Vector3d v_WB_B = Eigen::Vector3d::Zero();
  double true_roll = 0.0, true_pitch = 0.0;
};

std::vector<Sample> SamplesOf(const std::string& file) {
  auto reader = AlogReader::Open(file);
  if (!reader) return {};
  std::vector<Sample> samples;
  Sample known;
  for (AlogEntry entry; reader->Next(entry);) {
    const Value value(std::string(entry.value));
    if (entry.name == topics::kSimTruth.name) {
      const auto truth = TopicCodec<SimTruth>::Decode(value);
      if (truth) known.true_roll = truth->roll, known.true_pitch = truth->pitch;
    } else if (entry.name == topics::kFogYawRate.name && entry.number) {
      known.fog_rate = *entry.number;
    } else if (entry.name == topics::kDvlData.name) {
      const auto ping = TopicCodec<DvlSample>::Decode(value);
      if (ping && ping->u && ping->v && ping->w) known.v_WB_B = {*ping->u, *ping->v, *ping->w};
    } else if (entry.name == topics::kImuData.name) {
      const auto imu = TopicCodec<ImuSample>::Decode(value);
      if (!imu) continue;
      known.input = {.t = entry.time,
                     .force_B = {imu->fx, imu->fy, imu->fz},
                     .rate_B = {imu->p, imu->q, imu->r},
                     .heading = imu->heading};
      samples.push_back(known);
    }
  }
  return samples;
}

struct Tilt {
  double roll = 0.0, pitch = 0.0;
};
using Filter = std::function<Tilt(const Sample&)>;

Filter Ours(const AttitudeParams& params) {
  return [filter = AttitudeFilter(params)](const Sample& sample) mutable {
    filter.AddFogRate(sample.input.t, RadiansPerSecond(sample.fog_rate));
    filter.SetBodyVelocity(sample.v_WB_B);
    static_cast<void>(filter.AddInertial(sample.input));
    return Tilt{filter.estimate()->roll, filter.estimate()->pitch};
  };
}

Filter Mrpts(const AttitudeParams& params, mrpt::bayes::TKFMethod method) {
  auto filter = std::make_shared<KalmanCapableAttitude>(params, method);
  return [filter](const Sample& sample) {
    filter->AddFogRate(sample.fog_rate);
    filter->SetBodyVelocity(sample.v_WB_B);
    filter->AddInertial(sample.input);
    return Tilt{filter->roll(), filter->pitch()};
  };
}

void Measure(const char* name, const std::vector<Sample>& samples,
             const std::function<Filter()>& make) {
  constexpr double kSettled = 10.0;  // [s]
  constexpr int kRounds = 5;
  double least = 1e9, squares = 0.0, worst = 0.0;
  std::size_t count = 0;
  for (int round = 0; round < kRounds; ++round) {
    Filter filter = make();
    squares = worst = 0.0, count = 0;
    const double start = ThreadTime().value();
    for (const Sample& sample : samples) {
      const Tilt tilt = filter(sample);
      if (sample.input.t < samples.front().input.t + kSettled) continue;
      const double roll = tilt.roll - sample.true_roll, pitch = tilt.pitch - sample.true_pitch;
      squares += roll * roll + pitch * pitch;
      worst = std::max({worst, std::abs(roll), std::abs(pitch)});
      count += 2;
    }
    least = std::min(least, ThreadTime().value() - start);
  }
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  fmt::print("  {:<22} rms {:.5f} deg, worst {:.5f} deg, {:.0f} ns per sample\n", name,
             std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1))) * kDegrees,
             worst * kDegrees, 1e9 * least / static_cast<double>(samples.size()));
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  using namespace limpet;
  const AttitudeParams params = BelievedAttitude(SensorSheets{});
  for (int i = 1; i < argc; ++i) {
    const std::vector<Sample> samples = SamplesOf(argv[i]);
    fmt::print("{}: {} samples\n", argv[i], samples.size());
    if (samples.empty()) return 1;
    Measure("AttitudeFilter", samples, [&] { return Ours(params); });
    Measure("MRPT kfEKFNaive", samples, [&] { return Mrpts(params, mrpt::bayes::kfEKFNaive); });
    Measure("MRPT kfEKFAlaDavison", samples,
            [&] { return Mrpts(params, mrpt::bayes::kfEKFAlaDavison); });
    Measure("MRPT kfIKFFull", samples, [&] { return Mrpts(params, mrpt::bayes::kfIKFFull); });
  }
  return 0;
}
