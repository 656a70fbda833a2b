// SPDX-License-Identifier: MIT
// The commands of `limpet log`; each reads its log once, line by line.
#pragma once

#include "limpet/console/command.hpp"

namespace limpet {

struct LogCommand {
  const char* name;
  const char* summary;
  Command (*form)();
  /// Throws UsageError, Refusal, std::runtime_error.
  int (*run)(const Arguments& given);
};

extern const LogCommand kLogScan;
extern const LogCommand kLogStat;
extern const LogCommand kLogGrep;
extern const LogCommand kLogClip;
extern const LogCommand kLogCsv;
extern const LogCommand kLogRecover;
extern const LogCommand kLogRawlog;

}  // namespace limpet
