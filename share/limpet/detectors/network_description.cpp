// SPDX-License-Identifier: MIT
#include "limpet/detectors/network_description.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limpet/core/config.hpp"
#include "limpet/core/folders_above.hpp"
#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Reads keys of one map and remembers which it was asked for.
class Keys {
 public:
  Keys(const YAML::Node& root, std::string file) : root_(root), file_(std::move(file)) {
    if (!root_.IsMap()) Fail(root_, "", "is no list of `key: value`");
  }

  /// Whether the file says it; the key is then known.
  [[nodiscard]] bool Has(const char* key) {
    asked_.insert(key);
    return root_[key].IsDefined();
  }
  template <class T>
  T Get(const char* key) {
    asked_.insert(key);
    const YAML::Node node = root_[key];
    if (!node) Fail(root_, key, "is missing");
    try {
      return node.as<T>();
    } catch (const YAML::Exception&) {
      Fail(node, key, "cannot be read");
    }
  }
  double Number(const char* key, double low, double high) {
    const auto value = Get<double>(key);
    if (!(value >= low && value <= high))
      Fail(root_[key], key, fmt::format("{} is not from {} to {}", value, low, high));
    return value;
  }
  /// Refuses what nobody asked for.
  void Finish() const {
    for (const auto& pair : root_) {
      const auto key = pair.first.as<std::string>();
      if (asked_.contains(key)) continue;
      const std::string nearest = NearestWord(key, {asked_.begin(), asked_.end()});
      Fail(pair.first, key,
           "is no key of a network's file" +
               (nearest.empty() ? std::string() : "; did you mean `" + nearest + "`?"));
    }
  }
  [[noreturn]] void Fail(const YAML::Node& node, const std::string& key,
                         const std::string& text) const {
    throw ConfigError(ConfigProblem{
        .where = {file_, node.IsDefined() ? node.Mark().line + 1 : 0}, .key = key, .text = text});
  }
  [[nodiscard]] YAML::Node operator[](const char* key) const { return root_[key]; }

 private:
  YAML::Node root_;
  std::string file_;
  std::set<std::string> asked_;
};

YAML::Node Load(const fs::path& file) {
  try {
    return YAML::LoadFile(file.string());
  } catch (const YAML::Exception& problem) {
    const int line = problem.mark.is_null() ? 0 : problem.mark.line + 1;
    throw ConfigError(ConfigProblem{
        .where = {file.string(), line}, .key = "", .text = "cannot be read: " + problem.msg});
  }
}

/// All keys of the section or none of it.
std::optional<WitnessWeights> ReadWitnesses(Keys& keys) {
  if (!keys.Has("witnesses_offset")) return std::nullopt;
  constexpr double kMost = 100.0;
  return WitnessWeights{.offset = keys.Number("witnesses_offset", -kMost, kMost),
                        .per_score = keys.Number("witnesses_per_score", 0.0, kMost),
                        .per_color = keys.Number("witnesses_per_color", 0.0, kMost),
                        .per_roundness = keys.Number("witnesses_per_roundness", 0.0, kMost),
                        .shape_found = keys.Number("witnesses_shape_found", -kMost, kMost),
                        .per_shape = keys.Number("witnesses_per_shape", 0.0, kMost)};
}

void CheckColors(const NetworkDescription& made, const Keys& keys) {
  const std::vector<std::string> known = ColorNames();
  if (made.colors.empty()) keys.Fail(keys["colors"], "colors", "names no class");
  for (const std::string& color : made.colors) {
    if (std::ranges::find(known, color) != known.end()) continue;
    const std::string nearest = NearestWord(color, known);
    keys.Fail(keys["colors"], "colors",
              fmt::format("`{}` is no class{}", color,
                          nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest)));
  }
}

}  // namespace

NetworkDescription NetworkDescription::Read(const fs::path& file) {
  Keys keys(Load(file), file.string());
  NetworkDescription made;
  made.weights = file.parent_path() / keys.Get<std::string>("weights");
  made.colors = keys.Get<std::vector<std::string>>("colors");
  made.stride_px = static_cast<int>(keys.Number("stride_px", 1.0, 64.0));
  made.size_unit_px = keys.Number("size_unit_px", 0.1, 10000.0);
  made.input_pixels = keys.Number("input_pixels", 1024.0, 4e6);
  made.confidence_offset = keys.Number("confidence_offset", -100.0, 100.0);
  made.confidence_per_score = keys.Number("confidence_per_score", 0.0, 100.0);
  made.confidence_per_color = keys.Number("confidence_per_color", 0.0, 100.0);
  made.confidence_per_roundness = keys.Number("confidence_per_roundness", 0.0, 100.0);
  made.witnesses = ReadWitnesses(keys);
  keys.Finish();
  CheckColors(made, keys);
  if (!fs::is_regular_file(made.weights)) {
    keys.Fail(keys["weights"], "weights",
              fmt::format("there is no file `{}`", made.weights.string()));
  }
  return made;
}

fs::path FindNetwork(const std::string& named) {
  std::error_code ignored;
  if (fs::is_regular_file(named, ignored)) return named;
  std::vector<fs::path> folders;
  AddFoldersOfProgram(fs::path("share") / "networks", folders);
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / named, ignored)) return folder / named;
  }
  std::string places = "here";
  for (const fs::path& folder : folders)
    places += ", in " + folder.string();
  throw ConfigError(ConfigProblem{
      .where = {}, .key = "network", .text = fmt::format("`{}` is not found {}", named, places)});
}

}  // namespace limpet
