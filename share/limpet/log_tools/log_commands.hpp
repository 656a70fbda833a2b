// SPDX-License-Identifier: MIT
// The commands of `limpet log`; each reads its log once, line by line.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace limpet {

struct LogCommand {
  const char* name;
  const char* summary;
  const char* help;
  /// `args` without the command's name. Throws UsageError, Refusal, std::runtime_error.
  int (*run)(std::span<const std::string> args);
};

extern const LogCommand kLogScan;
extern const LogCommand kLogStat;
extern const LogCommand kLogGrep;
extern const LogCommand kLogClip;
extern const LogCommand kLogCsv;
extern const LogCommand kLogRecover;

}  // namespace limpet
