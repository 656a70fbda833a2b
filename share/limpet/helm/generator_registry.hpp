// SPDX-License-Identifier: MIT
// Generators of options by name. Last line of each generators/*.cpp:
//   LIMPET_REGISTER_GENERATOR(BeamGenerator, "beam");
#pragma once

#include <concepts>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/helm/option_generator.hpp"

namespace limpet {

/// The parameters of one generator, and how to build it from them.
class GeneratorPlan {
 public:
  virtual ~GeneratorPlan() = default;
  [[nodiscard]] virtual std::unique_ptr<GeneratorPlan> Clone() const = 0;
  virtual void Describe(ParamCollector& visit) = 0;
  [[nodiscard]] virtual std::unique_ptr<OptionGenerator> Build(const Random& random) const = 0;
};

/// What a class must be to be a generator: an OptionGenerator with a struct `Params` that describes
/// itself, built from these alone or from these and a random stream.
template <class G>
concept BuiltFromParams = std::constructible_from<G, const typename G::Params&> ||
    std::constructible_from<G, const typename G::Params&, Random>;
template <class P>
concept DescribedParams = std::default_initializable<P> && std::copyable<P> &&
    requires(P& params, ParamCollector& visit) {
  params.Describe(visit);
};

template <class G>
class GeneratorPlanOf final : public GeneratorPlan {
 public:
  static_assert(std::is_base_of_v<OptionGenerator, G>, "a generator is an OptionGenerator");
  static_assert(std::is_final_v<G>, "a generator is final: vary it by its parameters");
  static_assert(DescribedParams<typename G::Params>,
                "a generator has a struct Params with Describe(visit)");
  static_assert(BuiltFromParams<G>, "a generator is built from (Params) or (Params, Random)");

  [[nodiscard]] std::unique_ptr<GeneratorPlan> Clone() const override {
    return std::make_unique<GeneratorPlanOf>(*this);
  }
  void Describe(ParamCollector& visit) override { params_.Describe(visit); }
  [[nodiscard]] std::unique_ptr<OptionGenerator> Build(const Random& random) const override {
    if constexpr (std::constructible_from<G, const typename G::Params&, Random>) {
      return std::make_unique<G>(params_, random);
    } else {
      static_cast<void>(random);
      return std::make_unique<G>(params_);
    }
  }

 private:
  typename G::Params params_;
};

using GeneratorMap = std::map<std::string, std::unique_ptr<GeneratorPlan>, std::less<>>;
[[nodiscard]] GeneratorMap& GeneratorRegistry();

/// The names in a list as a mission writes it: `beam, gaps`.
[[nodiscard]] std::vector<std::string> NamesOfGenerators(std::string_view list);
/// The complaint about a name that is not registered.
[[nodiscard]] std::string UnknownGenerator(const std::string& name);

/// The parameters of every registered generator, as part of another struct of parameters: their
/// keys stand in the same block.
class GeneratorParams {
 public:
  GeneratorParams();
  ~GeneratorParams() = default;
  GeneratorParams(const GeneratorParams& other);
  GeneratorParams& operator=(const GeneratorParams& other);
  GeneratorParams(GeneratorParams&&) = default;
  GeneratorParams& operator=(GeneratorParams&&) = default;

  void Describe(ParamCollector& visit);
  /// The generators of `names` (`beam, gaps`), in that order. Throws ConfigError for a name that is
  /// not registered. Each takes a copy of `random`.
  [[nodiscard]] std::vector<std::unique_ptr<OptionGenerator>> Build(std::string_view names,
                                                                    const Random& random) const;

 private:
  GeneratorMap plans_;
};

}  // namespace limpet

#define LIMPET_REGISTER_GENERATOR(Class, name)                                                  \
  static const bool limpet_registered_##Class = [] {                                            \
    ::limpet::GeneratorRegistry()[name] = std::make_unique<::limpet::GeneratorPlanOf<Class>>(); \
    return true;                                                                                \
  }()
