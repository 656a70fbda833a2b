// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_folder.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <fmt/format.h>

#include "limpet/logbook/append_file.hpp"

namespace limpet {

std::string LogFolderStamp(Seconds utc, bool is_local) {
  const std::time_t at = static_cast<std::time_t>(std::clamp(utc.value(), 0.0, 2.5e11));
  std::tm parts{};
  is_local ? ::localtime_r(&at, &parts) : ::gmtime_r(&at, &parts);
  return fmt::format("{}_{}_{}_____{:02}_{:02}_{:02}", parts.tm_mday, parts.tm_mon + 1,
                     parts.tm_year + 1900, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

Expected<std::filesystem::path> CreateLogFolder(const std::filesystem::path& parent,
                                                const std::string& stem) {
  constexpr int kMostTries = 100'000;
  std::error_code failure;
  std::filesystem::create_directories(parent.empty() ? "." : parent, failure);
  for (int i = 1; i < kMostTries && !failure; ++i) {
    std::filesystem::path folder = parent / (i == 1 ? stem : fmt::format("{}_{}", stem, i));
    if (std::filesystem::create_directory(folder, failure)) {
      SyncFileNames(parent);
      return folder;
    }
  }
  return Error{fmt::format("`{}` cannot be created: {}", (parent / stem).string(),
                           failure ? failure.message() : "too many of that name")};
}

}  // namespace limpet
