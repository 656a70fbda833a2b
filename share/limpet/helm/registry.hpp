// SPDX-License-Identifier: MIT
// Behaviors by name. Last line of each BHV_*.cpp:  LIMPET_REGISTER_BEHAVIOR(BHV_HoldAltitude);
#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "limpet/core/described_params.hpp"
#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/common_settings.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {

struct BehaviorEntry {
  std::function<std::vector<ParamSpec>()> describe;  ///< their `set` must not be called
  std::function<std::unique_ptr<Behavior>(const ConfigBlock&)> create;
};

[[nodiscard]] std::map<std::string, BehaviorEntry>& BehaviorRegistry();

/// True; for a class that cannot be a behavior the compiler says what it lacks.
template <class B>
[[nodiscard]] consteval bool IsBehaviorKind() {
  static_assert(std::derived_from<B, Behavior>,
                "a behavior derives from limpet::Behavior: "
                "`class BHV_HoldAltitude final : public Behavior`");
  static_assert(HasParams<B>, "a behavior has a public `struct Params`, empty if it needs none");
  static_assert(!HasParams<B> || HasDescribedParams<B>,
                "a behavior's Params has a default for each member, and declares it in "
                "`template <class Visitor> void Describe(Visitor& visit)`");
  static_assert(!std::is_abstract_v<B>,
                "a behavior defines every pure virtual function that it inherits or declares");
  if constexpr (HasParams<B> && !std::is_abstract_v<B>) {
    static_assert(std::constructible_from<B, const typename B::Params&>,
                  "a behavior has a public constructor "
                  "`explicit BHV_HoldAltitude(const Params& params)`");
  }
  return true;
}

template <class B>
[[nodiscard]] BehaviorEntry MakeBehaviorEntry() {
  static_assert(IsBehaviorKind<B>());
  return {.describe =
              [] {
                typename B::Params defaults;
                return DescribeParams(defaults);
              },
          .create = [](const ConfigBlock& block) -> std::unique_ptr<Behavior> {
            auto behavior =
                std::make_unique<B>(ReadParams<typename B::Params>(block, CommonBehaviorKeys()));
            behavior->SetName(BehaviorNameOf(block));
            return behavior;
          }};
}

}  // namespace limpet

#define LIMPET_REGISTER_BEHAVIOR(Class)                                          \
  static const bool limpet_registered_##Class = [] {                             \
    ::limpet::BehaviorRegistry()[#Class] = ::limpet::MakeBehaviorEntry<Class>(); \
    return true;                                                                 \
  }()
