// SPDX-License-Identifier: MIT
// Behaviors by name. Last line of each BHV_*.cpp:  LIMPET_REGISTER_BEHAVIOR(BHV_HoldAltitude);
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

struct BehaviorEntry {
  std::function<std::vector<ParamSpec>()> describe;  ///< their `set` must not be called
  std::function<std::unique_ptr<Behavior>(const ConfigBlock&)> create;
};

[[nodiscard]] std::map<std::string, BehaviorEntry>& BehaviorRegistry();

/// Keys of every behavior; the host reads them.
[[nodiscard]] const std::vector<std::string>& CommonBehaviorKeys();

template <class B>
[[nodiscard]] BehaviorEntry MakeBehaviorEntry() {
  return {.describe =
              [] {
                typename B::Params defaults;
                return DescribeParams(defaults);
              },
          .create = [](const ConfigBlock& block) -> std::unique_ptr<Behavior> {
            return std::make_unique<B>(ReadParams<typename B::Params>(block, CommonBehaviorKeys()));
          }};
}

}  // namespace limpet

#define LIMPET_REGISTER_BEHAVIOR(Class)                                          \
  static const bool limpet_registered_##Class = [] {                             \
    ::limpet::BehaviorRegistry()[#Class] = ::limpet::MakeBehaviorEntry<Class>(); \
    return true;                                                                 \
  }()
