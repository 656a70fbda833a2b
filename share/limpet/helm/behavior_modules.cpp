// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_modules.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <fmt/format.h>

#include "limpet/helm/behavior_abi.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = LIMPET_BEHAVIOR_ABI_MARK;
constexpr std::string_view kMarkStart = "LIMPET_BEHAVIOR_ABI ";
constexpr std::string_view kPrefix = "lib";
constexpr std::string_view kSuffix = ".so";

/// What the object says it was built against; empty if it says nothing. It is read and not loaded:
/// an object of another version must not get to run its initialisers.
std::string MarkIn(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(input), {}};
  const std::size_t at = bytes.find(kMarkStart);
  return at == std::string::npos ? "" : std::string(bytes.c_str() + at);
}

std::string BehaviorIn(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
}

bool IsModule(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with("libBHV_") && name.ends_with(kSuffix);
}

std::vector<fs::path> ModulesIn(const fs::path& folder, const ConfigEntry& line) {
  std::error_code failure;
  std::vector<fs::path> modules;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::end(entry);
       entry.increment(failure)) {
    if (IsModule(entry->path())) {
      modules.push_back(fs::weakly_canonical(entry->path()));
    }
  }
  if (failure) {
    throw ConfigError(
        {line.where, line.key, fmt::format("`{}`: {}", folder.string(), failure.message())});
  }
  std::ranges::sort(modules);
  return modules;
}

/// Why an object is refused; empty once it is loaded.
std::string Load(const fs::path& file) {
  const std::string behavior = BehaviorIn(file);
  if (const std::string mark = MarkIn(file); mark != kMark) {
    return fmt::format("was built against {}; this program takes `{}`: build it again",
                       mark.empty() ? "something that is no Limpet" : "`" + mark + "`", kMark);
  }
  if (BehaviorRegistry().contains(behavior)) {
    return fmt::format("there is a behavior `{}` already: call yours something else", behavior);
  }
  if (::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr) {
    const char* why = ::dlerror();  // NOLINT(concurrency-mt-unsafe): no thread loads beside it
    return why == nullptr ? "cannot be loaded" : why;
  }
  return BehaviorRegistry().contains(behavior)
             ? ""
             : fmt::format("has no LIMPET_REGISTER_BEHAVIOR({})", behavior);
}

void LoadOnce(const fs::path& file, const ConfigEntry& line) {
  static std::set<fs::path> loaded;
  if (loaded.contains(file)) {
    return;
  }
  if (const std::string trouble = Load(file); !trouble.empty()) {
    throw ConfigError({line.where, line.key, fmt::format("{}: {}", file.string(), trouble)});
  }
  loaded.insert(file);
}

void LoadAll(const ConfigEntry& line, const fs::path& from) {
  for (const std::string& folder : Split(line.value, ':')) {
    if (folder.empty()) {
      continue;
    }
    for (const fs::path& file : ModulesIn(from / folder, line)) {
      LoadOnce(file, line);
    }
  }
}

}  // namespace

void LoadBehaviorModules(std::span<const ConfigEntry> lines, const fs::path& mission_folder) {
  for (const ConfigEntry& line : lines) {
    LoadAll(line, mission_folder);
  }
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it
  if (const char* folders = std::getenv(kBehaviorPathVariable)) {
    LoadAll({.key = kBehaviorPathVariable, .value = folders, .where = {.file = "environment"}},
            fs::current_path());
  }
}

}  // namespace limpet
