// SPDX-License-Identifier: MIT
// Apps by name. An app registers itself with one line at the end of its .cpp:
// LIMPET_REGISTER_APP(NavApp, "pNav", 10.0)
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/app_keys.hpp"
#include "limpet/core/described_params.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

struct AppEntry {
  double default_tick_hz = 4.0;
  std::function<std::vector<ParamSpec>()>
      describe;  ///< names, units, defaults; their `set` must not be called
  std::function<std::unique_ptr<App>(const AppContext&, const ConfigBlock&)> create;
  /// Every problem of a block, without building the app.
  std::function<std::vector<ConfigProblem>(const ConfigBlock&)> check;
  /// Command-line switches of this app alone, and the key that each adds a line of to its block.
  std::map<std::string, std::string> switches{};
  /// Its state is a function of its mail and worth much: started again, it goes through the mail of
  /// its former life (mail_journal.hpp).
  bool replays_mail = false;
};

/// The one singleton: filled before main by the registration lines.
[[nodiscard]] std::map<std::string, AppEntry>& AppRegistry();

/// Problems of the keys that MOOS gives every app: AppTick, the reports' limits.
[[nodiscard]] std::vector<ConfigProblem> CheckCommonAppKeys(const ConfigBlock& block);

/// True; for a class that cannot be an app the compiler says what it lacks.
template <class A>
[[nodiscard]] consteval bool IsAppKind() {
  static_assert(std::derived_from<A, App>,
                "an app derives from limpet::App: `class NavApp final : public App`");
  static_assert(HasParams<A>, "an app has a public `struct Params`, empty if it needs none");
  static_assert(!HasParams<A> || HasDescribedParams<A>,
                "an app's Params has a default for each member, and declares it in "
                "`template <class Visitor> void Describe(Visitor& visit)`");
  static_assert(!std::is_abstract_v<A>,
                "an app defines every pure virtual function that it inherits or declares");
  if constexpr (HasParams<A> && !std::is_abstract_v<A>) {
    static_assert(std::constructible_from<A, const AppContext&, const typename A::Params&>,
                  "an app has a public constructor "
                  "`NavApp(const AppContext& context, const Params& params)`");
  }
  return true;
}

template <class A>
concept ReplaysMail = requires {
  A::kReplaysMail;
};

template <class A>
[[nodiscard]] AppEntry MakeAppEntry(double default_tick_hz) {
  static_assert(IsAppKind<A>());
  return {
      .default_tick_hz = default_tick_hz,
      .describe =
          [] {
            typename A::Params defaults;
            return DescribeParams(defaults);
          },
      .create = [](const AppContext& context, const ConfigBlock& block) -> std::unique_ptr<App> {
        return std::make_unique<A>(context, ReadParams<typename A::Params>(block, CommonAppKeys()));
      },
      .check =
          [](const ConfigBlock& block) {
            typename A::Params params;
            std::vector<ConfigProblem> problems = CheckCommonAppKeys(block);
            std::ranges::move(ApplyBlock(block, DescribeParams(params), CommonAppKeys()),
                              std::back_inserter(problems));
            return problems;
          },
      .replays_mail = ReplaysMail<A>,
  };
}

}  // namespace limpet

/// Makes an app known under its process name, with its default AppTick [Hz].
#define LIMPET_REGISTER_APP(Class, process_name, default_tick_hz)                           \
  static const bool limpet_registered_##Class = [] {                                        \
    ::limpet::AppRegistry()[process_name] = ::limpet::MakeAppEntry<Class>(default_tick_hz); \
    return true;                                                                            \
  }()
