// SPDX-License-Identifier: MIT
// Detectors by name. Last line of a detector's .cpp in share/limpet/detectors:
// LIMPET_REGISTER_DETECTOR(ColorShapeDetector, "color_shape");
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/factory_registry.hpp"
#include "limpet/core/params.hpp"
#include "limpet/vision/detector.hpp"

namespace limpet {

/// One registered detector before it exists: holds its parameters while a block is read into them.
class DetectorFactory {
 public:
  virtual ~DetectorFactory() = default;
  /// Declarations whose `set` writes into this factory; valid as long as it lives.
  [[nodiscard]] virtual std::vector<ParamSpec> Parameters() = 0;
  /// A detector with the parameters as they are now. Throws ConfigError if they are impossible.
  [[nodiscard]] virtual std::unique_ptr<Detector> Make() const = 0;
};

/// Every registered name, in alphabetical order.
[[nodiscard]] std::vector<std::string> DetectorNames();

/// A factory with the default parameters; for an unknown name the nearest known one is named.
[[nodiscard]] Expected<std::unique_ptr<DetectorFactory>> FindDetector(const std::string& name);

/// A detector with its default parameters. REQUIRES: the name is registered.
[[nodiscard]] std::unique_ptr<Detector> MakeDetector(const std::string& name);

/// Adds a detector. REQUIRES: the name is new.
void RegisterDetector(const std::string& name,
                      std::function<std::unique_ptr<DetectorFactory>()> make_factory);

template <class D>
class DetectorFactoryOf final : public DetectorFactory {
  static_assert(std::is_base_of_v<Detector, D>, "a detector derives from limpet::Detector");
  static_assert(!std::is_abstract_v<D>, "a detector says what Detect does");
  static_assert(std::is_final_v<D>, "a detector is final: what two share is a class of its own");
  static_assert(
      requires(typename D::Params params, ParamCollector& visit) { params.Describe(visit); },
      "a detector has a struct Params with a template Describe(visit), also if it is empty");
  static_assert(std::is_constructible_v<D, const typename D::Params&>,
                "a detector is made from its Params");

 public:
  [[nodiscard]] std::vector<ParamSpec> Parameters() override { return DescribeParams(params_); }
  [[nodiscard]] std::unique_ptr<Detector> Make() const override {
    return std::make_unique<D>(params_);
  }

 private:
  typename D::Params params_;
};

}  // namespace limpet

/// Makes a detector known under the name that `detector = ...` of pDetect's block gives.
#define LIMPET_REGISTER_DETECTOR(Class, detector_name)                                         \
  static_assert(::limpet::IsLowerCaseName(detector_name), "lower_case words");                 \
  static const bool limpet_registered_##Class = [] {                                           \
    ::limpet::RegisterDetector(                                                                \
        detector_name, [] { return std::make_unique<::limpet::DetectorFactoryOf<Class>>(); }); \
    return true;                                                                               \
  }()
