// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_folder.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <fmt/format.h>

#include "limpet/durable/durable_file.hpp"

namespace limpet {

std::string LogFolderStamp(Seconds utc, bool is_local) {
  const std::time_t at = static_cast<std::time_t>(std::clamp(utc.value(), 0.0, 2.5e11));
  std::tm parts{};
  is_local ? ::localtime_r(&at, &parts) : ::gmtime_r(&at, &parts);
  return fmt::format("{}_{}_{}_____{:02}_{:02}_{:02}", parts.tm_mday, parts.tm_mon + 1,
                     parts.tm_year + 1900, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

Expected<std::filesystem::path> CreateLogFolder(const std::filesystem::path& parent,
                                                const std::string& stem, FileSystem& disk) {
  constexpr int kMostTries = 100'000;
  if (const std::optional<Error> error = CreateFolders(parent, disk)) {
    return *error;
  }
  std::error_code failure = std::make_error_code(std::errc::file_exists);
  for (int i = 1; i < kMostTries && failure == std::errc::file_exists; ++i) {
    std::filesystem::path folder = parent / (i == 1 ? stem : fmt::format("{}_{}", stem, i));
    failure = disk.CreateFolder(folder);
    if (!failure) {
      failure = disk.SyncFolder(parent);
    }
    if (!failure) {
      return folder;
    }
  }
  return Error{
      fmt::format("`{}` cannot be created: {}", (parent / stem).string(),
                  failure == std::errc::file_exists ? "too many of that name" : failure.message())};
}

}  // namespace limpet
