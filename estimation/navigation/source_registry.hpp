// SPDX-License-Identifier: MIT
// Measurement sources by name. Last line of a source's .cpp in estimation/sources:
// LIMPET_REGISTER_SOURCE(BeaconRange, "beacon_range");
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/source_factory.hpp"
#include "limpet/core/factory_registry.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// Adds a source. REQUIRES: the name is new.
void RegisterSource(const std::string& name,
                    std::function<std::unique_ptr<SourceFactory>()> make_factory);

template <class S>
class SourceFactoryOf final : public SourceFactory {
  static_assert(std::is_base_of_v<MeasurementSource, S>,
                "a source derives from limpet::MeasurementSource");
  static_assert(!std::is_abstract_v<S>,
                "a source says what variable, Observe and Measure, or ReadingOf, do");
  static_assert(std::is_final_v<S>, "a source is final: what two share is a class of its own");
  static_assert(
      requires(typename S::Params params, ParamCollector& visit) { params.Describe(visit); },
      "a source has a struct Params with a template Describe(visit), also if it is empty");
  static_assert(std::is_constructible_v<S, const typename S::Params&>,
                "a source is made from its Params");

 public:
  [[nodiscard]] std::vector<ParamSpec> Parameters() override { return DescribeParams(params_); }
  [[nodiscard]] bool is_of_motion() const override { return std::is_base_of_v<MotionSensor, S>; }
  [[nodiscard]] std::unique_ptr<MeasurementSource> Make() const override {
    return std::make_unique<S>(params_);
  }

 private:
  typename S::Params params_;
};

}  // namespace limpet

/// Makes a source known under the name that `sources = ...` of pNav's block gives, or of a
/// MotionSensor `sensors = ...`.
#define LIMPET_REGISTER_SOURCE(Class, source_name)                                                 \
  static_assert(::limpet::IsLowerCaseName(source_name), "lower_case words");                       \
  static const bool limpet_registered_##Class = [] {                                               \
    ::limpet::RegisterSource(source_name,                                                          \
                             [] { return std::make_unique<::limpet::SourceFactoryOf<Class>>(); }); \
    return true;                                                                                   \
  }()
