// SPDX-License-Identifier: MIT
#include "limpet/core/app_keys.hpp"

namespace limpet {

const std::vector<std::string>& CommonAppKeys() {
  static const std::vector<std::string> keys{"AppTick",
                                             "CommsTick",
                                             "MaxAppTick",
                                             "IterateMode",
                                             "SortMailByTime",
                                             "CatchCommandMessages",
                                             "TERM_REPORT_INTERVAL",
                                             "MAX_APPCAST_EVENTS",
                                             "MAX_APPCAST_RUN_WARNINGS",
                                             "APP_LOGGING",
                                             "COMMS_POLICY",
                                             "DEPRECATED_OK",
                                             "moos_tw_delay_factor"};
  return keys;
}

}  // namespace limpet
