// SPDX-License-Identifier: MIT
#include "limpet/runs/run_configuration.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/durable/durable_file.hpp"
#include "limpet/mission/expectations.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/mission_lines.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/runs/written_files.hpp"
#include "limpet/session/checksum.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfigurationFormat = "limpet-configuration-1";
constexpr const char* kProgramPart = "the program";
constexpr const char* kOptionsPart = "the options";
constexpr std::string_view kExpanded = " with its plugs and macros";

std::string ChecksumOfFile(const fs::path& file) {
  const Expected<std::string> bytes = ReadWhole(file);
  if (!bytes) throw std::runtime_error(fmt::format("cannot read {}", file.string()));
  return ChecksumOf(*bytes);
}

bool IsReadByNoRun(const fs::path& relative) {
  static const std::set<std::string> pictures{".md", ".png", ".jpg", ".svg", ".txt", ".pdf"};
  const bool is_hidden = std::ranges::any_of(
      relative, [](const fs::path& part) { return part.string().starts_with("."); });
  const std::string name = relative.filename().string();
  return is_hidden || name.ends_with("~") || IsExpectationsFile(relative) ||
         pictures.contains(relative.extension().string());
}

void AddFiles(const fs::path& folder, RunConfiguration& to) {
  for (fs::recursive_directory_iterator it(folder), end; it != end; ++it) {
    const fs::directory_entry& entry = *it;
    const fs::path relative = entry.path().lexically_relative(folder);
    if (entry.is_directory() && fs::exists(entry.path() / WrittenFiles::kFile)) {
      it.disable_recursion_pending();  // a run that lies in its mission's folder
      continue;
    }
    if (!entry.is_regular_file() || IsReadByNoRun(relative)) continue;
    to.parts[relative.generic_string()] = ChecksumOfFile(entry.path());
  }
}

/// Expanded lines; none of a file that is no mission: whoever runs it complains.
std::vector<TextLine> LinesOf(const fs::path& file) {
  try {
    std::vector<ConfigProblem> ignored;
    return ConfigLines(ReadTextFile(file), file, MissionPlugOptions(file), ignored);
  } catch (const ConfigError&) {
    return {};
  }
}

/// Fragments from outside of the folder: the files that lines of the expanded text come from. One
/// that only defines macros leaves no line; then the expanded text differs.
void AddPlugs(const fs::path& folder, const fs::path& file, RunConfiguration& to) {
  std::set<std::string> sources;
  std::string expanded;
  for (const TextLine& line : LinesOf(file)) {
    sources.insert(line.where.file);
    expanded += line.text + "\n";
  }
  for (const std::string& source : sources) {
    const fs::path relative = fs::path(source).lexically_relative(folder);
    const bool is_outside = relative.empty() || *relative.begin() == "..";
    if (!is_outside || !fs::is_regular_file(source)) continue;
    to.parts[fs::path(source).filename().string()] = ChecksumOfFile(source);
  }
  to.parts[file.filename().string().append(kExpanded)] = ChecksumOf(expanded);
}

/// The files of facts that the mission names, or an option such as `VehicleFile=`, and those they
/// are based on.
void AddFacts(const FactFile& kind, const fs::path& folder, const std::vector<std::string>& options,
              RunConfiguration& to) {
  std::vector<std::string> named;
  for (const TextLine& line : LinesOf(folder / "mission.moos")) {
    const KeyValue pair = SplitKeyValue(line.text);
    if (EqualsIgnoringCase(pair.key, kind.global)) named.push_back(pair.value);
  }
  for (const std::string& option : options) {
    const std::string setting = option.substr(option.rfind(' ') + 1);
    const std::size_t value = setting.rfind('=');
    if (value != std::string::npos && setting.find(kind.global) != std::string::npos) {
      named.push_back(setting.substr(value + 1));
    }
  }
  for (const std::string& name : named) {
    for (const fs::path& file : FactFileChain(kind, FindFactFile(kind, name, folder))) {
      to.parts[file.filename().string()] = ChecksumOfFile(file);
    }
  }
}

/// Of a file that differs itself, what it expands to need not be named.
bool IsToldAlready(const std::string& name, const RunConfiguration& before,
                   const RunConfiguration& now) {
  if (!name.ends_with(kExpanded)) return false;
  const std::string file = name.substr(0, name.size() - kExpanded.size());
  const auto old = before.parts.find(file), present = now.parts.find(file);
  if (old == before.parts.end() || present == now.parts.end()) return true;
  return old->second != present->second;
}

}  // namespace

RunConfiguration RunConfiguration::Of(const fs::path& mission_folder,
                                      const std::vector<std::string>& options) {
  RunConfiguration configuration;
  AddFiles(mission_folder, configuration);
  for (const auto& entry : fs::directory_iterator(mission_folder)) {
    const fs::path extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".moos" || extension == ".bhv")) {
      AddPlugs(mission_folder, entry.path(), configuration);
    }
  }
  for (const FactFile* kind : FactFiles())
    AddFacts(*kind, mission_folder, options, configuration);
  configuration.parts[kOptionsPart] = fmt::format("{}", fmt::join(options, " "));
  configuration.parts[kProgramPart] = ChecksumOfFile("/proc/self/exe");
  return configuration;
}

std::string RunConfiguration::Text() const {
  const nlohmann::ordered_json json{
      {"format", kConfigurationFormat},
      {"about", "what the runs in this folder were made with; only equal ones are put together"},
      {"parts", parts}};
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Expected<RunConfiguration> RunConfiguration::FromText(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.at("format") != kConfigurationFormat) return Error{"of another format"};
    return RunConfiguration{json.at("parts").get<std::map<std::string, std::string>>()};
  } catch (const nlohmann::json::exception& error) {
    return Error{error.what()};
  }
}

std::vector<std::string> DifferencesBetween(const RunConfiguration& before,
                                            const RunConfiguration& now) {
  std::vector<std::string> differences;
  for (const auto& [name, sum] : before.parts) {
    if (IsToldAlready(name, before, now)) continue;
    const auto found = now.parts.find(name);
    if (found == now.parts.end()) {
      differences.push_back(name + " is gone");
    } else if (found->second != sum && name == kOptionsPart) {
      differences.push_back(fmt::format("the options were `{}`", sum));
    } else if (found->second != sum) {
      differences.push_back(name + " has changed");
    }
  }
  for (const auto& [name, sum] : now.parts) {
    const bool is_told = IsToldAlready(name, before, now);
    if (!is_told && !before.parts.contains(name)) differences.push_back(name + " is new");
  }
  return differences;
}

}  // namespace limpet
