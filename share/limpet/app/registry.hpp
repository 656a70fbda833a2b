// SPDX-License-Identifier: MIT
// Apps by name. An app registers itself with one line at the end of its .cpp:
// LIMPET_REGISTER_APP(NavApp, "pNav", 10.0)
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
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

/// Keys that MOOS gives every app; the runner reads them, apps do not.
[[nodiscard]] const std::vector<std::string>& CommonAppKeys();

/// Problems of the keys that MOOS gives every app: AppTick, the reports' limits.
[[nodiscard]] std::vector<ConfigProblem> CheckCommonAppKeys(const ConfigBlock& block);

template <class A>
[[nodiscard]] AppEntry MakeAppEntry(double default_tick_hz) {
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
      .replays_mail = requires {A::kReplaysMail;
}
};  // namespace limpet
}

}  // namespace limpet

/// Makes an app known under its process name, with its default AppTick [Hz].
#define LIMPET_REGISTER_APP(Class, process_name, default_tick_hz)                           \
  static const bool limpet_registered_##Class = [] {                                        \
    ::limpet::AppRegistry()[process_name] = ::limpet::MakeAppEntry<Class>(default_tick_hz); \
    return true;                                                                            \
  }()
